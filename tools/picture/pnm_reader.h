// Reads PNM, grey and RGB, as text or bytes (netpbm's pgm(5) and ppm(5)): P2, P3, P5 and P6, with up to 65535
// steps, which are scaled to 65535 for 1. Numbers above the largest that the head names are refused.
#pragma once

#include "tools/picture/picture.h"

#include <string_view>

namespace pictures {

// Whether PNM of any kind begins here.
bool isPnm(std::string_view file);

// Reads the first picture and removes it. Throws Refused if it is damaged or of another kind, or if something
// else follows it.
Picture takePnm(std::string_view &file);

} // namespace pictures
