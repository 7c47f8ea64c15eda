// Reads pictures: PNG, JPEG, TGA, BMP, PNM (P2, P3, P5, P6), Radiance HDR and OpenEXR. The content decides,
// not the name. A file of PNM, PNG or Radiance HDR may hold several, one after the other.
//
// All of it throws Refused: for other formats and for damaged files, for files that end early, for PNM that
// goes on, for pictures of more than 2^27 pixels (2^26 of PNG, JPEG, TGA and BMP), and for floats that are
// not numbers or beyond +-1e12.
#pragma once

#include "tools/picture/picture.h"

namespace pictures {

class PictureFile {
public:
    explicit PictureFile(const std::string &path);
    // What was read already; `name` begins the errors.
    PictureFile(const std::string &name, std::string bytes);

    // Whether there is another picture, or something else.
    bool more() const { return at < bytes.size(); }
    Picture next();

private:
    std::string name, bytes;
    size_t at = 0;
};

// The only picture of a file; or of what was read already.
Picture readPicture(const std::string &path);
Picture readPicture(const std::string &name, std::string bytes);

} // namespace pictures
