// Facets clipped to the faces of a hemicube, in its frame: z is the surface's normal.
//
// A face has four borders: x + w, w - x, y + w (on the four half faces: y) and w - y must not be negative.
#pragma once

#include "base/vec3.h"

namespace odraz {

struct Corner {
    float x, y, w, s, t; // on a face: |x| <= w, y <= w, -w or 0 <= y; place on the chart, in patches
};

// Beyond which borders of the five faces a point lies: four bits a face, the top face's lowest, then those
// that look to +x, +y, -x and -y.
uint32_t outsideFaces(const Vec3 &p);

// Cuts a convex polygon of 3 or 4 corners, which then has `count`, at the borders of which `crossed` has a
// bit. Every border adds one corner at most: they are found in the buffers.
const Corner *clipToFace(const Corner *polygon, int &count, bool top, uint32_t crossed,
                         Corner (&buffers)[2][8]);

} // namespace odraz
