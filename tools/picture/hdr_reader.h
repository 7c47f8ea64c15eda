// Reads pictures in Radiance's HDR format (Ward, "Real Pixels", Graphics Gems II, 1991): lines of text up to
// an empty line, a line with height and width, then rows of pixels. A row is run-length coded in four planes,
// or stored pixel by pixel, with or without runs of the older kind. All eight orders of rows and pixels are
// read.
//
// Pixels are divided by every EXPOSURE and COLORCORR in the text, which restores the values before the
// picture was edited; factors of 0, which FreeImage writes, count as 1. CIE XYZ becomes red, green and blue
// with sRGB's primaries, in watts: Radiance keeps XYZ in lumens, 179 to the watt.
#pragma once

#include "tools/picture/picture.h"

#include <string_view>

namespace pictures {

// Whether such a picture begins here.
inline bool isHdr(std::string_view file) { return file.starts_with("#?"); }

// Reads such a picture and removes it with what follows, unless that is another one. Throws Refused.
Picture takeHdr(std::string_view &file);

} // namespace pictures
