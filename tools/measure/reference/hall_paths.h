// The hall's light by path tracing, at the sample points of its texels, and what a solved hall has there.
#pragma once

#include "tools/measure/reference/reference_hall.h"
#include "tools/radiosity/reference/mesh_reference.h"

#include <array>
#include <string>

namespace odraz::measure {

// A light of the film: as the hall is relit, and as paths find it.
struct LightOfHall {
    std::string name;
    LightVector relit; // white for lanterns and strips
    radiosity::Surroundings around;
    float strips; // radiance of the strips
    bool drawn;   // the tracer draws the direct light of the sun or lamp
};
// Noon, evening, lanterns, strips and the point.
std::vector<LightOfHall> lightsOf(const Hall &hall);

// A visible texel that reflects; its visible sample points, which the probes below follow in this order.
struct HallTexel {
    int chart;
    std::vector<std::array<float, 2>> points; // in world units on the chart
};
// At most `count` texels of a solved hall, spread by area.
std::vector<HallTexel> placeTexels(const Hall &hall, int count);

// The luminances of texels, each the mean over its points: reflected light, and all light. noise2: the sum of
// the variances.
struct TexelLight {
    std::vector<float> reflected, all;
    double reflectedNoise2 = 0, noise2 = 0;
    std::vector<float> drawn = {}; // the part of `all` that the tracer draws and the lightmap lacks
};
// Traces 2 x side x side paths from every point.
TexelLight tracedLight(const Hall &hall, const Scene &scene, const LightOfHall &light,
                       const std::vector<HallTexel> &texels, int side, Workers &workers);
// The light of a solved hall, interpolated between texels. `drawn`: light of the tracer, from tracedLight().
TexelLight solvedLight(const Hall &hall, const LightOfHall &light, const std::vector<HallTexel> &texels,
                       const std::vector<float> &drawn);

} // namespace odraz::measure
