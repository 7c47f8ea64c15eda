// Readers of one format each, for picture_file.h, which chooses. Each takes the first picture from `file`: it
// removes that, and what follows unless it is another picture. All throw Refused for what is damaged, and
// note in Picture::unused what the head says and is not used.
#pragma once

#include "tools/picture/picture.h"

#include <string_view>

namespace pictures {

// PNM, grey and RGB, as text or bytes (netpbm's pgm(5) and ppm(5)): P2, P3, P5 and P6, with up to 65535
// steps, which are scaled to 65535 for 1. Numbers above the largest that the head names are refused, as is
// what follows and is no PNM.
bool isPnm(std::string_view file);
Picture takePnm(std::string_view &file);

// Radiance's HDR (Ward, "Real Pixels", Graphics Gems II, 1991): lines of text up to an empty line, a line
// with height and width, then rows of pixels. A row is run-length coded in four planes, or stored pixel by
// pixel, with or without runs of the older kind. All eight orders of rows and pixels are read.
//
// Pixels are divided by every EXPOSURE and COLORCORR in the text, which restores the values before the
// picture was edited; factors of 0, which FreeImage writes, count as 1. CIE XYZ becomes red, green and blue
// with sRGB's primaries, in watts: Radiance keeps XYZ in lumens, 179 to the watt.
inline bool isHdr(std::string_view file) { return file.starts_with("#?"); }
Picture takeHdr(std::string_view &file);

// OpenEXR ("OpenEXR File Layout", openexr.com): one part of lines or tiles (of these the largest level), with
// channels R, G and B, or Y, and perhaps A, of 16 or 32 bits, not compressed or by RLE, ZIPS, ZIP or PIZ.
// They may have the name of a layer, if there is only one with colours; other channels (Z) are not read. The
// picture is the display window, black and clear where there is no data. A file has one picture.
//
// tinyexr decompresses. Its own reader of files is not used: it trusts what damaged ones say, and turns
// pictures upside down whose lines are stored from the bottom.
inline bool isExr(std::string_view file) { return file.starts_with("\x76\x2f\x31\x01"); }
Picture readExr(std::string_view file);

// PNG, JPEG, TGA and BMP by stb_image, with 16 bits where the file has them: up to 2^26 pixels and 256 MB.
// Alpha is left out where TGA counts no bits of it, or BMP has neither a mask nor a later head.
Picture takeByStb(std::string_view &file);

} // namespace pictures
