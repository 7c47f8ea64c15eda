// The knobs that trade speed for accuracy, and the named points on that trade.
#pragma once

namespace odraz {

struct Quality {
    int grid;        // 1 .. 16: grid x grid samples in every pixel and nothing adaptive; 0: as below
    int coarse;      // side of the largest square in quarters of a pixel: 32, 16, 8 or 4
    int fine;        // ... of the smallest: 8, 4, 2 or 1
    int texels;      // 1 or 2: per side of a pixel, of textures whose own filter is rough
    float threshold; // difference of shown intensity (0 .. 1) that splits a square
    float mild;      // squares of two pixels whose marks differ split only from this difference on
    float edge;      // difference that splits a pixel; doubled a level below
    float mark;      // rays of less than this share of the intensity do not split squares by what they hit
    int depth;       // most bounces of a path, <= kMaxDepth
    float cutoff;    // a ray that would bring less than this share of the picture's intensity is not followed
};

inline constexpr int kMaxDepth = 64;

enum class QualityName { Draft, Play, Film, Reference, Count };

inline constexpr Quality kQualities[(int)QualityName::Count] = {
    {0, 32, 4, 1, 0.12f, 0.25f, 1.00f, 0.25f, 5, 1 / 16.f},
    {0, 32, 2, 1, 0.03f, 0.02f, 0.10f, 0.12f, 5, 1 / 40.f},
    {0, 32, 1, 2, 0.026f, 0.005f, 0.046f, 0.05f, 9, 1 / 128.f},
    {8, 0, 0, 1, 0, 0, 0, 0, 12, 1 / 512.f},
};
// The way from one quality (share 0) to another (1), without steps but in bounces and texels.
inline Quality between(const Quality &a, const Quality &b, float share) {
    auto mix = [&](float x, float y) { return x + (y - x) * share; };
    return {0,
            share < 0.5f ? a.coarse : b.coarse,
            a.fine < b.fine ? a.fine : b.fine,
            share == 0 ? a.texels : b.texels,
            mix(a.threshold, b.threshold),
            mix(a.mild, b.mild),
            mix(a.edge, b.edge),
            mix(a.mark, b.mark),
            (int)(mix((float)a.depth, (float)b.depth) + 0.5f),
            mix(a.cutoff, b.cutoff)};
}

inline constexpr const char *kQualityNames[(int)QualityName::Count] = {"draft", "play", "film", "reference"};

} // namespace odraz
