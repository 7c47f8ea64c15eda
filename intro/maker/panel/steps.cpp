#include "maker/panel/steps.h"

#include <algorithm>
#include <cmath>

namespace odraz::maker {

static constexpr double kNear = 1e-6; // units, or seconds

double stepBy(double time, double unit, int direction, double end) {
    double at = time / unit, to = direction > 0 ? std::floor(at + kNear) + 1 : std::ceil(at - kNear) - 1;
    return std::clamp(to * unit, 0., end);
}

double stepTo(double time, const std::vector<double> &times, int direction) {
    if (direction > 0) {
        auto next = std::upper_bound(times.begin(), times.end(), time + kNear);
        return next == times.end() ? time : *next;
    }
    auto next = std::lower_bound(times.begin(), times.end(), time - kNear);
    return next == times.begin() ? time : *(next - 1);
}

Loop loopBetween(double a, double b, double end) {
    if (end < kShortestLoop) return {};
    if (a > b) std::swap(a, b);
    double from = std::floor(a / kBeat + kNear) * kBeat, to = std::ceil(b / kBeat - kNear) * kBeat;
    from = std::clamp(from, 0., end - kShortestLoop);
    return {from, std::clamp(to, from + kShortestLoop, end)};
}

double looped(const Loop &loop, double time) {
    return loop.on() && (time < loop.from || time >= loop.to) ? loop.from : time;
}

} // namespace odraz::maker
