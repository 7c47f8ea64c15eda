// Computes pixels from the corners of squares.
#pragma once

#include "trace/picture/tile.h"

namespace odraz {

// Interpolates a square of whole pixels over the pixels that it covers.
void fill(Tile &t, Square q, int size);

// Multiplies every pixel's light by its albedo, and writes the tile to the frame.
void finishTile(Tile &t);

} // namespace odraz
