// Two unit squares, at distance 1 or with a common edge. Their form factors have closed forms: Howell, "A
// Catalog of Radiation Heat Transfer Configuration Factors", C-11 and C-14.
#pragma once

#include "radiosity/model.h"

namespace odraz {

struct Squares {
    const char *name;
    Vec3 corner, u, v; // the second square
    double exact;

    // Adds both squares, each divided into 16 x 16 patches. The first one faces up.
    void addTo(Model &m) const {
        m.addRect({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 1 / 16.f);
        m.addRect(corner, u, v, 0, 1 / 16.f);
    }
};
inline constexpr Squares kSquares[] = {{"parallel", {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, 0.19982490},
                                       {"perpendicular", {0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.20004378}};

} // namespace odraz
