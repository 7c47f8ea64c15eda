#include "tools/radiosity/growing.h"

#include "radiosity/ties.h"

namespace odraz {

std::vector<Rgb> lightSoFar(const Bake &b, const float *radiosity) {
    if (b.byRays) return b.arrives;
    const Model &m = *b.model;
    size_t texels = (size_t)m.texelCount, room = texels + 8;
    std::vector<float> planes[3], unused(room);
    for (auto &plane : planes) plane.resize(room);
    if (radiosity) {
        // Like the solver's last steps, with memory of its own. Workers may be busy with what calls us
        Workers alone = serialWorkers();
        Radiosity r = b.radiosity;
        size_t columns = (size_t)r.system.columns, all = (size_t)m.patchCount * columns;
        std::vector<float> shown(radiosity, radiosity + all), gathered(all);
        for (size_t i = 0; !b.settings.analytic && i < (size_t)m.patchCount; ++i) {
            Rgb e = b.emits(m.patches[i].chart);
            shown[i * columns] += e.x, shown[i * columns + 4] += e.y, shown[i * columns + 8] += e.z;
        }
        gather(r.factors, m.patchCount, r.system.columns, shown.data(), gathered.data(), alone);
        r.system.gathered = gathered.data();
        for (int k = 0; k < 3; ++k)
            for (int c = 0; c < 3; ++c) r.bounced[k][c] = k == c ? planes[k].data() : unused.data();
        spreadLight(r, m, alone);
    }
    std::vector<Rgb> light(texels);
    float Rgb::*const channels[3] = {&Rgb::x, &Rgb::y, &Rgb::z};
    for (int k = 0; k < 3; ++k) {
        float *plane = planes[k].data();
        for (size_t t = 0; t < texels; ++t) plane[t] += b.radiosity.direct[k][t];
        settle(m, plane);
        for (size_t t = 0; t < texels; ++t) light[t].*channels[k] = plane[t];
    }
    return light;
}

} // namespace odraz
