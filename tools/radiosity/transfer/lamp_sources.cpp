#include "tools/radiosity/transfer/lamp_sources.h"

#include "radiosity/light_bases.h"

#include <algorithm>

namespace odraz::radiosity {

std::vector<LampSource> lampsOf(const Mesh &mesh, const Surroundings &around) {
    std::vector<LampSource> lamps;
    std::vector<bool> used(mesh.materials.size());
    for (const Triangle &t : mesh.triangles) used[(size_t)t.material] = true;
    for (size_t i = 0; i < mesh.materials.size(); ++i) {
        const MeshMaterial &m = mesh.materials[i];
        if (!used[i] || !(std::max({m.emits[0], m.emits[1], m.emits[2]}) > 0)) continue;
        // The parts of a picture are one lamp
        auto whole = std::find_if(lamps.begin(), lamps.end(), [&](const LampSource &lamp) {
            return !m.glow.path.empty() && lamp.name == m.name;
        });
        if (whole == lamps.end())
            lamps.push_back({m.name, {i}, {}});
        else
            whole->materials.push_back(i);
    }
    for (size_t i = 0; i < around.lamps.size(); ++i)
        lamps.push_back({"ball " + std::to_string(i + 1), {}, {{}, {}, {around.lamps[i]}}});
    for (size_t i = 0; i < around.suns.size(); ++i)
        lamps.push_back({"sun " + std::to_string(i + 1), {}, {{}, {around.suns[i]}, {}}});
    return lamps;
}

void joinLamps(std::vector<LampSource> &lamps, std::vector<std::string> &notes) {
    if (lamps.size() <= (size_t)kMaxLamps) return;
    LampSource &last = lamps[(size_t)kMaxLamps - 1];
    for (size_t i = (size_t)kMaxLamps; i < lamps.size(); ++i) {
        const LampSource &more = lamps[i];
        last.materials.insert(last.materials.end(), more.materials.begin(), more.materials.end());
        last.around.lamps.insert(last.around.lamps.end(), more.around.lamps.begin(), more.around.lamps.end());
        last.around.suns.insert(last.around.suns.end(), more.around.suns.begin(), more.around.suns.end());
    }
    notes.push_back("there are " + std::to_string(lamps.size()) + " lamps: from lamp " +
                    std::to_string(kMaxLamps) + " on they count as one");
    last.name = "others";
    lamps.resize((size_t)kMaxLamps);
}

} // namespace odraz::radiosity
