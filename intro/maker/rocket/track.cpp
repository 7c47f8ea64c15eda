#include "maker/rocket/track.h"

#include <algorithm>
#include <iterator>

namespace odraz::maker::rocket {

double value(const Track &track, double row) {
    if (track.empty()) return 0;
    // The first key behind the row
    auto next = std::find_if(track.begin(), track.end(), [&](auto &key) { return (double)key.first > row; });
    if (next == track.begin()) return (double)next->second.value;
    auto key = std::prev(next);
    double from = (double)key->second.value;
    if (next == track.end()) return from;
    double t = (row - key->first) / (double)(next->first - key->first);
    switch (key->second.interpolation) {
    case Interpolation::Step:
        t = 0;
        break;
    case Interpolation::Linear:
        break;
    case Interpolation::Smooth:
        t = t * t * (3 - 2 * t);
        break;
    case Interpolation::Ramp:
        t = t * t;
        break;
    }
    return from + ((double)next->second.value - from) * t;
}

} // namespace odraz::maker::rocket
