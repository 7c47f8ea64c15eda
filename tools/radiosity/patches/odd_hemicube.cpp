#include "tools/radiosity/patches/odd_hemicube.h"

namespace odraz::radiosity {

bool openAnyHemicubes(Hemicubes &h, const Gl &gl, Arena &arena, int px) {
    // The memory for the next even number is enough
    bool opened = openHemicubes(h, gl, arena, px + px % 2);
    h.px = px;
    return opened;
}

size_t anyHemicubeBytes(int px) { return hemicubeBytes(px + px % 2); }

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

bool findRowsFrom(Hemicubes &h, const Model &m, const uint8_t *lit, Workers &workers, Arena &arena,
                  FormFactors &factors, const Progress &progress, int step, const EyeOf &eyeOf) {
    auto count = (size_t)m.patchCount;
    factors.rows = arena.take<Row>(count);
    factors.used = 0;
    if (arena.full) return false;
    const std::vector<float> sums = formFactorSums(h.px);
    std::vector<std::vector<float>> rows((size_t)(h.batch / h.turns));
    for (size_t i = 0, next = 0; i < count;) {
        std::vector<Eye> eyes;
        std::vector<size_t> patches;
        for (; i < count && patches.size() < rows.size(); ++i, next = (next + (size_t)step) % count) {
            const Patch &p = m.patches[next];
            if (p.share == 0 || lit[next] != kReflects) continue;
            for (int k = 0; k < h.turns; ++k)
                eyes.push_back(
                    eyeOf ? eyeOf((int)next, k)
                          : hemicubeEye(p.p, p.n, (uint32_t)next + h.turn + (uint32_t)k * 0x9e3779b9u));
            patches.push_back(next);
        }
        drawHemicubes(h, m, eyes.data(), (int)eyes.size());
        parallelFor(workers, (int)patches.size(), [&](int k, int) {
            std::vector<float> &row = rows[(size_t)k];
            row.assign(count, 0);
            for (int j = 0; j < h.turns; ++j) sumHemicube(h, k * h.turns + j, sums.data(), row.data());
        });
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
