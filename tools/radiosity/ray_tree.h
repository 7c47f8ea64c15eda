// Triangles that rays meet, as many as there is memory for: a tree of boxes with eight children, eight
// triangles side by side at its ends. A ray goes alone, against eight boxes or triangles at once, so that it
// does not matter where its neighbours go.
//
// Triangles are met from both sides. Where neighbours share corners no ray passes between (Woop, Benthin and
// Wald, "Watertight Ray/Triangle Intersection", JCGT 2013). A ray's time grows with the logarithm of their
// number.
#pragma once

#include "base/vec3.h"

#include <array>
#include <cstddef>
#include <vector>

namespace odraz {

struct RayHit {
    float t = kInfinity; // along the direction as it is given
    int triangle = -1;   // -1: nothing is met
    bool back = false;   // it runs clockwise as seen from the origin
};

class RayTree {
public:
    using Corners = std::array<Vec3, 3>;
    explicit RayTree(const std::vector<Corners> &triangles);

    // What is met first behind the origin. Where a front and a back lie in one plane, as where both sides of
    // a sheet are given, it is the front.
    RayHit nearest(const Vec3 &origin, const Vec3 &direction) const;
    // The first that is met from its front: backs are looked through.
    RayHit nearestFront(const Vec3 &origin, const Vec3 &direction) const;
    // Whether anything is met before `end`, from whichever side.
    bool blocked(const Vec3 &origin, const Vec3 &direction, float end) const;

    // What a tree of so many triangles takes, and while it is made.
    static size_t bytesFor(size_t triangles) { return triangles * 270; }

private:
    struct alignas(32) Node {
        float lo[3][8], hi[3][8];
        int child[8]; // a node, or ~leaf
    };
    struct alignas(32) Leaf {
        float corner[3][3][8]; // [corner][axis][triangle]
        int number[8];         // -1: none
    };
    struct Builder;
    struct Ray;
    std::vector<Node> nodes;
    std::vector<Leaf> leaves;
    template <bool kFronts> RayHit find(const Vec3 &origin, const Vec3 &direction) const;
};

} // namespace odraz
