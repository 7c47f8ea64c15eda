// Reads pictures: PNG, JPEG, TGA, BMP, PNM (P2, P3, P5, P6), Radiance HDR and OpenEXR. The content decides
// the format, not the name. A file of PNM, PNG or Radiance HDR may have several pictures, one after another.
//
// All functions throw Refused for other formats, for damaged files, for files that end early, for other bytes
// after a PNM, for pictures of more than 2^27 pixels (2^26 for PNG, JPEG, TGA and BMP), and for floats that
// are not numbers or are beyond +-1e12.
#pragma once

#include "tools/picture/picture.h"

namespace pictures {

class PictureFile {
public:
    explicit PictureFile(const std::string &path);
    // Takes the bytes of a file that was already read. Errors begin with `name`.
    PictureFile(const std::string &name, std::string bytes);

    // Returns whether bytes are left: another picture, or anything else.
    bool more() const { return at < bytes.size(); }
    Picture next();

private:
    std::string name, bytes;
    size_t at = 0;
};

// Reads the only picture of a file, or of bytes that were already read.
Picture readPicture(const std::string &path);
Picture readPicture(const std::string &name, std::string bytes);

} // namespace pictures
