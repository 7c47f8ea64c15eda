// The knobs that trade speed for accuracy, and the named points on that trade.
//
// A new quality is an enumerator and a row of kQualities: --quality knows it then, and `tradeoff trace`
// measures it.
#pragma once

#include "base/rows.h"

namespace odraz {

enum class QualityName { Draft, Play, Film, Reference, Count };

struct Quality {
    QualityName id = QualityName::Count; // of a row; Count: somewhere between two
    char name[12] = ""; // no pointer: options are read before constants elsewhere are decoded

    int grid = 0;        // 1 .. 16: grid x grid samples in every pixel and nothing adaptive; 0: as below
    int coarse = 0;      // side of the largest square in quarters of a pixel: 32, 16, 8 or 4
    int fine = 0;        // ... of the smallest: 8 or 4; 2: pixels may take three samples more, 1: twelve
    int texels = 1;      // 1 or 2: per side of a pixel, of textures whose own filter is rough
    float threshold = 0; // difference of shown intensity (0 .. 1) that splits a square
    float mild = 0;      // squares of two pixels whose marks differ split only from this difference on
    float edge = 0;      // difference that splits a pixel; doubled a level below
    float mark = 0; // rays of less than this share of the intensity do not split squares by what they hit
    int depth = 0;  // most bounces of a path, <= kMaxDepth
    float cutoff =
        0; // a ray that would bring less than this share of the picture's intensity is not followed
};

inline constexpr int kMaxDepth = 64;

inline constexpr Quality kQualities[] = {
    {.id = QualityName::Draft,
     .name = "draft",
     .coarse = 32,
     .fine = 4,
     .threshold = 0.08f,
     .mild = 0.2f,
     .edge = 1,
     .mark = 0.25f,
     .depth = 5,
     .cutoff = 1 / 24.f},
    {.id = QualityName::Play,
     .name = "play",
     .coarse = 16,
     .fine = 2,
     .threshold = 0.04f,
     .mild = 0.05f,
     .edge = 0.12f,
     .mark = 0.2f,
     .depth = 5,
     .cutoff = 1 / 64.f},
    {.id = QualityName::Film,
     .name = "film",
     .coarse = 16,
     .fine = 1,
     .texels = 2,
     .threshold = 0.026f,
     .mild = 0.005f,
     .edge = 0.06f,
     .mark = 0.05f,
     .depth = 9,
     .cutoff = 1 / 128.f},
    {.id = QualityName::Reference, .name = "reference", .grid = 8, .depth = 12, .cutoff = 1 / 512.f},
};
static_assert(inOrder(kQualities, &Quality::id), "a row for every name, in the enum's order");

// The way from one quality (share 0) to another (1), without steps but in bounces and texels.
inline Quality between(const Quality &a, const Quality &b, float share) {
    auto mix = [&](float x, float y) { return x + (y - x) * share; };
    return {.coarse = share < 0.5f ? a.coarse : b.coarse,
            .fine = a.fine < b.fine ? a.fine : b.fine,
            .texels = share == 0 ? a.texels : b.texels,
            .threshold = mix(a.threshold, b.threshold),
            .mild = mix(a.mild, b.mild),
            .edge = mix(a.edge, b.edge),
            .mark = mix(a.mark, b.mark),
            .depth = (int)(mix((float)a.depth, (float)b.depth) + 0.5f),
            .cutoff = mix(a.cutoff, b.cutoff)};
}

} // namespace odraz
