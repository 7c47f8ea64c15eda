// Measures the making of a picture without changes to the engine: the linker (--wrap) redirects calls of some
// engine functions to this file, which calls the originals. The film is linked without it.
#include "maker/panel/inspector.h"
#include "show/show.h"
#include "trace/picture/development.h"
#include "trace/picture/enlarge.h"
#include "trace/picture/tracer.h"
#include "trace/shade/whitted.h"

namespace odraz::maker {

namespace {

Probe *theProbe; // used by the wrapped functions

// Adds the duration of its lifetime to a part's time.
struct Timed {
    Probe *probe = theProbe;
    int64_t begin = probe ? probe->clock() : 0;
    PicturePart part;
    explicit Timed(PicturePart part) : part(part) {}
    ~Timed() {
        if (probe) probe->spent[(int)part] += probe->clock() - begin;
    }
};

} // namespace

void watchPictures(Probe *probe) { theProbe = probe; }

// Calls of a wrapped function go to __wrap_NAME; the original is __real_NAME, where NAME is its mangled name.
// clang-format off
#define ODRAZ_WRAPPED(type, name, mangled, ...) \
    type name##Itself(__VA_ARGS__) asm("__real_" mangled); \
    type name##Watched(__VA_ARGS__) asm("__wrap_" mangled); \
    [[gnu::used]] type name##Watched(__VA_ARGS__)
// clang-format on

ODRAZ_WRAPPED(Posed, poseAt, "_ZN5odraz6poseAtERKNS_4FilmEdPKNS_9CameraKeyE", const Film &film,
              double seconds, const CameraKey *camera) {
    Timed timed(PicturePart::Posing);
    return poseAtItself(film, seconds, camera);
}

ODRAZ_WRAPPED(
    void, traceFrame,
    "_ZN5odraz10traceFrameERNS_6TracerERNS_7WorkersERKNS_5SceneERKNS_4ViewERKNS_7QualityERNS_5FrameE",
    Tracer &tracer, Workers &workers, const Scene &scene, const View &view, const Quality &quality,
    Frame &frame) {
    Timed timed(PicturePart::Tracing);
    traceFrameItself(tracer, workers, scene, view, quality, frame);
}

ODRAZ_WRAPPED(void, spreadGlare, "_ZN5odraz11spreadGlareERNS_5GlareERKNS_5FrameERNS_7WorkersE", Glare &glare,
              const Frame &frame, Workers &workers) {
    Timed timed(PicturePart::Glare);
    spreadGlareItself(glare, frame, workers);
}

ODRAZ_WRAPPED(void, develop,
              "_ZN5odraz7developERKNS_9ToneCurveERNS_5FrameERNS_7WorkersEfjPKNS_5GlareERKNS_10CameraLookE",
              const ToneCurve &curve, Frame &frame, Workers &workers, float exposure, uint32_t seed,
              const Glare *glare, const CameraLook &look) {
    Timed timed(PicturePart::Development);
    developItself(curve, frame, workers, exposure, seed, glare, look);
}

ODRAZ_WRAPPED(void, enlarge, "_ZN5odraz7enlargeEPKhiiPhiiRNS_7WorkersE", const uint8_t *from, int width,
              int height, uint8_t *to, int toWidth, int toHeight, Workers &workers) {
    Timed timed(PicturePart::Enlarging);
    enlargeItself(from, width, height, to, toWidth, toHeight, workers);
}

// Adds samples to the map. Squares at the right and the lower edge may have corners outside: these count for
// the pixel at the edge. A grid of samples in every pixel has none outside, but its rows are padded to a
// multiple of eight; the padding is not counted.
static void count(Probe &p, bool grid, int count, const float *x, const float *y) {
    for (int i = 0; i < count; ++i) {
        if (grid && x[i] > (float)p.width) continue;
        int column = min((int)x[i], p.width - 1), row = min((int)y[i], p.height - 1);
        __atomic_fetch_add(p.samples + (ptrdiff_t)row * p.width + column, 1, __ATOMIC_RELAXED);
    }
}

ODRAZ_WRAPPED(void, traceSamples,
              "_ZN5odraz12traceSamplesERKNS_5SceneERKNS_4ViewERKNS_7QualityERNS_12TraceScratchERKNS_"
              "12SamplePointsERKNS_7SamplesE",
              const Scene &scene, const View &view, const Quality &quality, TraceScratch &scratch,
              const SamplePoints &points, const Samples &to) {
    if (Probe *p = theProbe;
        p && p->samples && view.width == (float)p->width && view.height == (float)p->height)
        count(*p, quality.grid > 0, points.count, points.x, points.y);
    traceSamplesItself(scene, view, quality, scratch, points, to);
}

} // namespace odraz::maker
