#include "trace/rays/beam.h"

namespace odraz {

Beam beamThrough(const Vec3 &origin, const Vec3 (&corner)[4]) {
    Beam b = {origin, {}, {0, 0, 0, 0, -kInfinity}};
    for (int i = 0; i < 4; ++i) b.n[i] = normalize(cross(corner[i], corner[(i + 1) & 3]));
    return b;
}

BeamBuilder::BeamBuilder(const Vec3 &o, const Vec3 &towards) : origin(o) {
    Vec3 w = normalize(towards), u = normalize(abs(w.y) < 0.9f ? Vec3{w.z, 0, -w.x} : Vec3{0, -w.z, w.y});
    frame = {u, cross(w, u), w};
    low[0] = low[1] = ahead = broadcast(kInfinity);
    high[0] = high[1] = -ahead;
    far = Float8{};
}

void BeamBuilder::add(const Vec3x8 &p) {
    Vec3x8 q = frame * p;
    Float8 inverse = 1.f / q.z, x = q.x * inverse, y = q.y * inverse;
    ahead = min(ahead, q.z * 6.f - length(q));
    low[0] = min(low[0], x), high[0] = max(high[0], x);
    low[1] = min(low[1], y), high[1] = max(high[1], y);
    far = max(far, q.z);
}

bool BeamBuilder::narrow() const { return all(ahead > 0.f); }

Beam BeamBuilder::beam() const {
    // Widen the beam by the rounding errors of the ratios and of the rays' directions
    constexpr float kSlack = 1e-5f;
    Beam b = {origin, {}, {0, 0, 0, 0, least(-far) * (1 + kSlack)}};
    for (int i = 0; i < 2; ++i) {
        Vec3 axis = i ? frame.v : frame.u;
        b.n[2 * i] = normalize(axis - frame.w * (least(low[i]) - kSlack));
        b.n[2 * i + 1] = normalize(frame.w * (kSlack - least(-high[i])) - axis);
    }
    b.n[4] = -frame.w;
    return b;
}

void findCandidates(const Scene &scene, const Beam &beam, Candidates &found) {
    found.count = 0;
    auto add = [&](int shape, float near) {
        if (found.count == Candidates::kMost) return false;
        int i = found.count++;
        for (; i > 0 && found.near[i - 1] > near; --i) {
            found.near[i] = found.near[i - 1];
            found.shape[i] = found.shape[i - 1];
        }
        found.near[i] = near;
        found.shape[i] = (uint16_t)shape;
        return true;
    };
    for (int i = 0; i < scene.unboundedCount; ++i) add(scene.unbounded[i], 0);
    int stack[7 * kTreeDepth + 8], waiting = 0;
    if (scene.nodeCount) stack[waiting++] = 0;
    while (waiting) {
        const Node &n = scene.nodes[stack[--waiting]];
        Vec3x8 middle = load(n.lo, 0), half;
        if (n.balls) {
            half.x = half.y = half.z = load(n.radius);
        } else {
            Vec3x8 hi = load(n.hi, 0);
            half = (hi - middle) * broadcast(0.5f);
            middle = (hi + middle) * broadcast(0.5f);
        }
        Vec3x8 to = middle - beam.origin;
        Float8 slack = (sumAbs(to) + sumAbs(half)) * 1e-6f;
        Int8 inside = kLanes < n.count;
        for (int i = 0; i < 5; ++i) {
            Vec3 m = beam.n[i];
            Float8 reach = n.balls ? half.x : dot(half, Vec3{abs(m.x), abs(m.y), abs(m.z)});
            inside &= dot(to, m) + reach + slack >= beam.limit[i];
        }
        int lanes = laneBits(inside);
        if (!lanes) continue;
        Vec3x8 outside = {max(abs(to.x) - half.x, 0.f), max(abs(to.y) - half.y, 0.f),
                          max(abs(to.z) - half.z, 0.f)};
        Float8 near = (n.balls ? length(to) - half.x : length(outside)) - slack;
        for (; lanes; lanes &= lanes - 1) {
            int i = __builtin_ctz((unsigned)lanes);
            if (n.child[i] >= 0) {
                stack[waiting++] = n.child[i];
            } else if (!add(~n.child[i], near[i])) {
                found.count = -1;
                return;
            }
        }
    }
    for (int i = 0; i < found.count; ++i) {
        const Shape &s = scene.shapes[found.shape[i]];
        Vec3 f = beam.origin - s.centre;
        float square = dot(f, f), c = square - s.half.x * s.half.x;
        found.ball[i] = {f, s.half.x, c > 0 ? sqrt(c) - sqrt(square) * 1e-6f : -kInfinity};
    }
}

Hit8 intersect(const Scene &scene, const Candidates &candidates, const Vec3 &origin, const Vec3x8 &d,
               Int8 active) {
    if (candidates.count < 0) return intersect(scene, {broadcast(origin), d}, active);
    Hit8 hit = {broadcast(kInfinity), broadcast(-1)};
    for (int i = 0; i < candidates.count && any(hit.t >= candidates.near[i]); ++i) {
        const Shape &s = scene.shapes[candidates.shape[i]];
        if (s.isBall() && candidates.ball[i].misses(d)) continue;
        updateNearest(hit, distance(s, {broadcast(origin), d}), candidates.shape[i]);
    }
    return hit;
}

Rgb8 transmittance(const Scene &scene, const Candidates &candidates, const Ray8 &ray, Float8 tMax,
                   Int8 active, Int8 ignored, bool noBalls) {
    if (candidates.count < 0) return transmittance(scene, ray, tMax, active, ignored, noBalls);
    Rgb8 share = select(active, broadcast(Rgb{1, 1, 1}), broadcast(Rgb{}));
    for (int i = 0; i < candidates.count && any(active); ++i) {
        Int8 tested = active & (ignored != candidates.shape[i]);
        if (!any(tested)) continue;
        const Shape &s = scene.shapes[candidates.shape[i]];
        if (noBalls && s.isBall()) continue;
        Float8 t = s.isBall() ? candidates.ball[i].hit(-ray.d) : distance(s, ray, Flat::BothSides);
        Int8 hit = tested & (t < tMax);
        if (any(hit)) dim(scene, s, hit, share, active);
    }
    return share;
}

} // namespace odraz
