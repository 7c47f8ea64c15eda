// The figures of the lecture on transfer: the functions of the bands, and what each band adds to a room.
#pragma once

#include "tools/radiosity/export/render.h"
#include "tools/radiosity/transfer/relight.h"

namespace odraz::radiosity {

// Makes the folder if it is missing, and writes two PNGs into it. basis.png: each function on a ball, orange
// where it is above 0 and blue where it is below, a row for each band. bands.png: the room by the first 1, 2
// .. bands of its light, and below, what each band alone adds, in the same two colours. A picture of the room
// has the settings' camera, and a quarter of its width and height. Throws std::runtime_error.
void picturesOf(const TransferRoom &room, const Lighting &lighting, const RenderSettings &settings,
                Workers &workers, const std::string &folder);

} // namespace odraz::radiosity
