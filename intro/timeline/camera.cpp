#include "timeline/camera.h"

namespace odraz {

// A key is eight numbers in a row, all of them interpolated alike.
static constexpr int kChannels = 8;
static_assert(sizeof(CameraKey) == (kChannels + 1) * sizeof(float));
static const float *channels(const CameraKey &key) { return &key.row + 1; }

// The velocity at key i, per row, in one channel.
static float velocity(CameraPath path, int i, int channel) {
    if (i == 0 || i + 1 == path.count) return 0;
    const CameraKey &before = path.keys[i - 1], &here = path.keys[i], &after = path.keys[i + 1];
    float h0 = here.row - before.row, h1 = after.row - here.row;
    if (h0 <= 0 || h1 <= 0) return 0; // two keys on one row: the path stops there instead of tearing
    float v0 = (channels(here)[channel] - channels(before)[channel]) / h0;
    float v1 = (channels(after)[channel] - channels(here)[channel]) / h1;
    return (v0 * h1 + v1 * h0) / (h0 + h1);
}

CameraKey pose(CameraPath path, double row) {
    if (path.count == 0) return {(float)row, {0, 0, 0}, {0, 0, -1}, 0, 45};
    int i = -1;
    while (i + 1 < path.count && path.keys[i + 1].row <= row) ++i;
    CameraKey result = path.keys[i < 0 ? 0 : i];
    if (i >= 0 && i + 1 < path.count) {
        const CameraKey &a = path.keys[i], &b = path.keys[i + 1];
        float h = b.row - a.row;
        float t = (float)((row - a.row) / h);
        float *out = &result.row + 1;
        for (int c = 0; c < kChannels; ++c) {
            // Hermite in the form a + t (v0 + t (..)): exact at t = 0
            float p0 = channels(a)[c], p1 = channels(b)[c];
            float v0 = velocity(path, i, c) * h, v1 = velocity(path, i + 1, c) * h;
            float d = p1 - p0;
            out[c] = p0 + t * (v0 + t * ((3 * d - 2 * v0 - v1) + t * (v0 + v1 - 2 * d)));
        }
    }
    result.row = (float)row;
    return result;
}

} // namespace odraz
