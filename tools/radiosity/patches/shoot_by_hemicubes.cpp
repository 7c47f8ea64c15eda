#include "tools/radiosity/patches/odd_hemicube.h"
#include "tools/radiosity/patches/shooting.h"

#include <algorithm>
#include <stdexcept>

namespace odraz::radiosity {

HemicubeShooter::HemicubeShooter(const Gl &gl, const Model &model, int px, uint32_t turn)
    : model(model), memory(anyHemicubeBytes(px) + 64), sums(formFactorSums(px)), number(turn) {
    Arena arena = {memory.data() + (64 - (uintptr_t)memory.data() % 64), anyHemicubeBytes(px), 0};
    if (!openAnyHemicubes(hemicubes, gl, arena, px))
        throw std::runtime_error("this OpenGL cannot draw integers: install Mesa (libgl1-mesa-dri)");
}

HemicubeShooter::~HemicubeShooter() { closeHemicubes(hemicubes); }

int HemicubeShooter::shoot(Shooting &shooting, int most, Workers &workers) {
    std::vector<Shooting::Shot> shots;
    std::vector<Eye> eyes;
    for (int s : shooting.brightest(std::min(most, hemicubes.batch))) {
        shots.push_back(shooting.take(s));
        const Patch &p = model.patches[shots.back().patch];
        eyes.push_back(hemicubeEye(p.p, p.n, number++));
    }
    if (shots.empty()) return 0;
    drawHemicubes(hemicubes, model, eyes.data(), (int)eyes.size());
    if (rows.size() < shots.size()) rows.resize(shots.size());
    parallelFor(workers, (int)shots.size(), [&](int k, int) {
        rows[(size_t)k].assign((size_t)model.patchCount, 0);
        sumHemicube(hemicubes, k, sums.data(), rows[(size_t)k].data());
    });
    std::vector<const float *> of;
    for (size_t k = 0; k < shots.size(); ++k) of.push_back(rows[k].data());
    shooting.distribute(shots, of, workers);
    return (int)shots.size();
}

} // namespace odraz::radiosity
