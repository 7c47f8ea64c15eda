#include "tools/radiosity/solve/scaled.h"

#include <cmath>

namespace odraz::radiosity {

namespace {

constexpr float Rgb::*kChannels[3] = {&Rgb::x, &Rgb::y, &Rgb::z};

bool near(float a, float b) { return std::fabs(a - b) <= 1e-6f * std::fabs(a); }

// The factor of one channel of all lamps.
struct Factor {
    float value = 1;
    bool known = false, same = true;

    void see(float before, float now) {
        if (before > 0) {
            float f = now / before;
            same &= std::isfinite(f) && (!known || near(value, f));
            if (!known) value = f, known = true;
        } else
            same &= now == 0;
    }
};

} // namespace

bool scaleLight(Solution &b, const Mesh &mesh, const PreparedSolve &prepared, const SolveSettings &settings) {
    const std::vector<int> &material = prepared.regions.material;
    if (settings.surroundings.any() || !prepared.direct.outside.empty() || !b.cellReflects.empty() ||
        material.size() != b.charts.size())
        return false;
    Factor factors[3];
    std::vector<Rgb> emits;
    for (size_t i = 0; i < material.size(); ++i) {
        const MeshMaterial &m = mesh.materials[(size_t)material[i]];
        for (size_t k = 0; k < 3; ++k) {
            if (b.reflects[i].*kChannels[k] != m.reflects[k]) return false;
            factors[k].see(b.emits[i].*kChannels[k], m.emits[k]);
        }
        emits.push_back({m.emits[0], m.emits[1], m.emits[2]});
    }
    // In a fresh solution, a colour that becomes 0 alone no longer counts for the residual
    bool lit = false, dark = false;
    const Factor *one = nullptr;
    for (const Factor &f : factors) {
        if (!f.same) return false;
        if (!f.known) continue;
        (f.value > 0 ? lit : dark) = true;
        if (settings.way == Way::kRays && one && !near(one->value, f.value)) return false;
        one = &f;
    }
    if (!one || (lit && dark) || (dark && settings.evenSky)) return false;
    for (Rgb &light : b.light) light = light * Rgb{factors[0].value, factors[1].value, factors[2].value};
    b.emits = std::move(emits);
    return true;
}

} // namespace odraz::radiosity
