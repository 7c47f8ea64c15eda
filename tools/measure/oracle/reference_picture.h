// Pictures by path tracing in double precision, to check the film's effects on balls.
//
// It shares only the scene's numbers with the tracer. It handles balls, a floor (a plane that faces up),
// plain colours, lights with a radius, and a sky that is `ambientHigh` everywhere; for other scenes it throws
// std::logic_error. A light of `intensity` and `radius` is a ball of radiance intensity / radius^2.
//
// At glass and mirrors, paths from the eye go on in a random direction. At matte places, a ray into a
// light's cone samples that light, and a ray by the cosine law samples the sky. Light that
// glass throws on the floor comes from the other end: photons go from the lights to the balls and are counted
// in cells of the floor. Highlights are Phong's, averaged over the light's disc.
#pragma once

#include "base/parallel.h"
#include "tools/engine/vec3d.h"
#include "trace/rays/view.h"

#include <vector>

namespace odraz::measure {

struct PathSettings {
    // False: only light straight from lamps and sky, or through glass. True: also light that bounces off
    // matte places and, from lamps, off mirrors
    bool bounces;
    int samples;   // a pixel
    int photons;   // thousands for every lamp and ball
    uint32_t seed; // another seed gives other noise
};

// The radiance of every pixel, averaged over its square; top row first.
std::vector<Vec3d> tracePaths(const Scene &scene, const View &view, const PathSettings &settings,
                              Workers &workers);

} // namespace odraz::measure
