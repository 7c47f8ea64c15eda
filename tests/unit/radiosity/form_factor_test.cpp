// Hemicubes against closed forms; what they must not see; sums and furnaces.
#include "radiosity/solve.h"
#include "tests/support/lens.h"
#include "tests/support/room.h"

#include <algorithm>
#include <cmath>
#include <dlfcn.h>
#include <set>
#include <vector>

using namespace odraz;

namespace {

// A model with a hemicube of its own over it.
struct Bench {
    HeapArena memory{(size_t)200 << 20};
    Workers workers = serialWorkers();
    std::unique_ptr<Model> model = std::make_unique<Model>();
    std::unique_ptr<Lens> lens;

    void open(int px, int block) {
        auto scene = std::make_unique<Scene>();
        model->pose(*scene);
        scene->finish();
        EXPECT_TRUE(model->divide(*scene, memory.arena, workers, block, 1));
        lens = std::make_unique<Lens>(px);
    }
    Hemicubes &hemicubes() { return lens->h; }
    std::vector<float> row(const Eye &eye, double *dark = nullptr) { return lens->row(*model, eye, dark); }
    std::set<uint32_t> seen(const Eye &eye) {
        Hemicubes &h = hemicubes();
        drawHemicubes(h, *model, &eye, 1);
        std::set<uint32_t> ids;
        for (int y = 0; y < 3 * h.px; ++y)
            for (int x = 0; x < h.px; ++x) ids.insert(hemicubeIds(h, 0)[y * hemicubeStride(h) + x]);
        return ids;
    }
};

// The form factor from chart 0 to chart 1, its hemicubes turned by the given number.
double between(Bench &b, int turn) {
    const Model &m = *b.model;
    const Chart &from = m.charts[0], &to = m.charts[1];
    int all = from.patchesAcross * from.patchesDown;
    double sum = 0;
    for (int first = 0; first < all; first += b.hemicubes().batch) {
        Eye eyes[kHemicubeBatch];
        int count = std::min(all - first, b.hemicubes().batch);
        for (int i = 0; i < count; ++i)
            eyes[i] = hemicubeEye(m.patches[from.firstPatch + first + i].p, from.n,
                                  (uint32_t)(first + i + 1000 * turn));
        drawHemicubes(b.hemicubes(), m, eyes, count);
        for (int i = 0; i < count; ++i) {
            std::vector<float> row = b.lens->row(m, i);
            for (int k = 0; k < to.patchesAcross * to.patchesDown; ++k)
                sum += (double)row[(size_t)(to.firstPatch + k)];
        }
    }
    return sum / all;
}

double rmsError(Bench &b, double exact, int turns) {
    double sum = 0;
    for (int turn = 0; turn < turns; ++turn) {
        double error = between(b, turn) / exact - 1;
        sum += error * error;
    }
    return std::sqrt(sum / turns);
}

} // namespace

TEST(DeltaFormFactors, SumToOneAndAreTheIntegralOfTheKernel) {
    for (int px : {4, 16, 64, 128}) {
        std::vector<float> delta((size_t)(3 * px * px));
        deltaFormFactors(px, delta.data());
        double sum = 0;
        for (float d : delta) sum += (double)d;
        EXPECT_NEAR(sum, 1, 1e-6) << px;
        // A fine midpoint sum of a few pixels
        for (int k = 0; k < 24; ++k) {
            int row = k * 5 % (3 * px), column = k * 7 % px;
            bool top = row < px;
            int line = top ? row : (row - px) % (px / 2);
            double exact = 0;
            constexpr int kFine = 64;
            for (int j = 0; j < kFine; ++j)
                for (int i = 0; i < kFine; ++i) {
                    double a = (column + (i + 0.5) / kFine) * 2 / px - 1,
                           b = (line + (j + 0.5) / kFine) * 2 / px - top;
                    double s = 1 + a * a + b * b;
                    exact += (top ? 1 : b) / (M_PI * s * s);
                }
            exact *= 4.0 / px / px / kFine / kFine;
            EXPECT_NEAR((double)delta[(size_t)(row * px + column)], exact, 1e-4 * exact)
                << px << ' ' << row << ' ' << column;
        }
    }
}

// Both closed forms: Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", C-11 and C-14.
TEST(FormFactor, ParallelUnitSquares) {
    Bench b;
    b.model->addRect({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 1 / 16.f); // facing up
    b.model->addRect({0, 1, 0}, {1, 0, 0}, {0, 0, 1}, 0, 1 / 16.f); // facing down
    b.open(64, 1);
    ASSERT_EQ(b.model->patchCount, 512);
    double rms = rmsError(b, 0.19982490, 32);
    std::printf("parallel: rms over 32 rotations %.3f %%\n", rms * 100);
    EXPECT_LT(rms, 0.003);
}

TEST(FormFactor, PerpendicularUnitSquares) {
    Bench b;
    b.model->addRect({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 1 / 16.f); // facing up
    b.model->addRect({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0, 1 / 16.f); // facing +x, with a common edge
    b.open(64, 1);
    double rms = rmsError(b, 0.20004378, 32);
    std::printf("perpendicular: rms over 32 rotations %.3f %%\n", rms * 100);
    EXPECT_LT(rms, 0.003);
}

// From a regular polygon of many sides to another one above it: coaxial discs. Howell, C-41.
TEST(FormFactor, CoaxialDiscs) {
    Bench b;
    auto disc = [&](float y, bool up) {
        constexpr int kSides = 32;
        Vec3 u = {0, 0, 2}, v = {2, 0, 0};
        if (!up) std::swap(u, v);
        b.model->addRect({-1, y, -1}, u, v, 0, 1 / 8.f, Model::kPieces);
        for (int k = 0; k < kSides; ++k) {
            auto point = [&](int i, float &s, float &t) {
                double r = std::sqrt(2 * M_PI / (kSides * std::sin(2 * M_PI / kSides))),
                       a = 2 * M_PI * i / kSides;
                s = (float)(1 + r * std::cos(a)), t = (float)(1 + r * std::sin(a));
            };
            float s[4] = {1}, t[4] = {1};
            point(k, s[1], t[1]);
            point(k + 1, s[2], t[2]);
            s[3] = s[2], t[3] = t[2];
            b.model->addFacet(s, t);
        }
    };
    disc(0, true);
    disc(1, false);
    auto scene = std::make_unique<Scene>();
    for (int i = 0; i < b.model->facetCount; ++i) {
        const Facet &f = b.model->facets[i];
        const Chart &c = b.model->charts[f.chart];
        Shape s =
            triangle(f.corner(c, 0), f.corner(c, 1) - f.corner(c, 0), f.corner(c, 2) - f.corner(c, 0), c.n);
        s.chart = f.chart;
        scene->add(s);
    }
    scene->finish();
    ASSERT_TRUE(b.model->divide(*scene, b.memory.arena, b.workers, 1, 1));
    b.lens = std::make_unique<Lens>(64);
    // Patches are cut by the rim: each counts by what of it is there
    const Model &m = *b.model;
    double area = 0, sum = 0;
    for (int i = 0; i < m.patchCount / 2; ++i) {
        const Patch &p = m.patches[i];
        if (p.share == 0) continue;
        std::vector<float> row = b.row(hemicubeEye(p.p, p.n, (uint32_t)i));
        double seen = 0;
        for (int k = m.patchCount / 2; k < m.patchCount; ++k) seen += (double)row[(size_t)k];
        sum += seen * (double)p.share;
        area += (double)p.share;
    }
    double exact = (3 - std::sqrt(5.)) / 2; // radii and distance 1: X = 3
    std::printf("coaxial discs: %.5f, exactly %.5f: %.3f %%\n", sum / area, exact,
                100 * (sum / area / exact - 1));
    EXPECT_NEAR(sum / area, exact, 0.003 * exact);
}

// From a point to a rectangle parallel to it, at a corner and far to the side; Howell, C-11's integrand.
TEST(FormFactor, FromAPointToARectangle) {
    auto corner = [](double a, double b) {
        double ra = std::sqrt(1 + a * a), rb = std::sqrt(1 + b * b);
        return (a / ra * std::atan(b / ra) + b / rb * std::atan(a / rb)) / (2 * M_PI);
    };
    for (int px : {64, 128}) {
        Bench b;
        b.model->addRect({0, 1, 0}, {1.5f, 0, 0}, {0, 0, 1}, 0, 2); // facing down at height 1
        b.open(px, 1);
        for (double x : {0., 0.75, -1.}) {
            auto along = [&](double z) {
                return corner(1.5 - x, z) - (x > 0 ? -corner(x, z) : corner(-x, z));
            };
            double exact = along(1 - 0.25) + along(0.25), sum = 0;
            for (uint32_t turn = 0; turn < 32; ++turn) {
                float got = b.row(hemicubeEye({(float)x, 0, 0.25f}, {0, 1, 0}, turn))[0];
                double error = (double)got / exact - 1;
                sum += error * error;
            }
            double rms = std::sqrt(sum / 32);
            std::printf("point to rectangle, %d px, x %.2f: rms over 32 rotations %.3f %%\n", px, x,
                        rms * 100);
            EXPECT_LT(rms, px == 64 ? 0.005 : 0.002);
        }
    }
}

// To 0.3 % at 64 pixels and 0.1 % at 128, and ever better.
TEST(FormFactor, FallsWithResolution) {
    for (bool parallel : {true, false}) {
        double last = 1;
        for (int px : {8, 16, 32, 64, 128}) {
            Bench b;
            b.model->addRect({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 1 / 16.f);
            if (parallel)
                b.model->addRect({0, 1, 0}, {1, 0, 0}, {0, 0, 1}, 0, 1 / 16.f);
            else
                b.model->addRect({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0, 1 / 16.f);
            b.open(px, 1);
            double rms = rmsError(b, parallel ? 0.19982490 : 0.20004378, 8);
            std::printf("%s squares, %3d px: %.4f %%\n", parallel ? "parallel" : "perpendicular", px,
                        rms * 100);
            EXPECT_LT(rms, last * 1.2) << px;
            EXPECT_LT(rms, px >= 128 ? 0.001 : px >= 64 ? 0.003 : 0.05);
            last = std::min(rms, last);
        }
        EXPECT_LT(last, 0.001);
    }
}

TEST(FormFactor, OneSided) {
    Bench b;
    b.model->addRect({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 0.25f); // facing up
    b.model->addRect({0, 1, 0}, {0, 0, 1}, {1, 0, 0}, 0, 0.25f); // above it, facing up too: its back is black
    b.model->addRect({-9, 2, -9}, {20, 0, 0}, {0, 0, 20}, 0, 5); // and above that, facing down
    b.open(64, 1);
    const Chart &above = b.model->charts[1];
    double dark;
    auto row = b.row(hemicubeEye({0.5f, 0, 0.5f}, {0, 1, 0}, 1), &dark);
    for (int i = 0; i < above.patchesAcross * above.patchesDown; ++i)
        EXPECT_EQ(row[(size_t)(above.firstPatch + i)], 0);
    EXPECT_GT(dark, 0.2); // the back hides what is behind it
    // From its own place the upper square sees the ceiling, and never itself or the lower one
    auto ids = b.seen(hemicubeEye({0.5f, 1, 0.5f}, {0, 1, 0}, 2));
    for (uint32_t id : ids)
        if (id != kNothing) {
            EXPECT_GT((int)id, b.model->charts[2].firstPatch);
        }
}

TEST(ClosedRoom, RowsSumToOne) {
    Bench b;
    addRoom(*b.model, {-2, -1.5f, -3}, {2, 1.5f, 3}, 0.5f);
    b.model->addBox({-0.5f, -1.5f, -0.5f}, {0.5f, 0.25f, 0.5f}, 0, 0.5f, Model::kUpright | Model::kTop);
    b.open(64, 1);
    for (int i = 0; i < b.model->patchCount; ++i) {
        const Patch &p = b.model->patches[i];
        if (p.share == 0) continue;
        double dark, sum = 0;
        for (float f : b.row(hemicubeEye(p.p, b.model->charts[p.chart].n, (uint32_t)i), &dark))
            sum += (double)f;
        EXPECT_EQ(dark, 0) << i;
        EXPECT_NEAR(sum, 1, 1e-6) << i;
    }
}

// However near the walls a hemicube stands, it sees the room and nothing else: no near plane, no own plane,
// no neighbour of its plane, nothing behind the walls.
TEST(ClosedRoom, NothingIsSeenFromOutsideAtAnyOffset) {
    for (float scale : {1e-3f, 1.f, 1e3f}) {
        Bench b;
        Vec3 half = {1, 1, 1};
        addRoom(*b.model, -half * scale, half * scale, 0.5f * scale);
        int inside = 0;
        // Bigger rooms around it, and squares beneath and beside the floor, some in its plane
        addRoom(*b.model, -half * (1.0001f * scale), half * (1.0001f * scale), 0.5f * scale);
        addRoom(*b.model, -half * (2 * scale), half * (2 * scale), 0.5f * scale);
        b.model->addRect(Vec3{1, -1, -1} * scale, Vec3{0, 0, 2} * scale, Vec3{2, 0, 0} * scale, 0,
                         0.5f * scale);
        b.model->addRect(Vec3{-3, -1, -1} * scale, Vec3{0, 0, 2} * scale, Vec3{2, 0, 0} * scale, 0,
                         0.5f * scale);
        b.open(32, 1);
        inside = b.model->charts[6].firstPatch;
        for (float d = 1e-6f; d <= 1; d *= 1.7f)
            for (Vec3 p : {Vec3{-1 + d, -1, 0.3f}, Vec3{-1 + d, -1, 1 - d}, Vec3{0.2f, -1, -1 + d}}) {
                for (uint32_t id : b.seen(hemicubeEye(p * scale, {0, 1, 0}, (uint32_t)bits(d)))) {
                    ASSERT_NE(id, kNothing) << d << " scale " << scale;
                    ASSERT_LE(id, (uint32_t)inside) << d << " scale " << scale;
                    // The floor's own patches lie in the hemicube's plane
                    const Chart &floor = b.model->charts[0];
                    ASSERT_FALSE(id > (uint32_t)floor.firstPatch &&
                                 id <=
                                     (uint32_t)(floor.firstPatch + floor.patchesAcross * floor.patchesDown));
                }
            }
    }
}

TEST(Depth, UsesClipControlWhereItIs) {
    Bench b;
    addRoom(*b.model, {-1, -1, -1}, {1, 1, 1}, 0.5f);
    b.open(32, 1);
    const char *override = getenv("MESA_EXTENSION_OVERRIDE");
    EXPECT_EQ(b.hemicubes().clipControl, !(override && strstr(override, "-GL_ARB_clip_control")));
}

// Two walls a hair apart, far away: the nearer one must win in every pixel.
TEST(Depth, TellsNearFromFarAtADistance) {
    Bench b;
    b.model->addRect({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 1);
    b.model->addRect({-1000, 99.99f, -1000}, {2000, 0, 0}, {0, 0, 2000}, 0, 500);
    b.model->addRect({-1000, 100, -1000}, {2000, 0, 0}, {0, 0, 2000}, 0, 500);
    b.open(64, 1);
    const Chart &far = b.model->charts[2];
    auto row = b.row(hemicubeEye({0.5f, 0, 0.5f}, {0, 1, 0}, 3));
    for (int i = 0; i < far.patchesAcross * far.patchesDown; ++i)
        EXPECT_EQ(row[(size_t)(far.firstPatch + i)], 0);
}

// Where everything shines with 1 and reflects rho, everything has 1 / (1 - rho).
// Everything that openHemicubes() makes is gone when they are closed.
TEST(Hemicubes, LeaveNothingBehind) {
    void *egl = dlopen("libEGL.so.1", RTLD_LAZY);
    ASSERT_TRUE(egl);
    auto find = (void *(*)(const char *))dlsym(egl, "eglGetProcAddress");
    ASSERT_TRUE(find);
    auto is = [&](const char *what, GLuint name) {
        return ((GLboolean(*)(GLuint))find(what))(name) == GL_TRUE;
    };
    Bench b;
    addRoom(*b.model, {0, 0, 0}, {1, 1, 1}, 1);
    b.open(16, 1);
    Hemicubes h = b.hemicubes();
    Eye eye = hemicubeEye(b.model->patches[0].p, b.model->patches[0].n, 0);
    drawHemicubes(h, *b.model, &eye, 1);
    auto there = [&] {
        return is("glIsProgram", h.program) + is("glIsVertexArray", h.vertexArray) +
               is("glIsBuffer", h.buffer) + is("glIsFramebuffer", h.framebuffer) +
               is("glIsRenderbuffer", h.images[0]) + is("glIsRenderbuffer", h.images[1]);
    };
    EXPECT_EQ(there(), 6);
    b.lens.reset();
    EXPECT_EQ(there(), 0);
    for (GLuint shader = 1; shader < 100; ++shader) EXPECT_FALSE(is("glIsShader", shader)) << shader;
}

TEST(Furnace, ComesOutEven) {
    for (float rho : {0.f, 0.3f, 0.9f, 0.99f}) {
        Bench b;
        addRoom(*b.model, {-2, -1.5f, -3}, {2, 1.5f, 3}, 0.5f);
        b.model->addBox({-0.5f, -1.5f, -0.5f}, {0.5f, 0.25f, 0.5f}, 0, 0.5f, Model::kUpright | Model::kTop);
        b.open(64, 1);
        std::vector<uint8_t> lit((size_t)b.model->patchCount, 1);
        FormFactors f = {};
        f.capacity = 1 << 20;
        f.links = b.memory.arena.take<Link>(f.capacity);
        ASSERT_TRUE(findFormFactors(b.hemicubes(), *b.model, lit.data(), b.workers, b.memory.arena, f, {}));
        System s;
        ASSERT_TRUE(makeSystem(s, b.memory.arena, f, b.model->patchCount, 1));
        for (int i = 0; i < b.model->patchCount; ++i)
            for (int k = 0; k < f.rows[i].count; ++k) {
                s.direct[i * s.columns] += f.rows[i].links[k].share; // from a neighbour that shines with 1
                s.reflectance[i * s.columns] = rho;
            }
        int sweeps = solve(s, b.workers, 1e-6f, 5000);
        EXPECT_LT(sweeps, 5000);
        for (int i = 0; i < b.model->patchCount; ++i) {
            if (b.model->patches[i].share == 0) continue;
            double exact = 1 / (1 - (double)rho);
            ASSERT_NEAR(1 + (double)s.radiosity[i * s.columns], exact, 0.001 * exact) << rho << ' ' << i;
        }
    }
}

// Two patches that see each other whole, for so many right-hand sides that reflect more and more.
struct Facing {
    static constexpr int kUnknowns = 1100;
    HeapArena memory{(size_t)1 << 20};
    Workers workers = serialWorkers();
    Link links[2] = {{1, 1}, {0, 1}};
    Row rows[2] = {{links, 1, true}, {links + 1, 1, true}};
    FormFactors factors = {links, rows, 2, 2};
    System s;

    Facing() {
        EXPECT_TRUE(makeSystem(s, memory.arena, factors, 2, kUnknowns));
        for (int i = 0; i < 2 * s.columns; ++i) {
            s.reflectance[i] = reflectance(i % s.columns);
            s.direct[i] = i < s.columns ? 1 : 0;
        }
    }
    static float reflectance(int k) { return k < kUnknowns ? 0.9f * (float)k / kUnknowns : 0; }
};

// B = rho + rho^2 B' and B' = rho B: however many right-hand sides there are.
TEST(Solve, AsManyRightHandSidesAsThereIsRoomFor) {
    Facing f;
    int sweeps = solve(f.s, f.workers, 1e-6f, 5000);
    for (int k = 0; k < Facing::kUnknowns; ++k) {
        double rho = (double)Facing::reflectance(k), exact = rho / (1 - rho * rho);
        ASSERT_NEAR((double)f.s.radiosity[k], exact, 1e-5 * exact + 1e-9) << k;
        ASSERT_NEAR((double)f.s.radiosity[f.s.columns + k], rho * exact, 1e-5 * exact + 1e-9) << k;
    }
    EXPECT_GT(sweeps, 40); // of those that reflect most
    EXPECT_EQ(solve(f.s, f.workers, 1e-6f, 7), 7);
}

TEST(Solve, BouncesAddUpToTheSolution) {
    Facing f;
    bounce(f.s, f.workers);
    for (int k = 0; k < Facing::kUnknowns; ++k) {
        ASSERT_EQ(f.s.radiosity[k], Facing::reflectance(k)); // light from outside, reflected once
        ASSERT_EQ(f.s.radiosity[f.s.columns + k], 0);
    }
    for (int n = 1; n < 400; ++n) bounce(f.s, f.workers);
    Facing solved;
    solve(solved.s, solved.workers, 1e-6f, 5000);
    for (int i = 0; i < 2 * f.s.columns; ++i)
        ASSERT_NEAR(f.s.radiosity[i], solved.s.radiosity[i], 1e-5f * solved.s.radiosity[i]) << i;
}
