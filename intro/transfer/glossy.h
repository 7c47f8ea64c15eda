// Gloss: the light that a polished floor reflects, as a blurred mirror does.
//
// Each square of a chart, two patches wide and high, has a matrix. For each light basis the matrix has 25
// coefficients of the light that arrives from the upper half-space, in red, green and blue: light of skies
// through the windows, light of suns and lamps after all bounces, and light of charts that are lamps. The
// direct light of suns and balls is left out, because the tracer draws their highlights. For an eye the
// coefficients are multiplied by those of a lobe around the mirrored direction, and the products are summed.
//
// Source: Kautz, Sloan and Snyder, "Fast, Arbitrary BRDF Shading for Low-Frequency Lighting Using Spherical
// Harmonics", Eurographics Workshop on Rendering 2002.
#pragma once

#include "transfer/relight.h"
#include "transfer/spherical_harmonics.h"

namespace odraz {

inline constexpr int kGlossOutputs = (3 * kSh + 7) & ~7; // coefficients of red, then green, then blue

struct Glossy {
    const Chart *chart;
    int bases, across, down; // squares along the chart's u and v
    const float *matrices;   // [squares][bases][kGlossOutputs], coefficients times their band's window
    float *plane[3];         // one value for each square: the radiance to the eye
};

// Computes the matrices of a chart in a solved room, for a lobe with an exponent (see window()). Returns
// false if the arena is full.
bool findGlossy(Glossy &g, const Model &model, const Radiosity &r, int chart, float exponent, Arena &arena,
                Workers &workers);

// Fills the planes with the radiance that a mirror blurred by the lobe reflects to an eye, times `strength`.
// The mirror's reflectance rises from `reflect` at normal incidence to 1 (Schlick).
void relightGlossy(const Glossy &g, const LightVector &light, const Vec3 &eye, float reflect, float strength);

} // namespace odraz
