// Reads pictures in Radiance's HDR format (Ward, "Real Pixels", Graphics Gems II, 1991): lines of text up to
// an empty line, a line with height and width, and rows of pixels. A row is run-length coded in four planes,
// or pixel by pixel, with or without the older runs. All eight orders of rows and pixels are read.
//
// A pixel is what it was before the picture was edited: it is divided by all EXPOSURE and COLORCORR that the
// text names. CIE XYZ becomes red, green and blue with sRGB's primaries, in watts: Radiance keeps XYZ in
// lumens, 179 to a watt.
#pragma once

#include <string>
#include <vector>

namespace odraz::radiosity {

struct HdrPicture {
    int width, height;
    std::vector<float> pixels; // rows from above to below; linear red, green, blue
};

// Reads up to 2^27 pixels. Throws Refused.
HdrPicture readHdr(const std::string &path);

} // namespace odraz::radiosity
