// Clips facets to the faces of a hemicube, in its frame, where z is the surface's normal.
//
// Within a face's four borders, x + w, w - x, y + w (y on the four half faces) and w - y are 0 or more.
#pragma once

#include "base/vec3.h"

namespace odraz {

struct FaceCorner {
    float x, y, zero, w; // on a face: |x| <= w, y <= w, -w or 0 <= y; zero: the middle of OpenGL's depths
    float s, t;          // position on the chart, in patches
};

// Returns a bit for each border of the five faces that a point is outside of: four bits a face. The top face
// has the lowest bits; the faces towards +x, +y, -x and -y follow.
uint32_t outsideFaces(const Vec3 &p);

// Cuts a convex polygon of 3 or 4 corners at the borders whose bits are set in `crossed`, and updates
// `count`. Each border adds at most one corner. Returns the polygon, which may be in a buffer.
const FaceCorner *clipToFace(const FaceCorner *polygon, int &count, bool top, uint32_t crossed,
                             FaceCorner (&buffers)[2][8]);

} // namespace odraz
