// What lights a model from outside, without a line in its file: a sky, suns, lamps.
//
// The sky is a radiance from every direction, below the horizon too: of one colour, or a picture of all
// directions (Radiance HDR, latitude and longitude; its middle lies towards -z where y is up and towards +y
// where z is, +x to the right of it). What is more than eight times as bright as its mean is taken out of the
// picture and cast as suns, 24 at most, cut where that halves their light (Debevec, "A Median Cut Algorithm
// for Light Probe Sampling", 2005): few rays would miss it.
#pragma once

#include "base/parallel.h"
#include "radiosity/direct.h"

#include <string>
#include <vector>

namespace odraz {

struct Sun {
    Vec3 towards; // of length 1
    Rgb light;    // what a white surface shows that faces it: irradiance over pi
};

// A ball that shines evenly; in the model's units.
struct BallLamp {
    Vec3 centre;
    float radius;
    Rgb radiance;
};

struct SkyPicture {
    int width = 0, height = 0; // 0: black
    std::vector<Rgb> pixels;   // rows from above to below
    bool upIsZ = false;

    Rgb radiance(const Vec3 &direction) const; // bilinear
};

struct Surroundings {
    SkyPicture sky;
    std::vector<Sun> suns;
    std::vector<BallLamp> lamps;

    bool shine() const { return sky.width || !suns.empty() || !lamps.empty(); }
};

SkyPicture evenSky(const Rgb &radiance);

// Reads a picture; what shines too brightly is added to `suns`. Throws Refused.
SkyPicture readSky(const std::string &path, bool upIsZ, std::vector<Sun> &suns);

// Where a sun stands: degrees above the horizon, and from -z (+y where z is up) towards +x.
Vec3 sunTowards(double elevation, double azimuth, bool upIsZ);

// Adds what the sky gives to the texels, in three planes of irradiance over pi: by rays through a grid over
// the hemisphere as cosines weigh it, a quarter of them from each of a texel's places, turned otherwise at
// every texel. `rays` is the square of an even number.
void addSky(const Model &model, const Scene &scene, const SkyPicture &sky, int rays, Workers &workers,
            float *const *direct);

} // namespace odraz
