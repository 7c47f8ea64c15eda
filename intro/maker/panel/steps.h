// Steps along the film, and loops. Times are in seconds.
#pragma once

#include <vector>

namespace odraz::maker {

// Returns the next (direction 1) or previous (direction -1) multiple of `unit`, within [0, end]. A time
// within a millionth of a unit of a multiple counts as that multiple.
double stepBy(double time, double unit, int direction, double end);

// Returns the next or previous one of `times`, which ascend; `time` itself if there is none.
double stepTo(double time, const std::vector<double> &times, int direction);

// A loop [from, to); from == to: none.
struct Loop {
    double from = 0, to = 0;

    bool on() const { return to > from; }
};

// The music follows only jumps back of more than a second (playback.cpp): shorter loops would be silent.
inline constexpr double kBeat = 0.5, kShortestLoop = 3 * kBeat;

// Returns the loop between two times in any order, widened to whole beats and at least kShortestLoop, within
// [0, end]. None if the film is shorter than kShortestLoop.
Loop loopBetween(double a, double b, double end);

// Returns the loop's start if `time` is outside the loop, else `time`.
double looped(const Loop &loop, double time);

} // namespace odraz::maker
