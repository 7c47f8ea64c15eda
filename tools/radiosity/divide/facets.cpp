#include "tools/radiosity/divide/facets.h"

#include "tools/support/clip.h"

#include <algorithm>

namespace odraz::radiosity {

// Twice the signed area of a triangle: positive if p is to the left of the line from a to b.
static float side(PlanePoint a, PlanePoint b, PlanePoint p) {
    return (b.u - a.u) * (p.v - a.v) - (b.v - a.v) * (p.u - a.u);
}

Outline outlineOf(const Facet &f) {
    Outline outline;
    for (int k = 0; k < (f.triangle() ? 3 : 4); ++k) outline.push_back({f.u[k], f.v[k]});
    return outline;
}

double areaOf(const Outline &p) {
    double twice = 0;
    for (size_t i = 0; i < p.size(); ++i) {
        const PlanePoint &a = p[i], &b = p[(i + 1) % p.size()];
        twice += (double)a.u * (double)b.v - (double)b.u * (double)a.v;
    }
    return twice / 2;
}

Outline cut(const Outline &in, PlanePoint a, PlanePoint b) {
    return clip(
        in, [&](PlanePoint p) { return side(a, b, p); },
        [](PlanePoint p, PlanePoint q, float t) {
            return PlanePoint{p.u + (q.u - p.u) * t, p.v + (q.v - p.v) * t};
        });
}

int cellAt(const Chart &c, PlanePoint p) {
    float x = p.u / c.width * (float)c.across, y = p.v / c.height * (float)c.down;
    int i = std::min((int)x, c.across - 1), j = std::min((int)y, c.down - 1);
    return c.firstCell + j * c.across + i;
}

} // namespace odraz::radiosity
