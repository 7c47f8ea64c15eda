// A picture by paths in double precision: what the film's effects on balls are compared with.
//
// It shares nothing with the tracer but the scene's numbers, and takes of these what such pictures need:
// balls, a floor (a plane that faces up), plain colours, lights with a radius, and a sky that is
// `ambientHigh` everywhere. A light of `intensity` and `radius` is a ball of radiance intensity / radius^2.
// Eye paths are scattered at random at glass and mirrors; from matte places they look for lamps by rays into
// the cone in which these stand, and for the sky by cosine. What glass gathers comes the other way: photons
// are shot from the lamps at the balls, and counted in cells of the floor. Highlights are Phong's, averaged
// over the lamp's disc.
#pragma once

#include "base/parallel.h"
#include "tools/common/vec3d.h"
#include "trace/rays/view.h"

#include <vector>

namespace odraz {

struct PathSettings {
    // False: light that comes from lamps and sky straight, or through glass. True: light also goes on from
    // matte places and, for lamps, from mirrors
    bool bounces;
    int samples;   // a pixel
    int photons;   // thousands, for every lamp and ball
    uint32_t seed; // others give other noise
};

// Radiance of every pixel, averaged over its square; top row first.
std::vector<Vec3d> tracePaths(const Scene &scene, const View &view, const PathSettings &settings,
                              Workers &workers);

} // namespace odraz
