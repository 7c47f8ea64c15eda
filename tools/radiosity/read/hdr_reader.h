// Reads pictures in Radiance's HDR format (Ward, "Real Pixels", Graphics Gems II, 1991): lines of text up to
// an empty line, a line with height and width, and rows of pixels, each plain or run-length coded in four
// planes.
#pragma once

#include <string>
#include <vector>

namespace odraz {

struct HdrPicture {
    int width, height;
    std::vector<float> pixels; // rows from above to below; red, green, blue
};

// Reads up to 2^27 pixels. Throws Refused.
HdrPicture readHdr(const std::string &path);

} // namespace odraz
