#include "tools/radiosity/patches/sees_backs.h"

#include "tools/radiosity/rays/light_grid.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

bool seesBacks(const Model &m, const Mesh &mesh) {
    static constexpr int kPlaces = 500, kAround = 96;
    RayTree tree(cornersOf(mesh));
    for (int i = 0, every = std::max(1, m.patchCount / kPlaces); i < m.patchCount; i += every) {
        const Patch &p = m.patches[i];
        const Chart &c = m.charts[p.chart];
        for (int k = 0; p.share > 0 && k < kAround; ++k) {
            float up = 1 - ((float)k + 0.5f) / kAround, out = std::sqrt(1 - up * up),
                  turn = 2.3999632f * (float)k;
            Vec3 d = c.u * (out * std::cos(turn)) + c.v * (out * std::sin(turn)) + c.n * up;
            if (tree.nearest(p.p + c.n * c.off(), d).back) return true;
        }
    }
    return false;
}

} // namespace odraz::radiosity
