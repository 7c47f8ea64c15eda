// Scales a developed picture up to the size that is shown, when it was traced in fewer pixels.
//
// The filter is the interpolating cubic of Catmull and Rom ("A class of local interpolating splines", 1974),
// along rows and then along columns. Alone it would ring: near an edge it overshoots by up to 7 % of the
// step. So each value is clamped to the range of the two pixels that it lies between.
#pragma once

#include "base/parallel.h"

#include <stdint.h>

namespace odraz {

inline constexpr int kMostAcross = 2560; // pixels of a row that enlarge() can make

// Both pictures are sRGB, four bytes a pixel, rows without gaps. `from` is at least 4x4; `to` is no smaller
// in either direction, and 8 to kMostAcross pixels wide. The first pixel and the last two of each row and
// column of `from` are not shown. Up to 32 bytes after `from` are read and ignored. The result does not
// depend on the number of workers.
void enlarge(const uint8_t *from, int width, int height, uint8_t *to, int toWidth, int toHeight,
             Workers &workers);

} // namespace odraz
