// Steps along the film, and stretches of it that are played again and again. Times are seconds.
#pragma once

#include <vector>

namespace odraz::maker {

// The next (way 1) or the former (way -1) multiple of `unit`, within [0, end]. A time within a millionth of a
// unit from a multiple stands on it.
double stepBy(double time, double unit, int way, double end);

// The next or the former of some times in ascending order; the time itself if there is none.
double stepTo(double time, const std::vector<double> &times, int way);

// A stretch [from, to); from == to: none.
struct Loop {
    double from = 0, to = 0;

    bool on() const { return to > from; }
};

// The music goes back only by more than a second (playback.cpp): what is shorter would be silent.
inline constexpr double kBeat = 0.5, kShortestLoop = 3 * kBeat;

// The loop between two points in any order, widened to whole beats and to the shortest there is; within [0,
// end]. None if the film is shorter than that.
Loop loopBetween(double a, double b, double end);

// Where a time goes on that has run in a loop: back to its start once it is at or beyond its end, or before
// its start. Without a loop it is the time itself.
double looped(const Loop &loop, double time);

} // namespace odraz::maker
