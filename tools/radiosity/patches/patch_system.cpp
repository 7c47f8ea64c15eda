#include "tools/radiosity/patches/patch_system.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

std::vector<Rgb> PatchSystem::reflectDirect() const {
    std::vector<Rgb> all;
    for (size_t i = 0; i < patches.size(); ++i) all.push_back(patches[i].reflects * direct[i]);
    return all;
}

float PatchSystem::sweep(std::vector<Rgb> &b, bool atOnce) const {
    Rgb put = {}, changed = {};
    std::vector<Rgb> before;
    if (!atOnce) before = b;
    for (size_t i = 0; i < patches.size(); ++i) {
        const Rgb &reflects = patches[i].reflects;
        Rgb now = reflects * (direct[i] + rows.gather((int)i, atOnce ? b : before));
        put += reflects * direct[i];
        changed += {std::fabs(now.x - b[i].x), std::fabs(now.y - b[i].y), std::fabs(now.z - b[i].z)};
        b[i] = now;
    }
    auto share = [](float a, float of) { return of > 0 ? a / of : 0; };
    return std::max({share(changed.x, put.x), share(changed.y, put.y), share(changed.z, put.z)});
}

} // namespace odraz::radiosity
