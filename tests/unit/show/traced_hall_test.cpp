// Tests the hall at the film's settings: the hemicubes of film and page against rays in double precision, and
// the hall as the page solves it against path tracing and the hall that OpenGL draws.
#include "tests/support/figure.h"
#include "tests/support/film_hall.h"
#include "tests/support/model_rays.h"
#include "tests/support/sanitized.h"
#include "tools/measure/reference/hall_paths.h"

using namespace odraz;
using namespace odraz::radiosity;

static const Hall &traced() { return *FilmHall::traced().hall; }

// Returns the patch of a chart at a point of its plane.
static int patchAt(const Chart &c, Vec3d p) {
    Vec3d q = p - toDouble(c.corner);
    auto along = [&](Vec3 axis, float size, int count) {
        return std::clamp((int)(dot(q, toDouble(axis)) / (double)size * count), 0, count - 1);
    };
    return c.firstPatch + along(c.v, c.height, c.patchesDown) * c.patchesAcross +
           along(c.u, c.width, c.patchesAcross);
}

// Finds what a ray from a patch hits: the patch there, or the patch of the window by which it leaves; -1:
// none.
struct PatchRays {
    const Model &model;
    ModelRays rays{model};

    int at(Vec3d from, Vec3d d) const {
        Obstacles::Hit hit = rays.obstacles.nearest(from, d);
        if (hit.back) return -1;
        if (hit.met()) return patchAt(model.charts[rays.chartOf[(size_t)hit.number]], from + d * hit.t);
        for (int i = 0; i < model.chartCount; ++i) {
            const Chart &c = model.charts[i];
            double t = dot(toDouble(c.corner) - from, toDouble(c.n)) / dot(d, toDouble(c.n));
            Vec3d q = from + d * t - toDouble(c.corner);
            double u = dot(q, toDouble(c.u)), v = dot(q, toDouble(c.v));
            if (c.open && t > 0 && u >= 0 && u <= (double)c.width && v >= 0 && v <= (double)c.height)
                return patchAt(c, from + d * t);
        }
        return -1;
    }
};

// Returns the direction of a pixel's centre in the hemicube's frame. Each side face looks along x, y, -x or
// -y.
static Vec3d directionOf(int px, int x, int y) {
    double a = (x + 0.5) * 2 / px - 1, b = (y + 0.5) * 2 / px - 1;
    if (y < px) return {a, b, 1};
    int side = (y - px) / (px / 2);
    double up = b - 1 - side, ahead[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, *f = ahead[side];
    return {f[0] - a * f[1], f[1] + a * f[0], up};
}

// In the film's hemicubes and in the page's.
TEST(TracedHall, EveryPixelShowsWhatARayInDoublePrecisionHits) {
    const Model &m = traced().model;
    auto scene = emptyScene();
    m.pose(*scene);
    scene->finish();
    PatchRays rays{m};
    for (auto [name, method, limit] :
         {std::tuple{"traced", &kTracedHemicubes, 5e-5}, {"drawn", &kDrawnHemicubes, 0.002}}) {
        HeapArena memory(hemicubeBytes(kHallSettings.px));
        Hemicubes h;
        ASSERT_TRUE(method->open(h, &headlessGl(), *scene, memory.arena, kHallSettings.px));
        int pixels = 0, others = 0;
        for (int i = 0; i < m.patchCount; i += kSanitized ? 97 : 11) {
            const Patch &p = m.patches[i];
            if (p.share == 0 || m.charts[p.chart].open) continue;
            Eye eye = hemicubeEye(p.p, p.n, (uint32_t)i);
            ASSERT_TRUE(method->fill(h, m, &eye, 1));
            for (int y = 0; y < 3 * h.px; ++y)
                for (int x = 0; x < h.px; ++x) {
                    Vec3d a = directionOf(h.px, x, y), d = toDouble(eye.frame.u) * a.x +
                                                           toDouble(eye.frame.v) * a.y +
                                                           toDouble(eye.frame.w) * a.z;
                    int shown = (int)hemicubeIds(h, 0)[y * hemicubeStride(h) + x] - 1;
                    others += shown != rays.at(toDouble(p.p) + toDouble(p.n) * 1e-6, d);
                    ++pixels;
                }
        }
        // At edges, where the last bits decide, or to which fraction of a pixel OpenGL rounds vertices
        expectAtMost(std::string(name) + ": share that differs", (double)others / pixels, limit);
        method->close(h);
    }
}

// Paths in double precision find the same light, for all lights of the film.
FIGURES_TEST(TracedHall, ItsLightAgreesWithPathTracing) {
    const FilmHall &solved = FilmHall::traced();
    std::vector<measure::HallTexel> texels = measure::placeTexels(traced(), 400);
    Workers workers = serialWorkers();
    for (const measure::LightOfHall &light : measure::lightsOf(traced())) {
        auto paths = measure::tracedLight(traced(), *solved.scene, light, texels, 12, workers),
             found = measure::solvedLight(traced(), light, texels, paths.drawn);
        MeshErrors reflected = errorsOf(found.reflected, paths.reflected, paths.reflectedNoise2),
                   all = errorsOf(found.all, paths.all, paths.noise2); // percent
        EXPECT_NEAR(reflected.bias, 0, 2.5) << light.name;
        EXPECT_LT(reflected.rms, light.name == "the point" ? 25 : 12) << light.name;
        EXPECT_NEAR(all.bias, 0, 1) << light.name;
        EXPECT_LT(all.rms, 6) << light.name;
    }
}

// The film and the page show the same hall.
TEST(TracedHall, IsTheDrawnHall) {
    const Hall &a = *FilmHall::drawn().hall, &b = traced();
    ASSERT_EQ(a.model.texelCount, b.model.texelCount);
    for (int k = 0; k < kHallBases.count(); ++k) {
        double square = 0, difference = 0;
        for (int t = 0; t < a.model.texelCount; ++t) {
            auto at = [&](const Hall &hall) {
                return (double)(hall.radiosity.bounced[k][1][t] + hall.radiosity.direct[k][t]);
            };
            square += at(a) * at(a);
            difference += (at(b) - at(a)) * (at(b) - at(a));
        }
        EXPECT_LT(std::sqrt(difference / square), 0.003) << "basis " << k;
    }
}
