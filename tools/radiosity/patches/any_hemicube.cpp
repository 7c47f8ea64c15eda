#include "tools/radiosity/patches/any_hemicube.h"

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

} // namespace odraz::radiosity
