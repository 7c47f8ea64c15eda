#include "timeline/camera.h"

namespace odraz {

// A key is eight consecutive numbers, all interpolated in the same way.
static constexpr int kChannels = 8;
static_assert(sizeof(CameraKey) == (kChannels + 1) * sizeof(float));
static const float *channels(const CameraKey &key) { return &key.row + 1; }

// Returns the velocity of a channel at key i, per row.
static float velocity(CameraPath path, int i, int channel) {
    auto slope = [&](int k) { // from key k to key k + 1
        const CameraKey &a = path.keys[k], &b = path.keys[k + 1];
        float difference = channels(b)[channel] - channels(a)[channel];
        return b.row > a.row ? difference / (b.row - a.row) : 0;
    };
    int last = path.count - 1;
    if (last == 0) return 0;
    if (i > 0 && i < last) {
        float h0 = path.keys[i].row - path.keys[i - 1].row, h1 = path.keys[i + 1].row - path.keys[i].row;
        if (h0 <= 0 || h1 <= 0) return 0; // two keys on one row: the path stops instead of jumping
        return (slope(i - 1) * h1 + slope(i) * h0) / (h0 + h1);
    }
    // No acceleration at the first and the last key; no velocity if the channel does not change there
    float end = slope(i ? last - 1 : 0);
    if (last == 1 || end == 0) return end;
    return end * 1.5f - velocity(path, i ? last - 1 : 1, channel) * 0.5f;
}

CameraKey pose(CameraPath path, float row) {
    if (path.count == 0) return {row, {0, 0, 0}, {0, 0, -1}, 0, 45};
    int i = -1;
    while (i + 1 < path.count && path.keys[i + 1].row <= row) ++i;
    CameraKey result = path.keys[i < 0 ? 0 : i];
    if (i >= 0 && i + 1 < path.count) {
        const CameraKey &a = path.keys[i], &b = path.keys[i + 1];
        float h = b.row - a.row;
        float t = (row - a.row) / h;
        float *out = &result.row + 1;
        for (int c = 0; c < kChannels; ++c) {
            // The Hermite curve as p0 + t (v0 + t (..)), which is exact at t = 0
            float p0 = channels(a)[c], p1 = channels(b)[c];
            float v0 = velocity(path, i, c) * h, v1 = velocity(path, i + 1, c) * h;
            float d = p1 - p0;
            out[c] = p0 + t * (v0 + t * ((3 * d - 2 * v0 - v1) + t * (v0 + v1 - 2 * d)));
        }
    }
    result.row = row;
    return result;
}

} // namespace odraz
