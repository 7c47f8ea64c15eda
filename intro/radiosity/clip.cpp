#include "radiosity/clip.h"

namespace odraz {

namespace {

// A border of a face: sign * (x or y) + limit * w >= 0.
struct Border {
    bool alongY;
    float sign, limit;

    float inside(const FaceCorner &c) const { return fmadd(sign, alongY ? c.y : c.x, limit * c.w); }
};

// Cuts a convex polygon. A new corner is computed from the nearer end of its side: this is precise, and
// neighbours that share the side compute the same corner. Then it is moved exactly onto the border, since
// rounding might leave it many pixels away if a wall is very close to the eye.
int clip(const FaceCorner *in, int count, FaceCorner *out, const Border &border) {
    int n = 0;
    for (int i = 0; i < count; ++i) {
        const FaceCorner &p = in[i], &q = in[i + 1 < count ? i + 1 : 0];
        float dp = border.inside(p), dq = border.inside(q);
        if (dp >= 0) out[n++] = p;
        if ((dp >= 0) == (dq >= 0)) continue;
        bool fromP = abs(dp) < abs(dq) || (abs(dp) == abs(dq) && dp >= 0);
        const FaceCorner &near = fromP ? p : q, &far = fromP ? q : p;
        float dn = fromP ? dp : dq, t = dn / (dn - (fromP ? dq : dp));
        FaceCorner &c = out[n++];
        c = {lerp(near.x, far.x, t), lerp(near.y, far.y, t), 0,
             lerp(near.w, far.w, t), lerp(near.s, far.s, t), lerp(near.t, far.t, t)};
        (border.alongY ? c.y : c.x) = -border.sign * border.limit * c.w;
    }
    return n;
}

} // namespace

uint32_t outsideFaces(const Vec3 &p) {
    float sum = p.x + p.y, difference = p.x - p.y;
    uint32_t low = p.z < 0, right = p.x < p.z, left = -p.x < p.z, front = p.y < p.z, back = -p.y < p.z;
    uint32_t a = (sum < 0), b = (sum > 0), c = (difference < 0), d = (difference > 0);
    auto face = [](uint32_t k0, uint32_t k1, uint32_t k2, uint32_t k3) {
        return k0 | k1 << 1 | k2 << 2 | k3 << 3;
    };
    return face((p.x < -p.z), (p.x > p.z), (p.y < -p.z), (p.y > p.z)) | face(a, c, low, right) << 4 |
           face(d, a, low, front) << 8 | face(b, d, low, left) << 12 | face(c, b, low, back) << 16;
}

const FaceCorner *clipToFace(const FaceCorner *polygon, int &count, bool top, uint32_t crossed,
                             FaceCorner (&buffers)[2][8]) {
    const Border borders[4] = {{false, 1, 1}, {false, -1, 1}, {true, 1, top ? 1.f : 0.f}, {true, -1, 1}};
    int turn = 0;
    for (int k = 0; k < 4; ++k) {
        if (!(crossed >> k & 1)) continue;
        count = clip(polygon, count, buffers[turn], borders[k]);
        polygon = buffers[turn];
        turn ^= 1;
    }
    return polygon;
}

} // namespace odraz
