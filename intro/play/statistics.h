// The statistics of --stats: for every scene the numbers of pictures traced, made between others, shown and
// missed, and how long they took.
#pragma once

#include "play/film_clock.h"
#include "play/schedule.h"

namespace odraz {

// A histogram of times, in bins of 0.1 ms. The last bin also counts all times of half a second or longer.
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
    // Returns the smallest time, in milliseconds, such that `share` (0 .. 1) of all times are not longer.
    double quantile(double share) const;
};

struct SceneStatistics {
    int traced, between, shown, missed;
    double samples, width; // samples per traced pixel, traced width in pixels: sums over all traced pictures
    Histogram trace, make, present;
};

// All members are zero at the start.
struct Statistics {
    SceneStatistics scenes[kMaxScenes];
    int64_t sixtieth; // 1 + the sixtieth of a second in which the last picture was shown

    // Adds a picture that was shown `at` seconds of the film after its beginning. Presenting it took
    // `present` nanoseconds; -1 if it was skipped.
    void add(const FinishedPicture &m, double at, int64_t present);
};

// Prints a row for every scene that was shown, and the errors between sound and picture. Returns an exit
// status. `untilFirst`: seconds from the program's start to its first picture.
int printStatistics(const Statistics &statistics, const FilmClock &clock, double untilFirst);

} // namespace odraz
