// Compares form factors from hemicubes with closed forms.
#include "tests/support/figure.h"
#include "tests/support/hemicube_bench.h"
#include "tests/support/room.h"
#include "tests/support/sanitized.h"

using namespace odraz;

// Two unit squares, at distance 1 or with a common edge. Howell, "A Catalog of Radiation Heat Transfer
// Configuration Factors", C-11 and C-14.
struct Squares {
    const char *name;
    Vec3 corner, u, v; // the second square
    double exact;

    // Adds both squares, each divided into 16 x 16 patches. The first one faces up.
    void addTo(Model &m) const {
        m.addRect({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 1 / 16.f);
        m.addRect(corner, u, v, 0, 1 / 16.f);
    }
};
constexpr Squares kSquares[] = {{"parallel", {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, 0.19982490},
                                {"perpendicular", {0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.20004378}};

// Returns the form factor from chart 0 to chart 1, by hemicubes with a given rotation.
static double between(HemicubeBench &b, int turn) {
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
            std::vector<float> row = b.hemicube->row(m, i);
            for (int k = 0; k < to.patchesAcross * to.patchesDown; ++k)
                sum += (double)row[(size_t)(to.firstPatch + k)];
        }
    }
    return sum / all;
}

TEST(DeltaFormFactors, SumToOneAndAreTheIntegralOfTheKernel) {
    for (int px : {4, 16, 64, 128}) {
        std::vector<float> delta((size_t)(3 * px * px));
        deltaFormFactors(px, delta.data());
        EXPECT_NEAR(std::accumulate(delta.begin(), delta.end(), 0.), 1, 1e-6) << px;
        // Compare a few pixels with a fine midpoint sum
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

static double rmsError(const Squares &squares, int px, int turns) {
    HemicubeBench b;
    squares.addTo(*b.model);
    b.open(px, 1);
    EXPECT_EQ(b.model->patchCount, 512);
    double sum = 0;
    for (int turn = 0; turn < turns; ++turn) sum += std::pow(between(b, turn) / squares.exact - 1, 2);
    return std::sqrt(sum / turns);
}

// Coaxial discs, as regular polygons of many sides. Howell, C-41.
TEST(FormFactor, CoaxialDiscs) {
    HemicubeBench b;
    constexpr int kSides = 32;
    const double kRadius = std::sqrt(2 * M_PI / (kSides * std::sin(2 * M_PI / kSides)));
    auto disc = [&](float y, bool up) {
        Vec3 u = {0, 0, 2}, v = {2, 0, 0};
        if (!up) std::swap(u, v);
        b.model->addRect({-1, y, -1}, u, v, 0, 1 / 8.f, Model::kPieces);
        for (int k = 0; k < kSides; ++k) {
            auto point = [&](int i, float &s, float &t) {
                double a = 2 * M_PI * i / kSides;
                s = (float)(1 + kRadius * std::cos(a)), t = (float)(1 + kRadius * std::sin(a));
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
    EXPECT_TRUE(b.model->divide(b.memory.arena, 1));
    for (int i = 0; i < 4 * b.model->texelCount; ++i) {
        Texel &at = b.model->texels[i / 4];
        double s = (at.x + (i & 1 ? 0.25 : -0.25)) / 8 - 1, t = (at.y + (i & 2 ? 0.25 : -0.25)) / 8 - 1,
               side = std::remainder(std::atan2(t, s) - M_PI / kSides, 2 * M_PI / kSides);
        if (std::hypot(s, t) * std::cos(side) < kRadius * std::cos(M_PI / kSides)) at.visible |= 1 << (i & 3);
    }
    b.model->placePatches();
    b.hemicube = std::make_unique<SingleHemicube>(64);
    // The rim cuts patches: weight each by the share of it that is inside
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
    expectAtMost("relative error", std::fabs(sum / area / exact - 1), 0.003);
}

// From a point to a parallel rectangle, at a corner and far to the side.
TEST(FormFactor, FromAPointToARectangle) {
    for (int px : {64, 128}) {
        HemicubeBench b;
        b.model->addRect({0, 1, 0}, {1.5f, 0, 0}, {0, 0, 1}, 0, 2); // facing down at height 1
        b.open(px, 1);
        for (double x : {0., 0.75, -1.}) {
            double exact = parallelFormFactor(x, 0.25, 0, 1.5, 0, 1, 1), sum = 0;
            for (uint32_t turn = 0; turn < 32; ++turn) {
                float got = b.row(hemicubeEye({(float)x, 0, 0.25f}, {0, 1, 0}, turn))[0];
                sum += std::pow((double)got / exact - 1, 2);
            }
            EXPECT_LT(std::sqrt(sum / 32), px == 64 ? 0.005 : 0.002);
        }
    }
}

// The error falls with the number of pixels: at most one per cent at 16, the film's.
FIGURES_TEST(FormFactor, OfUnitSquaresFallsWithResolution) {
    for (const Squares &squares : kSquares) {
        double coarse = rmsError(squares, 16, 8), middle = rmsError(squares, 64, 8);
        expectAtMost(std::string(squares.name) + ", 16 pixels: rms", coarse, 0.01);
        EXPECT_LT(middle, coarse);
        EXPECT_LT(rmsError(squares, 256, 8), middle);
    }
}

TEST(FormFactor, OneSided) {
    HemicubeBench b;
    b.model->addRect({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 0.25f); // facing up
    b.model->addRect({0, 1, 0}, {0, 0, 1}, {1, 0, 0}, 0, 0.25f); // above, facing up: its back is black
    b.model->addRect({-9, 2, -9}, {20, 0, 0}, {0, 0, 20}, 0, 5); // above both, facing down
    b.model->open = true;
    b.open(64, 1);
    const Chart &above = b.model->charts[1];
    double dark;
    auto row = b.row(hemicubeEye({0.5f, 0, 0.5f}, {0, 1, 0}, 1), &dark);
    for (int i = 0; i < above.patchesAcross * above.patchesDown; ++i)
        EXPECT_EQ(row[(size_t)(above.firstPatch + i)], 0);
    EXPECT_GT(dark, 0.2); // the back hides what is behind it
    // The upper square sees the ceiling, but neither itself nor the lower square
    auto ids = b.visibleIds(hemicubeEye({0.5f, 1, 0.5f}, {0, 1, 0}, 2));
    for (uint32_t id : ids)
        if (id != kNothing) {
            EXPECT_GT((int)id, b.model->charts[2].firstPatch);
        }
}
