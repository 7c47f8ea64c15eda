// Light from all directions, given as a picture or a colour, and what the bands of spherical harmonics keep
// of it.
#pragma once

#include "tools/radiosity/read/hdr_reader.h"
#include "tools/radiosity/transfer/bands.h"

#include <functional>
#include <string>

namespace odraz::radiosity {

struct Projected {
    BandLight light = {};
    // What the first 1 .. kMostBands bands hold of the environment's energy: of the integral of its squared
    // radiance over all directions. 1 where there is no light
    double held[kMostBands] = {};
};

// Projects a picture of all directions, laid out as in surroundings.h, with all of its pixels.
Projected project(const HdrPicture &picture, bool upIsZ);
Projected project(const Rgb &even);

// Reads what --sky takes: R,G,B or the name of a picture. Throws Refused.
Projected readEnvironment(const std::string &option, const std::string &text, bool upIsZ);

// One line: the share of the energy that this number of bands holds, and the rest, which they lose.
std::string lossOf(const std::string &name, const Projected &projected, int bands);

} // namespace odraz::radiosity
