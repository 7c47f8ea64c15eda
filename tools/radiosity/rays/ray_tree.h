// Rays against any number of triangles: a tree of boxes with eight children and leaves of eight triangles. A
// ray is tested against eight boxes or triangles at once, so rays need not be coherent.
//
// Triangles are hit from both sides. No ray passes between neighbours that share corners (Woop, Benthin and
// Wald, "Watertight Ray/Triangle Intersection", JCGT 2013). The time of a ray grows with log N.
#pragma once

#include "base/vec3.h"

#include <array>
#include <cstddef>
#include <vector>

namespace odraz::radiosity {

struct RayHit {
    float t = kInfinity; // distance, in lengths of the direction
    int triangle = -1;   // -1: no hit
    bool back = false;   // the triangle is clockwise as seen from the origin
};

class RayTree {
public:
    using Corners = std::array<Vec3, 3>;
    explicit RayTree(const std::vector<Corners> &triangles);

    // The first hit. If a front and a back lie in one plane, as in a two-sided sheet, it is the front.
    RayHit nearest(const Vec3 &origin, const Vec3 &direction) const;
    // The first front that is hit; backs are transparent.
    RayHit nearestFront(const Vec3 &origin, const Vec3 &direction) const;
    // Whether a triangle, front or back, lies before `end`. `n`: the normal of a surface on which the ray
    // ends; triangles parallel to it must lie clearly before `end`.
    bool blocked(const Vec3 &origin, const Vec3 &direction, float end, const Vec3 *n = nullptr) const;

    // The bytes that a tree of this number of triangles needs, including those for building it.
    static size_t bytesFor(size_t triangles) { return triangles * 270; }

private:
    struct alignas(32) Node {
        float lo[3][8], hi[3][8];
        int child[8]; // index of a node, or ~index of a leaf
    };
    struct alignas(32) Leaf {
        float corner[3][3][8]; // [corner][axis][triangle]
        int number[8];         // -1: none
        Vec3 point(int k, int i) const { return {corner[k][0][i], corner[k][1][i], corner[k][2][i]}; }
    };
    struct Builder;
    struct Ray;
    std::vector<Node> nodes;
    std::vector<Leaf> leaves;
    float wider = 0; // largest rounding error of a coordinate; boxes are enlarged by it
    template <bool kFronts> RayHit find(const Vec3 &origin, const Vec3 &direction, bool repeated) const;
};

} // namespace odraz::radiosity
