#include "timeline/track.h"

namespace odraz {

static float ease(Interpolation interpolation, float t) {
    switch (interpolation) {
    case Interpolation::Linear:
        return t;
    case Interpolation::Smooth:
        return t * t * (3 - 2 * t);
    }
    return 0;
}

float value(Track track, float row) {
    if (track.count == 0) return 0;
    // Find the last key at or before the row
    int i = -1;
    while (i + 1 < track.count && track.keys[i + 1].row <= row) ++i;
    if (i < 0) return track.keys[0].value;
    const Key &a = track.keys[i];
    if (i + 1 == track.count) return a.value;

    const Key &b = track.keys[i + 1];
    float t = (row - a.row) / (b.row - a.row);
    return a.value + (b.value - a.value) * ease(a.interpolation, t);
}

} // namespace odraz
