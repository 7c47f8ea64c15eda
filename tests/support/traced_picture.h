// Traces and develops pictures of the film's scenes and of test scenes, for tests of adaptive sampling.
#pragma once

#include "show/show.h"
#include "tests/support/pictures.h"
#include "tests/support/shapes.h"
#include "tests/support/threads.h"
#include "tools/picture/psnr.h"
#include "tools/support/heap_arena.h"
#include "trace/picture/development.h"
#include "trace/picture/tracer.h"

namespace odraz {

constexpr CameraKey kTableView = {0, {2, 2.5f, 5.9f}, {0, 0.4f, 0}, 0, 36};

// Returns a scene that contains one shape, which emits light.
inline std::unique_ptr<Scene> shining(const Rgb &radiance, const Shape &shape) {
    auto s = emptyScene();
    Material bright = {};
    bright.emit = radiance;
    s->add(bright);
    s->add(shape);
    s->finish();
    return s;
}

struct TracedPicture {
    HeapArena memory;
    std::vector<uint16_t> shapes;
    Frame frame;
    int64_t samples;

    uint8_t at(int pixel, int channel) const { return frame.rgba[(size_t)pixel * 4 + (size_t)channel]; }
    uint8_t at(int x, int y, int channel) const { return at(y * frame.width + x, channel); }
};

inline TracedPicture traced(Scene &posed, const CameraKey &camera, const Quality &quality, int width,
                            int height, int threads = 2, bool shapes = false) {
    size_t bytes = ((size_t)width + 8) * (size_t)height * 16 + (size_t)threads * kTileScratchBytes + 8192;
    TracedPicture p = {HeapArena(bytes), {}, {}, 0};
    Arena &arena = p.memory.arena;
    Threads pool(threads);
    Tracer tracer;
    EXPECT_TRUE(makeTracer(tracer, arena, threads) && makeFrame(p.frame, arena, width, height));
    if (shapes) {
        p.shapes.resize((size_t)p.frame.stride * (size_t)height);
        p.frame.shapes = p.shapes.data();
    }
    View view = lookAt(camera.eye, camera.target, camera.roll, camera.fov, width, height);
    traceFrame(tracer, pool.workers, posed, view, quality, p.frame);
    p.samples = tracedSamples(tracer);
    ToneCurve curve;
    makeToneCurve(curve);
    develop(curve, p.frame, pool.workers, posed.exposure, 0);
    return p;
}

// Returns the film's camera of a scene at a row. Scenes need it to choose their detail.
inline CameraKey scripted(int scene, float row) {
    const Shot *shot = kFilm.shots;
    while (shot->scene != scene) ++shot;
    return pose(shot->path, row);
}

inline std::unique_ptr<Scene> posed(int scene, float row) {
    auto s = emptyScene();
    kScenes[scene].pose({row, scripted(scene, row), nullptr, {}}, *s);
    s->finish();
    return s;
}

inline TracedPicture traced(int scene, float row, const CameraKey &camera, const Quality &quality, int width,
                            int height, int threads = 2) {
    return traced(*posed(scene, row), camera, quality, width, height, threads);
}

inline double decibels(const TracedPicture &a, const TracedPicture &b) {
    auto bytes = [](const Frame &f) { return bytesOf({f.width, f.height, f.rgba}); };
    return pictures::psnr(pictures::squares(bytes(a.frame), bytes(b.frame)),
                          (size_t)(a.frame.width * a.frame.height * 3));
}

} // namespace odraz
