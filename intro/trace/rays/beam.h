// Beams: bundles of rays that share an origin, for example from the eye through a part of the picture, or
// from a light to the points that it may light.
//
// Whatever depends on the origin alone is computed once for all rays. Boxes are culled for the whole beam,
// eight boxes at a time, against the sides of a pyramid. The shapes that a beam may touch are its candidates;
// packets of its rays try only these.
#pragma once

#include "trace/rays/intersect.h"

namespace odraz {

// All points p with dot(n[i], p - origin) >= limit[i] for every i.
struct Beam {
    Vec3 origin;
    Vec3 n[5]; // unit
    float limit[5];
};

// The beam whose edges are four directions of any length, in clockwise order as seen from the origin.
Beam beamThrough(const Vec3 &origin, const Vec3 (&corner)[4]);

// Builds the beam from an origin to points that are added eight at a time, as vectors from the origin.
// narrow(): whether all of them are within about 80 degrees of `towards`; only then is beam() valid.
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

// A ball, prepared for rays from a common origin. One dot product rejects most misses. Its bound is loose, so
// hitBall() decides about the others.
struct SharedBall {
    Vec3 f; // from its centre to the origin
    float radius, cosine;

    ODRAZ_INLINE bool misses(Vec3x8 d) const { return !any(-dot(d, f) >= cosine); }
    ODRAZ_INLINE Float8 hit(Vec3x8 d) const {
        return misses(d) ? broadcast(kInfinity) : hitBall(broadcast(f), broadcast(radius), d);
    }
};

struct Candidates {
    static constexpr int kMost = 48;
    int count; // -1: more than kMost
    uint16_t shape[kMost];
    float near[kMost];      // lower bounds of the distance, ascending
    SharedBall ball[kMost]; // for shapes that are balls
};
// Finds the shapes that a beam may touch.
void findCandidates(const Scene &scene, const Beam &beam, Candidates &found);

// Like intersect() and transmittance() of intersect.h, for rays from or to one origin. They try only the
// candidates of the rays' beam, or traverse the tree if there were too many of these. Shadow rays start at
// the lit point, not at the light: from a distant light, rounding errors would confuse a wall with the floor.
Hit8 intersect(const Scene &scene, const Candidates &candidates, const Vec3 &origin, const Vec3x8 &d,
               Int8 active);
Rgb8 transmittance(const Scene &scene, const Candidates &candidates, const Ray8 &ray, Float8 tMax,
                   Int8 active, Int8 ignored, bool noBalls = false);

} // namespace odraz
