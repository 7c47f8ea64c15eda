// Makes pixels from corners.
#pragma once

#include "trace/picture/tile.h"

namespace odraz {

// Interpolates a square of whole pixels over the pixels that it covers.
void fill(Tile &t, Square q, int size);

// Multiplies every pixel's light by the albedo that it shows, and writes the tile into the frame.
void finishTile(Tile &t);

} // namespace odraz
