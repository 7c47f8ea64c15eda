// Triangles for the oracles' rays, in double precision.
//
// It shares no code with the tracer's tree (intro/trace) and that of rays/, because an oracle must not have
// the faults that it looks for. Triangles are in a tree of boxes with four children, divided by the surface
// area heuristic in bins (Wald, 2007), and are tested by Moeller and Trumbore's method (1997).
#pragma once

#include "tools/engine/vec3d.h"

#include <array>
#include <vector>

namespace odraz::radiosity {

class Obstacles {
public:
    using Triangle = std::array<Vec3d, 3>;
    struct Hit {
        double t = INFINITY; // in lengths of the direction; infinity: no hit
        int number = -1;     // the triangle's, in their order; -1: no hit
        bool back = false;   // the triangle runs clockwise, as seen from the origin

        bool met() const { return number >= 0; }
    };
    explicit Obstacles(const std::vector<Triangle> &triangles);

    // The first hit. If the front and the back of a sheet lie in one plane, it is the front.
    Hit nearest(Vec3d origin, Vec3d direction) const;
    // Whether anything lies before `end`; fronts and backs both count.
    bool blocked(Vec3d origin, Vec3d direction, double end) const;

private:
    typedef double Double4 __attribute__((vector_size(32)));
    typedef int64_t Mask4 __attribute__((vector_size(32)));
    struct Node {
        Double4 bound[2][3]; // low and high ends of the four children on each axis; reversed for empty ones
        int child[4];        // a node, or ~leaf
    };
    struct Leaf {
        Double4 corner[3][3]; // [corner][axis], four triangles side by side
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
