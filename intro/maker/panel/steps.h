// Steps along the film, and loops in it. Times are seconds.
#pragma once

#include <vector>

namespace odraz::maker {

// The next (way 1) or the previous (way -1) multiple of `unit`, within [0, end]. A time within a millionth of
// a unit of a multiple counts as that multiple.
double stepBy(double time, double unit, int way, double end);

// The next or the previous of `times`, which ascend; `time` itself if there is none.
double stepTo(double time, const std::vector<double> &times, int way);

// A loop [from, to); from == to: none.
struct Loop {
    double from = 0, to = 0;

    bool on() const { return to > from; }
};

// The music goes back only by more than a second (playback.cpp): a shorter loop would be silent.
inline constexpr double kBeat = 0.5, kShortestLoop = 3 * kBeat;

// The loop between two times in any order, widened to whole beats and to kShortestLoop, within [0, end]. None
// if the film is shorter than kShortestLoop.
Loop loopBetween(double a, double b, double end);

// The loop's start if `time` is outside of the loop; else `time`.
double looped(const Loop &loop, double time);

} // namespace odraz::maker
