#include "tools/radiosity/patches/odd_hemicube.h"

#include <stdexcept>

namespace odraz::radiosity {

std::vector<float> formFactorSums(int px) {
    std::vector<float> all((size_t)(3 * px * (px + 1)));
    int fine = px % 2 ? 2 * px : px;
    std::vector<float> delta((size_t)(3 * fine * fine));
    deltaFormFactors(fine, delta.data());
    if (px % 2 == 0) {
        accumulateFormFactors(px, delta.data(), all.data());
        return all;
    }
    // A pixel is four pixels of half its size
    float *sums = all.data();
    int h = px / 2;
    for (int y = 0; y < 3 * px; ++y) {
        int first = 2 * y, end = first + 2, row = y < px ? -1 : (y - px) % px;
        if (row == h - 1) ++end;
        if (row == h) end = first;
        if (row == h + 1) --first;
        double sum = 0;
        *sums++ = 0;
        for (int x = 0; x < px; ++x) {
            for (int line = first; line < end; ++line)
                for (int k = 0; k < 2; ++k) sum += (double)delta[(size_t)(line * fine + 2 * x + k)];
            *sums++ = (float)sum;
        }
    }
    return all;
}

// The memory for the next even number of pixels is enough
AnyHemicubes::AnyHemicubes(const Gl &gl, int px) : memory(bytesFor(px)), sums(formFactorSums(px)) {
    if (!openHemicubes(h, gl, memory.arena, px + px % 2))
        throw std::runtime_error("this OpenGL cannot draw integers: install Mesa (libgl1-mesa-dri)");
    h.px = px;
}

const std::vector<std::vector<float>> &AnyHemicubes::rows(const Model &m, std::span<const Eye> eyes,
                                                          Workers &workers) {
    drawHemicubes(h, m, eyes.data(), (int)eyes.size());
    found.resize(eyes.size() / (size_t)h.turns);
    parallelFor(workers, (int)found.size(), [&](int k, int) {
        found[(size_t)k].assign((size_t)m.patchCount, 0);
        for (int j = 0; j < h.turns; ++j)
            sumHemicube(h, k * h.turns + j, sums.data(), found[(size_t)k].data());
    });
    return found;
}

bool findRowsFrom(AnyHemicubes &hemicubes, const Model &m, const uint8_t *lit, Workers &workers, Arena &arena,
                  FormFactors &factors, const Progress &progress, int step, const EyeOf &eyeOf) {
    const Hemicubes &h = hemicubes.h;
    auto count = (size_t)m.patchCount, batch = (size_t)(h.batch / h.turns);
    factors.rows = arena.take<Row>(count);
    factors.used = 0;
    if (arena.full) return false;
    for (size_t i = 0, next = 0; i < count;) {
        std::vector<Eye> eyes;
        std::vector<size_t> patches;
        for (; i < count && patches.size() < batch; ++i, next = (next + (size_t)step) % count) {
            const Patch &p = m.patches[next];
            if (p.share == 0 || lit[next] != kReflects) continue;
            for (int k = 0; k < h.turns; ++k)
                eyes.push_back(eyeOf ? eyeOf((int)next, k)
                                     : hemicubeEye(p.p, p.n, (uint32_t)next + (uint32_t)k * 0x9e3779b9u));
            patches.push_back(next);
        }
        const auto &rows = hemicubes.rows(m, eyes, workers);
        if (workers.aborted()) return false;
        for (size_t k = 0; k < patches.size(); ++k) {
            Row &to = factors.rows[patches[k]];
            to.links = factors.links + factors.used;
            for (size_t j = 0; j < count; ++j) {
                if (rows[k][j] == 0 || lit[j] == kUnlit) continue;
                if (factors.used == factors.capacity) return false;
                factors.links[factors.used++] = {(uint32_t)j, rows[k][j] / (float)h.turns};
                ++to.count;
            }
            to.known = true;
        }
        progress((float)i / (float)count);
    }
    return true;
}

} // namespace odraz::radiosity
