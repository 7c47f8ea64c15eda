// Light that no surface of a model emits, from options or a glTF file: a sky, suns and lamps.
//
// The sky has a radiance in every direction, below the horizon too: one colour, or a picture of all
// directions (latitude and longitude, of any format that pictures::readPicture reads). The middle of the
// picture is towards -z if y is up, towards +y if z is up, with +x to its right. Pixels more than eight
// times as bright as the mean become suns, because a few rays would miss them: at most 24, found by cuts that
// halve their light (Debevec, "A Median Cut Algorithm for Light Probe Sampling", 2005).
#pragma once

#include "tools/picture/picture.h"
#include "tools/support/vec3d.h"

#include <string>
#include <vector>

namespace odraz::radiosity {

struct Sun {
    Vec3 towards; // unit direction
    Rgb light;    // irradiance over pi on a surface that faces it
};

// A ball that emits evenly, in the model's units.
struct BallLamp {
    Vec3 centre;
    float radius;
    Rgb radiance;
    Vec3 rest = {}; // the rounding error of `centre`: exact minus rounded
};

struct SkyPicture {
    int width = 0, height = 0; // 0: black
    std::vector<Rgb> pixels;   // rows from top to bottom
    bool upIsZ = false;

    Rgb radiance(const Vec3 &direction) const; // bilinear
};

struct Surroundings {
    SkyPicture sky;
    std::vector<Sun> suns;
    std::vector<BallLamp> lamps;

    // Makes the centres of lamps relative to a point.
    void moveTo(const Vec3 &origin);
    // Multiplies the centres and radii of lamps.
    void scale(double by);
    bool any() const { return sky.width || !suns.empty() || !lamps.empty(); }
};

BallLamp ballLamp(const Vec3d &centre, double radius, const Rgb &radiance);

SkyPicture evenSky(const Rgb &radiance);

// Reads the picture of a sky. Adds notes on header lines that are not used, and on a picture that is not
// twice as wide as high. Throws Refused, also for pictures that Picture::needUsual() refuses.
pictures::Picture readPanorama(const std::string &path, std::vector<std::string> *notes = nullptr);
// Reads a sky as readPanorama() does; turns its brightest pixels into `suns`.
SkyPicture readSky(const std::string &path, bool upIsZ, std::vector<Sun> &suns,
                   std::vector<std::string> *notes = nullptr);

// The direction to a sun, in degrees above the horizon and from -z (+y if z is up) towards +x.
Vec3 sunTowards(double elevation, double azimuth, bool upIsZ);

} // namespace odraz::radiosity
