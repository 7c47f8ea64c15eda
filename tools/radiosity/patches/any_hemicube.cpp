#include "tools/radiosity/patches/any_hemicube.h"

#include "tools/radiosity/solution/solve_task.h"

#include <numeric>
#include <stdexcept>

namespace odraz::radiosity {

static constexpr char kNoIntegers[] = "this OpenGL cannot draw integers: install Mesa (libgl1-mesa-dri)";

std::vector<float> formFactorSums(int px) {
    std::vector<float> all((size_t)(3 * px * (px + 1)));
    int fine = px % 2 ? 2 * px : px;
    std::vector<float> delta((size_t)(3 * fine * fine));
    deltaFormFactors(fine, delta.data());
    if (px % 2 == 0) {
        accumulateFormFactors(px, delta.data(), all.data());
        return all;
    }
    // Add the four pixels of half the size that make up a pixel
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

// Memory for the next even number of pixels is enough.
AnyHemicubes::AnyHemicubes(const Gl &gl, int px)
    : memory(hemicubeBytes(px + px % 2)), sums(formFactorSums(px)) {
    if (!openHemicubes(h, gl, memory.arena, px + px % 2)) throw std::runtime_error(kNoIntegers);
    h.px = px;
}

void AnyHemicubes::draw(const Model &m, std::span<const Eye> eyes) {
    if (!drawHemicubes(h, m, eyes.data(), (int)eyes.size())) throw std::runtime_error(kNoIntegers);
}

const std::vector<std::vector<float>> &AnyHemicubes::rows(const Model &m, std::span<const Eye> eyes,
                                                          Workers &workers) {
    draw(m, eyes);
    found.resize(eyes.size());
    parallelFor(workers, (int)found.size(), [&](int k, int) {
        found[(size_t)k].assign((size_t)m.patchCount, 0);
        sumHemicube(h, k, sums.data(), found[(size_t)k].data());
    });
    return found;
}

bool findRows(AnyHemicubes &hemicubes, const Model &m, const RowSettings &settings, FormFactorRows &rows,
              Workers &workers, const std::function<bool(float)> &progress) {
    const auto &[lit, memory, each, eyeOf] = settings;
    auto count = (size_t)m.patchCount, batch = (size_t)(hemicubes.h.batch / each), links = (size_t)0;
    auto step = (size_t)((double)count * 0.6180339) | 1;
    while (std::gcd(step, count) != 1) step += 2;
    for (size_t i = 0, next = 0; i < count;) {
        std::vector<Eye> eyes;
        std::vector<size_t> patches;
        for (; i < count && patches.size() < batch; ++i, next = (next + step) % count) {
            const Patch &p = m.patches[next];
            if (p.share == 0 || !lit[next]) continue;
            for (int k = 0; k < each; ++k)
                eyes.push_back(eyeOf ? eyeOf(m, (int)next, k)
                                     : hemicubeEye(p.p, p.n, (uint32_t)next + (uint32_t)k * 0x9e3779b9u));
            patches.push_back(next);
        }
        const auto &found = hemicubes.rows(m, eyes, workers);
        for (size_t k = 0; k < patches.size(); ++k) {
            std::vector<Link> &row = rows.of[patches[k]];
            for (size_t j = 0; j < count; ++j) {
                float sum = 0;
                for (size_t e = 0; e < (size_t)each; ++e) sum += found[k * (size_t)each + e][j];
                if (sum > 0 && lit[j]) row.push_back({(uint32_t)j, sum / (float)each});
            }
            row.shrink_to_fit();
            rows.known[patches[k]] = true;
            links += row.size();
        }
        if (size_t bytes = links * sizeof(Link) / i * count; bytes > memory)
            refuseMemory(bytes, memory, "larger patches or elements need less");
        if (!progress((float)i / (float)count)) return false;
    }
    return true;
}

} // namespace odraz::radiosity
