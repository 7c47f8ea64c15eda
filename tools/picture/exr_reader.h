// Reads OpenEXR ("OpenEXR File Layout", openexr.com): one part of lines or tiles (of these the largest
// level), with channels R, G and B, or Y, and perhaps A, of 16 or 32 bits, not compressed or by RLE, ZIPS,
// ZIP or PIZ. They may have the name of a layer, if there is only one with colours; other channels (Z) are
// not read. The picture is the display window, black and clear where there is no data.
//
// tinyexr decompresses. Its own reader of files is not used: it trusts what damaged ones say, and turns
// pictures upside down whose lines are stored from the bottom.
#pragma once

#include "tools/picture/picture.h"

#include <string_view>

namespace pictures {

// Whether such a picture begins here.
inline bool isExr(std::string_view file) { return file.starts_with("\x76\x2f\x31\x01"); }

// Throws Refused.
Picture readExr(std::string_view file);

} // namespace pictures
