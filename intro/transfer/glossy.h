// Gloss: what a polished floor throws back of the light around it, as a blurred mirror does.
//
// Every square of a chart, two patches wide and high, has a matrix: for each basis of light the 25
// coefficients of what arrives there from the upper half, in red, green and blue; skies through the windows,
// suns and lamps by all bounces, charts that are lamps themselves too. Suns and balls are left out where they
// shine directly: the tracer has highlights for them. The matrices are compressed by clustered PCA. For an
// eye the coefficients are multiplied with those of a lobe around the mirrored direction and added up.
//
// Source: Kautz, Sloan and Snyder, "Fast, Arbitrary BRDF Shading for Low-Frequency Lighting Using Spherical
// Harmonics", Eurographics Workshop on Rendering 2002.
#pragma once

#include "transfer/clustered_pca.h"
#include "transfer/relight.h"
#include "transfer/spherical_harmonics.h"

namespace odraz {

inline constexpr int kGlossOutputs = (3 * kSh + 7) & ~7; // coefficients of red, then green, then blue

struct GlossySettings {
    PcaSettings pca = {.clusters = 8, .dimensions = 16, .rounds = 1, .iterations = 3, .tried = 3};
    float exponent = 16; // of the lobe: see window()
};

struct Glossy {
    const Chart *chart;
    int bases, across, down; // squares along the chart's u and v
    float *matrices;         // [squares][bases][kGlossOutputs], weighted as the compression sees them
    ClusteredPca pca;
    float *plane[3]; // by squares: what the eye gets
};

// Finds the matrices of a chart from a room that is solved, and compresses them, such that what counts is
// what will be seen: `importance` tells of each basis how much of it there may be. False when the arena is
// full.
bool findGlossy(Glossy &g, const Model &model, const Radiosity &r, int chart, const float *importance,
                const GlossySettings &settings, Arena &arena, Workers &workers);

// Fills the planes with the radiance towards an eye of a mirror blurred by the lobe, times `strength`; its
// reflectance rises from `reflect` at normal incidence to 1 (Schlick).
void relightGlossy(const Glossy &g, const LightVector &light, const Vec3 &eye, float reflect, float strength);

} // namespace odraz
