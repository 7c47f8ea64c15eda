// Finds the triangles that rays hit, in double precision, for references to compare solutions with.
//
// The code shares nothing with the trees of intro/trace and rays/, because a reference must not have the
// faults that it should find. Triangles are in a tree of boxes with four children, which halve them twice
// along the longest axis, and are tested by Moeller and Trumbore's method (1997).
#pragma once

#include "tools/support/vec3d.h"

#include <array>
#include <vector>

namespace odraz::radiosity {

class Obstacles {
public:
    using Triangle = std::array<Vec3d, 3>;
    struct Hit {
        double t = INFINITY; // distance, in lengths of the direction; infinity: no hit
        int number = -1;     // index of the triangle; -1: no hit
        bool back = false;   // the triangle is clockwise as seen from the origin

        bool met() const { return number >= 0; }
    };
    explicit Obstacles(const std::vector<Triangle> &triangles);

    // The first hit. If a front and a back lie in one plane, as in a two-sided sheet, it is the front.
    Hit nearest(Vec3d origin, Vec3d direction) const;
    // Whether anything lies before `end`; fronts and backs both count.
    bool blocked(Vec3d origin, Vec3d direction, double end) const;

private:
    typedef double Double4 __attribute__((vector_size(32)));
    typedef int64_t Mask4 __attribute__((vector_size(32)));
    struct Node {
        Double4 bound[2][3]; // [low, high][axis] of the four children; low > high for unused ones
        int child[4];        // index of a node, or ~index of a leaf
    };
    struct Leaf {
        Double4 corner[3][3]; // [corner][axis] of four triangles
        int number[4];        // -1: none
    };
    struct Builder;
    struct LeafHits;
    std::vector<Node> nodes;
    std::vector<Leaf> leaves;

    static LeafHits intersect(const Leaf &leaf, Vec3d origin, Vec3d direction);
    template <class Visit> void walk(Vec3d origin, Vec3d direction, const double &end, Visit visit) const;
};

} // namespace odraz::radiosity
