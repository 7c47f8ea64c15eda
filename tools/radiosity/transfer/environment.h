// Projects light from all directions, a picture or a colour, onto the bands of spherical harmonics.
#pragma once

#include "tools/picture/picture.h"
#include "tools/radiosity/read/surroundings.h"
#include "tools/radiosity/transfer/bands.h"

#include <string>

namespace odraz::radiosity {

struct Projected {
    BandLight light = {};
    // The share of the environment's energy in the first 1 .. kMostBands bands; 1 if there is no light. The
    // energy is the integral of squared radiance over all directions
    double held[kMostBands] = {};
};

// Projects a picture of all directions, laid out as in surroundings.h, at its full resolution.
Projected project(const pictures::Picture &picture, bool upIsZ);
Projected project(const Rgb &even);

// A band-limited light as a picture, whose pixels are small enough for an error of 1e-4.
SkyPicture pictureOf(const BandLight &light, int bands, bool upIsZ);

// Reads the value of --sky: R,G,B or the name of a picture, with notes as by readPanorama(). Throws Refused.
Projected readEnvironment(const std::string &sky, bool upIsZ, std::vector<std::string> *notes = nullptr);

// One line: the shares of the energy that this number of bands holds and loses.
std::string bandLossText(const std::string &name, const Projected &projected, int bands);

} // namespace odraz::radiosity
