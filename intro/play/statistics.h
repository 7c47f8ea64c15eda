// What --stats prints: for every scene how many pictures were traced, made between others, shown and missed,
// and how long that took.
#pragma once

#include "play/film_clock.h"
#include "play/schedule.h"

namespace odraz {

// Times in tenths of a millisecond; what took half a second or longer counts as half a second.
struct Histogram {
    static constexpr int kBins = 5000;
    static constexpr int64_t kBin = 100000; // nanoseconds
    int count;
    int bins[kBins];

    void add(int64_t nanoseconds) {
        int64_t bin = nanoseconds / kBin;
        ++bins[bin < kBins ? bin : kBins - 1];
        ++count;
    }
    // The smallest time, in milliseconds, within which `share` (0 .. 1) of all times lie.
    double quantile(double share) const;
};

struct SceneStatistics {
    int traced, between, shown, missed;
    double samples, width; // per traced pixel, and traced, in pixels: summed over all traced pictures
    Histogram trace, make, present;
};

// Zero at the start.
struct Statistics {
    SceneStatistics scenes[kMaxScenes];
    int64_t sixtieth; // when the last picture was shown, plus 1

    // A picture came on the screen `at` seconds of the film after it began, and took `present` nanoseconds;
    // or it was skipped: -1.
    void add(const Made &m, double at, int64_t present);
};

// Prints a row for every scene that was shown, and how far the sound was from the picture; exit status.
// `untilFirst`: seconds from the program's start to its first picture.
int printStatistics(const Statistics &statistics, const FilmClock &clock, double untilFirst);

} // namespace odraz
