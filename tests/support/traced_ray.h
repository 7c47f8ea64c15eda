// Traces single rays with all their bounces through small scenes, for tests of shading.
#pragma once

#include "tests/support/shapes.h"
#include "trace/shade/whitted.h"

namespace odraz {

// Twelve bounces, and no cutoff for faint rays.
inline constexpr Quality kExact = {.grid = 1, .depth = 12, .cutoff = 1e-6f};
// No beam: all shapes are candidates.
inline constexpr Candidates kAll = {-1, {}, {}, {}};

// Traces samples at points (x, y) of a picture, each as wide as a pixel.
inline std::vector<Sample> samplesAt(const Scene &scene, const View &view, QualityName quality,
                                     const std::vector<float> &x, const std::vector<float> &y) {
    auto scratch = std::make_unique<TraceScratch>();
    std::vector<Sample> samples(x.size());
    std::vector<uint32_t> index(x.size());
    std::iota(index.begin(), index.end(), 0u);
    traceSamples(scene, view, kQualities[(int)quality], *scratch,
                 {kAll, 1, (int)x.size(), x.data(), y.data(), index.data()}, samples.data());
    return samples;
}

struct RayTracer {
    std::unique_ptr<Scene> scene = emptyScene();
    std::unique_ptr<TraceScratch> scratch = std::make_unique<TraceScratch>();

    // Traces the ray from eye to target. The picture has one pixel of some 40 degrees; the sample is `size`
    // pixels wide.
    Sample trace(Vec3 eye, Vec3 target, const Quality &quality = kExact, float size = 1e-4f) {
        scene->finish();
        View view = lookAt(eye, target, 0, 40, 1, 1);
        float half[8] = {0.5f};
        uint32_t zero[8] = {};
        Sample s;
        traceSamples(*scene, view, quality, *scratch, {kAll, size, 1, half, half, zero}, &s);
        return s;
    }
};

} // namespace odraz
