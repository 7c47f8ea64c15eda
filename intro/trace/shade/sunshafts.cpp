#include "trace/shade/sunshafts.h"

#include "trace/texture/noise.h"

namespace odraz {

namespace {

// A segment of a ray, by t; empty if to <= from.
struct Segment {
    Float8 from, to;

    // The part in which the coordinate start + t speed lies in [low, high].
    Segment within(Float8 start, Float8 speed, float low, float high) const {
        // A speed of almost zero becomes a tiny one, so that the division is safe
        Float8 slow = select(speed < 0.f, -1e-6f, 1e-6f);
        Float8 inverse = 1.f / select(abs(speed) < 1e-6f, slow, speed);
        Float8 a = (low - start) * inverse, b = (high - start) * inverse;
        return {max(from, min(a, b)), min(to, max(a, b))};
    }
    Float8 length() const { return max(to - from, 0.f); }
};

} // namespace

Rgb8 shaftLight(const Sunshafts &shafts, const Vec3x8 &o, const Vec3x8 &d, Float8 hit) {
    const Bounds &room = shafts.room;
    Segment all = {Float8{}, hit};
    const Float8 *from = &o.x, *speeds = &d.x; // x, y, z
    const float *low = &room.lo.x, *high = &room.hi.x;
    for (int k = 0; k < 3; ++k) all = all.within(from[k], speeds[k], low[k], high[k]);
    // Project along the sun's direction to the wall
    float slopeY = shafts.sun.y / shafts.sun.x, slopeZ = shafts.sun.z / shafts.sun.x;
    Float8 depth = room.lo.x - o.x;
    all = all.within(fmadd(depth, slopeY, o.y), fmadd(d.x, -slopeY, d.y), shafts.low, shafts.high);
    Float8 z = fmadd(depth, slopeZ, o.z), speed = fmadd(d.x, -slopeZ, d.z), lit = {};
    if (!any(all.from < all.to)) return Rgb8{};

    // Sum the lit intervals, less the columns' shadows. `wide`: half of a shadow's width on the wall
    float wide = shafts.pillarRadius * sqrt(fmadd(slopeZ, slopeZ, 1.f));
    for (int i = 0; i < shafts.openings; ++i) {
        Segment shaft = all.within(z, speed, shafts.from[i], shafts.to[i]);
        Float8 bright = shaft.length();
        if (!any(bright > 0.f)) continue;
        for (int k = 0; k < shafts.pillars; ++k) {
            float x = shafts.pillarX[k], middle = fmadd(room.lo.x - x, slopeZ, shafts.pillarZ[k]);
            if (middle + wide <= shafts.from[i] || middle - wide >= shafts.to[i]) continue;
            bright -=
                shaft.within(z, speed, middle - wide, middle + wide).within(o.x, d.x, x, room.hi.x).length();
        }
        Vec3x8 cloud = fmadd(d, (shaft.from + shaft.to) * 0.5f, o);
        cloud.y += shafts.drift;
        lit += max(bright, 0.f) * fmadd(noise(cloud), 0.6f, 1.f);
    }
    // Dust scatters forwards
    Float8 towards = fmadd(dot(d, shafts.sun), 0.5f, 0.5f);
    return shafts.scatter * (lit * fmadd(towards * towards, 1.f, 0.6f));
}

} // namespace odraz
