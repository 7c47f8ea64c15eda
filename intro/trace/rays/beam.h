// Beams: rays that share an origin, tried together.
//
// Rays from the eye through a part of the picture, or from a light to what it may shine on. What the origin
// decides is computed once, and boxes are culled for all of them at once: eight boxes by the sides of a
// pyramid. A beam can gather the shapes that it may touch, as candidates for many packets of rays.
#pragma once

#include "trace/rays/intersect.h"

namespace odraz {

// All points p with dot(n[i], p - origin) >= limit[i] for every i.
struct Beam {
    Vec3 origin;
    Vec3 n[5]; // unit
    float limit[5];
};

// The beam between four directions, in order around it, seen from within clockwise.
Beam beamThrough(const Vec3 &origin, const Vec3 (&corner)[4]);

// The beam from an origin to points that are added packet by packet. narrow(): it is at most some 80 degrees
// wide; beam() is valid only then.
class BeamBuilder {
public:
    BeamBuilder(const Vec3 &origin, const Vec3 &towards);
    void add(const Vec3x8 &fromOrigin);
    bool narrow() const;
    Beam beam() const;

private:
    Vec3 origin;
    Mat3 frame;
    Float8 low[2], high[2], far, ahead;
};

// A ball seen from a common origin: whether a ray comes near it is a question of one cosine. That bound is
// generous; the robust test judges.
struct SharedBall {
    Vec3 f; // from its centre to the origin
    float radius, cosine;

    ODRAZ_INLINE Float8 hit(Vec3x8 d) const {
        if (!any(-dot(d, f) >= cosine)) return broadcast(kInfinity);
        return hitBall(broadcast(f), broadcast(radius), d);
    }
};

struct Candidates {
    static constexpr int kMost = 48;
    int count; // -1: more than kMost
    uint16_t shape[kMost];
    float near[kMost];      // a bound of the distance, rising
    SharedBall ball[kMost]; // where the shape is one
};
void findCandidates(const Scene &scene, const Beam &beam, Candidates &found);

// As intersect() and transmittance(), for rays from or to one origin. They try the candidates of the rays'
// beam, or go through the tree where these were too many. Shadow rays start at the lit place, not at the
// light: from a distant light, rounding could not tell a wall from the floor at its foot.
Hit8 intersect(const Scene &scene, const Candidates &among, const Vec3 &origin, const Vec3x8 &d, Int8 active);
Rgb8 transmittance(const Scene &scene, const Candidates &among, const Ray8 &ray, Float8 far, Int8 active,
                   Int8 own, bool noBalls = false);

} // namespace odraz
