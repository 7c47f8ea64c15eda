// Reads PNG, JPEG, TGA and BMP by stb_image, with 16 bits where the file has them.
#pragma once

#include "tools/picture/picture.h"

#include <string_view>

namespace pictures {

// Reads up to 2^26 pixels and 256 MB, and removes them with what follows, unless that is another PNG after
// one. Throws Refused.
Picture takeByStb(std::string_view &file);

} // namespace pictures
