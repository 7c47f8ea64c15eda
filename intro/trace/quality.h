// The parameters that trade speed for accuracy, and their named settings.
//
// A new quality needs an enumerator and a row of kQualities; then --quality and `tradeoff` accept it.
#pragma once

#include "base/float8.h"
#include "base/rows.h"

namespace odraz {

enum class QualityName { Draft, Play, Film, Reference, Count };

struct Quality {
    QualityName id = QualityName::Count; // the row's name; Count: a blend of two rows
    char name[12] = ""; // not a pointer: the options are read before other constants are decoded

    int grid = 0;     // 1 .. 16: grid x grid samples in every pixel; 0: adaptive sampling
    int coarse = 0;   // side of the largest square in quarters of a pixel: 32, 16, 8 or 4
    int smallest = 0; // the smallest one: 8 (at most 3 samples inside a pixel) or 4 (12, and no mean corners)
    // Thresholds: differences of perceived intensity (0 .. 1) above which
    float threshold = 0;     // a square splits
    float markThreshold = 0; // a 2x2 square splits if its corners' marks differ; see also meanSuffices()
    float edge = 0;          // a pixel takes three samples inside
    float outline = 0;       // a pixel whose corners show several shapes takes three samples inside
    float again = 0;         // a pixel takes all twelve
    float textureEdge = 0;   // textures and lines take four samples a pixel (relative, between pixels)
    float markWeight = 0;    // least share of the intensity at which a ray's hit may split squares
    int depth = 0;           // most bounces of a path, <= kMaxDepth
    float cutoff = 0;        // least share of the intensity at which a ray is followed
    float faint = 1;         // contrast of faint textures in samples and mirrors; 0: these show the mean
};

inline constexpr int kMaxDepth = 64;

inline constexpr Quality kQualities[] = {
    {.id = QualityName::Draft,
     .name = "draft",
     .coarse = 32,
     .smallest = 8,
     .threshold = 0.105f,
     .markThreshold = 0.063f,
     .edge = 0.25f,
     .outline = 0.04f,
     .again = 0.6f,
     .textureEdge = 4,
     .markWeight = 0.25f,
     .depth = 5,
     .cutoff = 1 / 48.f,
     .faint = 0},
    {.id = QualityName::Play,
     .name = "play",
     .coarse = 16,
     .smallest = 8,
     .threshold = 0.042f,
     .markThreshold = 0.03f,
     .edge = 0.06f,
     .outline = 0.03f,
     .again = 0.6f,
     .textureEdge = 0.25f,
     .markWeight = 0.2f,
     .depth = 5,
     .cutoff = 1 / 64.f,
     .faint = 0},
    {.id = QualityName::Film,
     .name = "film",
     .coarse = 16,
     .smallest = 4,
     .threshold = 0.026f,
     .markThreshold = 0.005f,
     .edge = 0.06f,
     .outline = 0.06f,
     .again = 0.12f,
     .markWeight = 0.05f,
     .depth = 9,
     .cutoff = 1 / 128.f},
    {.id = QualityName::Reference, .name = "reference", .grid = 8, .depth = 12, .cutoff = 1 / 512.f},
};
static_assert(inOrder(kQualities, &Quality::id), "a row for every name, in the enum's order");

// A quality between a (share 0) and b (share 1). The depth changes in steps. Only blends close to `film` have
// faint textures, which cost 5 to 9 %.
inline Quality blend(const Quality &a, const Quality &b, float share) {
    auto mix = [&](float x, float y) { return x + (y - x) * share; };
    return {.coarse = share < 0.5f ? a.coarse : b.coarse,
            .smallest = share < 1 && a.smallest < b.smallest ? a.smallest : b.smallest,
            .threshold = mix(a.threshold, b.threshold),
            .markThreshold = mix(a.markThreshold, b.markThreshold),
            .edge = mix(a.edge, b.edge),
            .outline = mix(a.outline, b.outline),
            .again = mix(a.again, b.again),
            .textureEdge = mix(a.textureEdge, b.textureEdge),
            .markWeight = mix(a.markWeight, b.markWeight),
            .depth = (int)(mix((float)a.depth, (float)b.depth) + 0.5f),
            .cutoff = mix(a.cutoff, b.cutoff),
            .faint = max(mix(a.faint, b.faint) * 10 - 9, 0.f)};
}

} // namespace odraz
