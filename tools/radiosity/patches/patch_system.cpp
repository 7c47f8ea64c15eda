#include "tools/radiosity/patches/patch_system.h"

#include "tools/radiosity/divide/facets.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <sys/mman.h>

namespace odraz::radiosity {

void PatchSystem::Unmap::operator()(void *memory) const { munmap(memory, bytes); }

PatchSystem::PatchSystem(size_t bytes) {
    void *block =
        mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (block == MAP_FAILED)
        throw std::runtime_error("the system cannot reserve that much memory: lower --memory");
    memory = {block, Unmap{bytes}};
    arena = {(unsigned char *)block, bytes, 0};
    model = std::make_unique<Model>();
    scene = std::make_unique<Scene>();
}

std::vector<float> PatchSystem::lampsSeen(const std::vector<Rgb> &emits, Workers &workers) const {
    const System &s = radiosity.system;
    std::vector<float> lamps((size_t)s.patches * (size_t)s.columns), seen(lamps.size());
    for (int i = 0; i < s.patches; ++i) setColour(lamps.data(), i, emits[(size_t)model->patches[i].chart]);
    findIndirect(radiosity.factors, s.patches, s.columns, lamps.data(), seen.data(), workers);
    return seen;
}

std::vector<Glow> findLamps(const Mesh &mesh, const Regions &regions, const Model &model, int samples) {
    std::vector<Glow> glows;
    double largest = 0;
    for (int i = 0; i < model.facetCount; ++i) {
        const auto &e = mesh.materials[(size_t)regions.material[(size_t)model.facets[i].chart]].emits;
        if (e[0] + e[1] + e[2] == 0) continue;
        glows.push_back({i, 1, {e[0], e[1], e[2]}});
        largest = std::max(largest, areaOf(outlineOf(model.facets[i])));
    }
    for (Glow &g : glows)
        g.cells = std::max(1, (int)std::lround(samples * areaOf(outlineOf(model.facets[g.facet])) / largest));
    return glows;
}

} // namespace odraz::radiosity
