// Tests direct light against closed forms, solved rooms, and extremes of reflectance, power and size.
#include "radiosity/radiosity.h"
#include "tests/support/figure.h"
#include "tests/support/headless_gl.h"
#include "tests/support/model_bench.h"
#include "tests/support/room.h"
#include "tests/support/shapes.h"
#include "transfer/relight.h"

using namespace odraz;

// A room of 4 x 3 x 6 with a block on the floor, solved. Materials: 0 walls, 1 a floor that may be coloured,
// 2 lamps.
struct TestRoom : ModelBench {
    std::unique_ptr<Radiosity> r = std::make_unique<Radiosity>();

    Rgb walls, floor;

    explicit TestRoom(float grey = 0.5f) : walls{grey, grey, grey}, floor(walls) {}
    // The room as described, with a glowing ball.
    explicit TestRoom(Vec3 ball, float grey = 0.5f, float radius = 0.1f) : TestRoom(grey) {
        addRoom(*model, {-2, 0, -3}, {2, 3, 3}, 0.25f, 0, 1);
        addBlock();
        addBall(ball, radius);
    }
    void addBlock(float scale = 1) {
        model->addBox(Vec3{-0.5f, 0, -0.5f} * scale, Vec3{0.5f, 1, 0.5f} * scale, 0, 0.25f * scale,
                      Model::kUpright | Model::kTop);
    }
    void addBall(Vec3 centre, float radius, float scale = 1) {
        r->bases.lamps[r->bases.lampCount++] = {centre * scale, radius * scale, -1};
    }
    void addFloor() { model->addRect({-2, 0, -3}, {0, 0, 6}, {4, 0, 0}, 1, 0.25f); }
    bool solve(RadiositySettings settings = {}) {
        scene->clear();
        scene->add(matte(walls));
        scene->add(matte(floor));
        scene->add(Material{.emit = {1, 1, 1}});
        pose();
        return solveRadiosity(*r, *model, *scene, settings,
                              {kDrawnHemicubes, &headlessGl(), memory.arena, workers, {}});
    }
    // Returns the value of a texel in a plane.
    float at(const float *plane, int chart, int i, int j) const {
        return plane[model->charts[chart].texel(i, j)];
    }
    // Visits the texels of a chart, except those on its border.
    void forTexels(int chart, const std::function<void(int, Vec3)> &visit) const {
        const Chart &c = model->charts[chart];
        for (int j = 1; j < c.down; ++j)
            for (int i = 1; i < c.across; ++i)
                visit(c.texel(i, j),
                      c.at((float)i * c.width / (float)c.across, (float)j * c.height / (float)c.down));
    }
    bool visible(int texel) const { return model->texels[texel].visible; }
    // Returns the red light of all texels if the first lamp has this power.
    std::vector<float> relit(float power) const {
        size_t texels = (size_t)model->texelCount, stride = texels + 8;
        std::vector<float> planes(3 * stride, 1);
        float *out[3] = {&planes[0], &planes[stride], &planes[2 * stride]};
        LightVector light = {};
        light.bounced[0] = light.direct[0] = {power, power, power};
        relight(*r, *model, light, out);
        planes.resize(texels);
        return planes;
    }
};

TEST(Direct, ARectangularLampIsItsFormFactor) {
    for (float height : {0.1f, 0.5f, 2.5f}) {
        TestRoom room(0);
        room.addFloor();
        int lamp = room.model->addRect({-0.5f, height, -1}, {1, 0, 0}, {0, 0, 2}, 2, 0.5f);
        room.r->bases.lamps[room.r->bases.lampCount++] = {{}, 0, lamp};
        ASSERT_TRUE(room.solve());
        double worst = 0;
        room.forTexels(0, [&](int texel, Vec3 p) {
            // Average over the texel's four sample points
            double exact = 0;
            for (double u : {-0.0625, 0.0625})
                for (double v : {-0.0625, 0.0625})
                    exact += parallelFormFactor((double)p.x + u, (double)p.z + v, -0.5, 0.5, -1, 1,
                                                (double)height) /
                             4;
            worst = std::fmax(worst, std::fabs((double)room.r->direct[0][texel] - exact));
        });
        EXPECT_LT(worst, 0.008) << height;
    }
}

TEST(Direct, ABallIsItsFormFactorAndThrowsAShadow) {
    TestRoom room({0, 2.5f, 0}, 0);
    ASSERT_TRUE(room.solve());
    int lit = 0, dark = 0;
    room.forTexels(0, [&](int texel, Vec3 p) {
        double d2 = (double)dot(p - Vec3{0, 2.5f, 0}, p - Vec3{0, 2.5f, 0}),
               exact = 0.01 / d2 * 2.5 / std::sqrt(d2);
        float got = room.r->direct[0][texel];
        // The block's shadow is 5/3 times its size
        double out = std::fmax(std::fabs((double)p.x), std::fabs((double)p.z));
        if (out > 1.05) {
            EXPECT_NEAR((double)got, exact, exact * 0.02) << p.x << ' ' << p.z;
            ++lit;
        } else if (out > 0.7 && out < 0.76) {
            EXPECT_EQ(got, 0) << p.x << ' ' << p.z;
            ++dark;
        }
    });
    EXPECT_GT(lit, 200);
    EXPECT_GT(dark, 10);
}

TEST(Direct, AnEvenSkyIsTheWindowsFormFactor) {
    TestRoom room(0);
    room.addFloor();
    room.model->addRect({-1, 2, -1}, {2, 0, 0}, {0, 0, 2}, 0, 1, Model::kOpen);
    // Three skies, one of them negative
    room.r->bases.sky = [](const void *, const Vec3x8 &, Float8 *radiance) {
        radiance[0] = broadcast(1.f), radiance[1] = broadcast(-2.f), radiance[2] = broadcast(3.f);
    };
    room.r->bases.skyCount = 3;
    ASSERT_TRUE(room.solve());
    room.forTexels(0, [&](int texel, Vec3 p) {
        double exact = parallelFormFactor((double)p.x, (double)p.z, -1, 1, -1, 1, 2);
        const int strength[3] = {1, -2, 3};
        for (int k = 0; k < 3; ++k)
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR((double)room.r->bounced[k][c][texel], exact * strength[k], 0.012)
                    << p.x << ' ' << p.z;
    });
}

TEST(Direct, TheSunComesInThroughTheWindow) {
    TestRoom room(0);
    room.addFloor();
    room.model->addRect({-2, 2, -3}, {4, 0, 0}, {0, 0, 6}, 0, 0.25f, Model::kPieces);
    room.model->addFacet(0, 0, 4, 2);
    room.model->addFacet(0, 4, 4, 6);
    room.r->bases.suns[room.r->bases.sunCount++] = {0, 1000, 0};
    ASSERT_TRUE(room.solve());
    room.forTexels(0, [&](int texel, Vec3 p) {
        if (std::fabs(std::fabs(p.z) - 1) < 0.2f) return;
        EXPECT_NEAR(room.r->direct[0][texel], std::fabs(p.z) < 1 ? 1 : 0, 1e-3) << p.x << ' ' << p.z;
    });
}

// A sealed room stays exactly black: no light leaks through walls, corners or along floors.
TEST(Leaks, ASealedRoomStaysDark) {
    TestRoom room({0, 2.5f, 0});
    int first = room.model->chartCount;
    // Another room behind a wall 0.1 thick
    addRoom(*room.model, {2.1f, 0, -3}, {6.1f, 3, 3}, 0.25f, 0, 1);
    ASSERT_TRUE(room.solve());
    double leaked = 0;
    for (int chart = first; chart < room.model->chartCount; ++chart)
        room.forTexels(chart, [&](int texel, Vec3) {
            leaked += (double)room.r->direct[0][texel];
            for (auto plane : room.r->bounced[0]) leaked += (double)plane[texel];
        });
    EXPECT_EQ(leaked, 0);
    EXPECT_GT(room.at(room.r->bounced[0][0], 0, 2, 2), 1e-4f);
}

// The floor under the block is hidden and gets its neighbours' light: no dark rim.
TEST(Elements, HiddenOnesGetTheirNeighboursLight) {
    TestRoom room({0, 2.9f, 0}, 0.5f, 0.05f);
    ASSERT_TRUE(room.solve({.block = 4})); // the block ends where elements end
    int hidden = 0;
    float least = 1e9f, most = 0;
    room.forTexels(0, [&](int texel, Vec3 p) {
        bool under = std::fabs(p.x) < 0.49f && std::fabs(p.z) < 0.49f;
        EXPECT_EQ(!room.visible(texel), under) << p.x << ' ' << p.z;
        hidden += under;
        float v = room.r->bounced[0][0][texel];
        least = std::fmin(least, v), most = std::fmax(most, v);
    });
    EXPECT_EQ(hidden, 9);
    EXPECT_GT(least, most * 0.2f);
}

// Energy is conserved: the lamp's light equals the absorbed light, the sum of area (1 - rho) B / rho over
// patches.
TEST(Solve, EnergyIsConserved) {
    for (float rho : {0.2f, 0.7f, 0.95f}) {
        TestRoom room({0.6f, 2.0f, 1.1f}, rho);
        ASSERT_TRUE(room.solve({.block = 2, .sweeps = 2000}));
        double arrived = 0, absorbed = 0;
        const System &s = room.r->system;
        for (int i = 0; i < room.model->patchCount; ++i) {
            const Patch &p = room.model->patches[i];
            double area = (double)p.area;
            arrived += area * (double)s.direct[i * s.columns];
            absorbed += area * (1 / (double)rho - 1) * (double)s.radiosity[i * s.columns];
        }
        expectAtMost("reflectance " + testing::PrintToString(rho), std::fabs(absorbed / arrived - 1), 0.02);
        // A ball emits its radiance times pi times its surface 4 pi r^2, here in units of irradiance / pi
        EXPECT_NEAR(arrived, 4 * M_PI * 0.01, 0.02 * 4 * M_PI * 0.01) << rho;
    }
}

TEST(Solve, ColourBleeds) {
    TestRoom room({0, 2.9f, 2.5f}, 0.5f, 0.05f);
    room.floor = {0.8f, 0.2f, 0.05f};
    ASSERT_TRUE(room.solve());
    float red = room.at(room.r->bounced[0][0], 1, 8, 12), blue = room.at(room.r->bounced[0][2], 1, 8, 12);
    EXPECT_GT(red, 1.3f * blue);
}

// Light is linear in the lamp's power over twelve orders of magnitude, because the solver's residual is
// relative.
TEST(Extremes, LampsFromAMillionthToAMillion) {
    TestRoom room({0, 2.5f, 1});
    ASSERT_TRUE(room.solve());
    for (float power : {1e-6f, 1.f, 1e6f}) {
        std::vector<float> red = room.relit(power);
        for (int i = 0; i < room.model->texelCount; ++i) {
            float exact = (room.r->bounced[0][0][i] + room.r->direct[0][i]) * power;
            ASSERT_NEAR(red[(size_t)i], exact, exact * 1e-5f) << power;
        }
    }
}

TEST(Extremes, AlmostEverythingIsReflected) {
    TestRoom room({0, 2.5f, 1}, 0.999f);
    ASSERT_TRUE(room.solve({.block = 4, .residual = 1e-5f, .sweeps = 20000}));
    // Light is nearly even, and about the lamp's emission divided by the walls' absorption
    double area = 2 * (4 * 3 + 4 * 6 + 3 * 6) + 4, even = 4 * M_PI * 0.01 / (area * 0.001);
    for (int i = 0; i < room.model->texelCount; ++i)
        if (room.visible(i)) {
            ASSERT_NEAR((double)room.r->bounced[0][0][i], even, even * 0.15);
        }
}

// A floor with a block, below a roof with a window; lit by the sky, the sun and a ball.
TEST(Extremes, SizeDoesNotMatter) {
    auto solved = [](float scale) {
        auto room = std::make_unique<TestRoom>();
        auto rect = [&](Vec3 corner, Vec3 u, Vec3 v, int material, Model::Kind kind) {
            room->model->addRect(corner * scale, u * scale, v * scale, material, 0.25f * scale, kind);
        };
        rect({-2, 0, -3}, {0, 0, 6}, {4, 0, 0}, 1, Model::kWhole);
        rect({-2, 3, -3}, {4, 0, 0}, {0, 0, 6}, 0, Model::kPieces);
        for (float from : {0.f, 4.f}) room->model->addFacet(0, from * scale, 4 * scale, (from + 2) * scale);
        rect({-2, 3, -1}, {4, 0, 0}, {0, 0, 2}, 0, Model::kOpen);
        room->addBlock(scale);
        LightBases &bases = room->r->bases;
        bases.sky = [](const void *, const Vec3x8 &, Float8 *radiance) { *radiance = broadcast(1.f); };
        bases.skyCount = 1;
        bases.suns[bases.sunCount++] = Vec3{100, 1000, 50} * scale;
        room->addBall({1, 2.5f, 1}, 0.1f, scale);
        EXPECT_TRUE(room->solve());
        return room;
    };
    auto one = solved(1);
    for (float scale : {1e-3f, 1e3f}) {
        auto room = solved(scale);
        ASSERT_EQ(room->model->texelCount, one->model->texelCount);
        for (int basis = 0; basis < 3; ++basis) {
            double sum = 0, difference = 0;
            for (int i = 0; i < room->model->texelCount; ++i) {
                ASSERT_EQ(room->visible(i), one->visible(i)) << scale;
                for (int c = 0; c < 3; ++c) {
                    double a = (double)room->r->bounced[basis][c][i],
                           b = (double)one->r->bounced[basis][c][i];
                    ASSERT_TRUE(std::isfinite(a));
                    sum += b * b, difference += (a - b) * (a - b);
                }
            }
            EXPECT_LT(std::sqrt(difference / sum), 0.002) << scale << " basis " << basis;
        }
    }
}

TEST(Extremes, ARoomWithoutLightIsBlack) {
    TestRoom room({0, 2, 0});
    room.r->bases.lampCount = 0; // no light basis at all
    ASSERT_TRUE(room.solve());
    for (float red : room.relit(1)) ASSERT_EQ(red, 0);
}

TEST(Extremes, FailsWithoutMemoryOrTime) {
    TestRoom small({0, 2, 0}), left({0, 2, 0});
    EXPECT_FALSE(small.solve({.links = 1000}));
    static const int gone = 1;
    left.workers.abort = &gone;
    EXPECT_FALSE(left.solve());
}
