// A reader for each format; picture_file.h chooses between them. A reader takes the first picture from
// `file`. It removes that picture's bytes, and also the bytes after it unless they are another picture. All
// readers throw Refused for damaged files, and note the header's unused statements in Picture::unused.
#pragma once

#include "tools/picture/picture.h"

#include <string_view>

namespace pictures {

// PNM (netpbm's pgm(5) and ppm(5)): grey and RGB, as text or bytes: P2, P3, P5 and P6. Values are scaled, so
// that the largest value, up to 65535, becomes 65535. Larger values than the header allows are refused, and
// so are bytes after the picture that are not another PNM.
bool isPnm(std::string_view file);
Picture takePnm(std::string_view &file);

// Radiance HDR (Ward, "Real Pixels", Graphics Gems II, 1991): lines of text up to an empty line, a line with
// height and width, then rows of pixels. A row is run-length coded in four planes, or stored pixel by pixel,
// with or without runs of the older kind. All eight orders of rows and pixels are read.
//
// Pixels are divided by every EXPOSURE and COLORCORR in the text, which restores the values before the
// picture was edited. Factors of 0, which FreeImage writes, count as 1. CIE XYZ is converted to red, green
// and blue with sRGB's primaries, and from Radiance's lumens to watts (179 lumens each).
inline bool isHdr(std::string_view file) { return file.starts_with("#?"); }
Picture takeHdr(std::string_view &file);

// OpenEXR ("OpenEXR File Layout", openexr.com): a single part of lines or tiles (the largest level), without
// compression or with RLE, ZIPS, ZIP or PIZ. The channels are R, G and B, or Y, with or without A, of 16 or
// 32 bits. They may belong to a layer, if it is the only layer with colours. Other channels (Z) are not read.
// The picture is the display window; it is black and transparent where there is no data. A file has one
// picture.
//
// tinyexr decompresses. Its own file reader is not used, since it trusts damaged files, and turns pictures
// upside down whose lines are stored from the bottom.
inline bool isExr(std::string_view file) { return file.starts_with("\x76\x2f\x31\x01"); }
Picture readExr(std::string_view file);

// PNG, JPEG, TGA and BMP by stb_image: up to 2^26 pixels and 256 MB, with 16 bits if the file has them. Alpha
// is dropped if a TGA has no alpha bits, or if a BMP has neither an alpha mask nor a header above 40 bytes.
Picture takeByStb(std::string_view &file);

} // namespace pictures
