// The knobs that trade speed for accuracy, and the named points on that trade.
#pragma once

namespace odraz {

struct Quality {
    int grid;    // 1 .. 16: grid x grid samples in every pixel and nothing adaptive; 0: as below
    int coarse;  // side of the largest square in pixels: 8, 4, 2 or 1
    int fine;    // side of the smallest square: 1 or 2
    int inner;   // ... where no silhouette runs through it, >= fine
    bool middle; // where such a square is 2 pixels wide and its corners differ, one more sample in its middle
    int levels;  // super-sampling below a pixel: 0 none, 1 up to 2x2, 2 up to 4x4 samples
    float threshold; // difference of shown intensity (0 .. 1) that splits a square
    float edge;      // ... and that super-samples a pixel; doubled a level below
    float mark;      // rays of less than this share of the intensity do not split squares by what they hit
    int depth;       // most bounces of a path, <= kMaxDepth
    float cutoff;    // a ray that would bring less than this share of the picture's intensity is not followed
};

inline constexpr int kMaxDepth = 12;

enum class QualityName { Draft, Play, Film, Reference, Count };

inline constexpr Quality kQualities[(int)QualityName::Count] = {
    {0, 8, 2, 2, false, 0, 0.08f, 1.00f, 0.20f, 4, 1 / 24.f},
    {0, 8, 1, 1, false, 1, 0.05f, 0.10f, 0.12f, 5, 1 / 40.f},
    {0, 4, 1, 1, false, 2, 0.02f, 0.03f, 0.03f, 9, 1 / 160.f},
    {8, 0, 0, 0, false, 0, 0, 0, 0, 12, 1 / 512.f},
};
inline constexpr const char *kQualityNames[(int)QualityName::Count] = {"draft", "play", "film", "reference"};

} // namespace odraz
