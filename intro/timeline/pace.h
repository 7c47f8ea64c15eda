// Per-scene limits for the governor (play/governor.h), which trades detail for time.
#pragma once

#include <stdint.h>

namespace odraz {

inline constexpr int kCadences = 5; // the governor chooses one of these, in the order of its enum

struct Pace {
    int leastWidth = 640; // the smallest width traced, in pixels
    float cost = 0.5f;    // the time of a picture in `play`, relative to the other scenes
    float halving = 1;    // number of steps of coarseness that halve a picture's time
    // The squared error that each cadence adds, as a multiple of the squared error of quality `play`
    float penalty[kCadences] = {0, 0.2f, 0.8f, 1.5f, 6};
};

// A Pace in seven bytes, for tables: the width in units of 16 pixels, the cost in hundredths, the others in
// tenths. The first cadence adds no error.
struct PackedPace {
    uint8_t leastWidth, cost, halving, penalty[kCadences - 1];

    constexpr PackedPace(const Pace &p)
        : leastWidth((uint8_t)(p.leastWidth / 16)), cost((uint8_t)(p.cost * 100 + 0.5f)),
          halving((uint8_t)(p.halving * 10 + 0.5f)), penalty() {
        for (int c = 1; c < kCadences; ++c) penalty[c - 1] = (uint8_t)(p.penalty[c] * 10 + 0.5f);
    }
    constexpr Pace unpacked() const {
        Pace p = {leastWidth * 16, cost * 0.01f, halving * 0.1f, {}};
        for (int c = 1; c < kCadences; ++c) p.penalty[c] = penalty[c - 1] * 0.1f;
        return p;
    }
};

} // namespace odraz
