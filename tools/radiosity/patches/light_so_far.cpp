#include "tools/radiosity/patches/patch_solver.h"

#include "radiosity/ties.h"

namespace odraz::radiosity {

std::vector<Rgb> PatchSolver::lightSoFar(const float *radiosity) const {
    size_t texels = (size_t)m.texelCount, room = texels + 8;
    std::vector<float> planes[3], unused(room);
    for (auto &plane : planes) plane.resize(room);
    if (radiosity) {
        // Do what the solver's last steps do, in separate memory and on one thread: the workers may be
        // running the caller
        Workers alone = serialWorkers();
        Radiosity r = this->r;
        size_t columns = (size_t)r.system.columns, all = (size_t)m.patchCount * columns;
        std::vector<float> shown(radiosity, radiosity + all), indirect(all);
        for (int i = 0; !s.analytic && i < m.patchCount; ++i)
            p.setColour(shown.data(), i,
                        p.colourIn(radiosity, i) + task.solution.emits[(size_t)m.patches[i].chart]);
        findIndirect(r.factors, m.patchCount, r.system.columns, shown.data(), indirect.data(), alone);
        r.system.indirect = indirect.data();
        for (int k = 0; k < 3; ++k)
            for (int c = 0; c < 3; ++c) r.bounced[k][c] = k == c ? planes[k].data() : unused.data();
        spreadLight(r, m, alone);
    }
    std::vector<Rgb> light(texels);
    float Rgb::*const channels[3] = {&Rgb::x, &Rgb::y, &Rgb::z};
    for (int k = 0; k < 3; ++k) {
        float *plane = planes[k].data();
        for (size_t t = 0; t < texels; ++t) plane[t] += r.direct[k][t];
        settle(m, plane);
        for (size_t t = 0; t < texels; ++t) light[t].*channels[k] = plane[t];
    }
    return light;
}

} // namespace odraz::radiosity
