// The figures of the lecture on transfer: the functions of the bands, and the light that each band adds to a
// room.
#pragma once

#include "tools/radiosity/export/render.h"
#include "tools/radiosity/transfer/relight.h"

namespace odraz::radiosity {

// Makes the folder if it is missing, and writes two PNGs into it. basis.png has a row for each band, with
// each function on a ball, orange above 0 and blue below. bands.png has the room under the first 1, 2 ..
// bands of its light, and under these the light of each band alone, in the same two colours. A picture of the
// room has the settings' camera and a quarter of its width and height. Throws std::runtime_error.
void picturesOf(const TransferRoom &room, const Lighting &lighting, const RenderSettings &settings,
                Workers &workers, const std::string &folder);

} // namespace odraz::radiosity
