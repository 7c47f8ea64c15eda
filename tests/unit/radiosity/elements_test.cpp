// Elements: quadtrees without cracks, hidden places, and the rules for dividing.
#include "radiosity/spread.h"
#include "radiosity/ties.h"
#include "radiosity/visible.h"
#include "tests/support/dice.h"
#include "tests/support/model_bench.h"
#include "tests/support/room.h"
#include "trace/rays/intersect.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

using namespace odraz;

namespace {

struct Divided : ModelBench {
    void divide(int block = 2, int levels = kFinest) {
        pose();
        ASSERT_TRUE(model->divide(*scene, memory.arena, workers, block, levels));
        settleFresh(*model);
    }
    template <class Of> std::vector<float> plane(Of of) const {
        std::vector<float> all((size_t)model->texelRoom + 8);
        for (int i = 0; i < model->texelCount; ++i) all[(size_t)i] = of(model->texels[i]);
        return all;
    }
    // The value of a plane at a place of a chart, as the tracer computes it.
    float at(const std::vector<float> &plane, int chart, float u, float v) const {
        Lightmap map = {};
        map.charts = model->charts;
        map.cells = model->cells;
        for (auto &p : map.plane) p = plane.data();
        const Chart &c = model->charts[chart];
        return lightAt(map, c, broadcast(c.at(u, v))).y[0];
    }
};

} // namespace

// Divides cells at random down to all depths and gives every texel a random value. After the ties are
// applied, no value jumps anywhere.
TEST(Quadtree, HasNoCracksWhateverIsDivided) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        Divided d;
        d.model->addRect({0, 0, 0}, {0, 0, 3}, {5, 0, 0}, 0, 1);
        d.divide();
        Model &m = *d.model;
        std::mt19937 random(seed);
        for (int i = 0; i < m.cellCount; ++i) // the count grows in this loop
            if (!m.cells[i].divided() && m.cells[i].level < kFinest && random() % 3 == 0) split(m, i);
        settleFresh(m);
        for (int i = 0; i < m.texelCount; ++i) m.texels[i].visible = 15;
        tie(m);
        auto plane = d.plane([&](const Texel &) { return (float)(random() % 1000) * 0.001f; });
        settle(m, plane.data());
        // Along the border of every cell, just inside and just outside
        for (int i = 0; i < m.cellCount; ++i) {
            const Cell &cell = m.cells[i];
            if (cell.divided()) continue;
            const Chart &c = m.charts[0];
            const Texel &low = m.texels[cell.corner[0]], &high = m.texels[cell.corner[3]];
            float du = c.width / (float)(c.across * kSteps), dv = c.height / (float)(c.down * kSteps);
            for (int k = 0; k <= 16; ++k) {
                float u = ((float)low.x + (float)(high.x - low.x) * (float)k / 16) * du,
                      v = ((float)low.y + (float)(high.y - low.y) * (float)k / 16) * dv;
                auto expectEven = [&](float u, float v, float du, float dv) {
                    ASSERT_NEAR(d.at(plane, 0, u - du, v - dv), d.at(plane, 0, u + du, v + dv), 2e-3f)
                        << seed;
                };
                for (const Texel *t : {&low, &high}) {
                    expectEven((float)t->x * du, v, 2e-5f, 0);
                    expectEven(u, (float)t->y * dv, 0, 2e-5f);
                }
            }
        }
    }
}

TEST(Quadtree, SharesCornersAndKeepsAreas) {
    Divided d;
    d.model->addRect({0, 0, 0}, {0, 0, 2}, {2, 0, 0}, 0, 1);
    d.divide();
    Model &m = *d.model;
    ASSERT_EQ(m.texelCount, 9);
    split(m, 0);
    EXPECT_EQ(m.texelCount, 9 + 5);
    split(m, 1); // its side with the first cell has a middle already
    EXPECT_EQ(m.texelCount, 9 + 5 + 4);
    EXPECT_EQ(m.freshCount, 9 + 6); // the new ones, and the corners, whose places have moved closer
    settleFresh(m);
    float area = 0;
    for (int i = 0; i < m.cellCount; ++i)
        if (!m.cells[i].divided()) area += m.cells[i].area;
    EXPECT_FLOAT_EQ(area, 4);
}

// Whichever cells are divided and hidden, texels, cells and ties stay within the memory that was taken.
TEST(Quadtree, HasRoomForAllLevels) {
    for (int levels = 0; levels <= kFinest; ++levels)
        for (unsigned seed = 0; seed < 6; ++seed) {
            Divided d;
            for (Vec3 side : {Vec3{1, 0, 0}, Vec3{7, 0, 0}, Vec3{3, 0, 0}})
                d.model->addRect({}, {0, 0, 5}, side, 0, 1);
            d.divide(1, levels);
            Model &m = *d.model;
            std::mt19937 random(seed);
            // Divide all, most or few cells
            for (int i = 0; i < m.cellCount; ++i)
                if (m.cells[i].level < levels && random() % 3 >= seed % 3) split(m, i);
            settleFresh(m);
            // Make few or many places visible
            for (int i = 0; i < m.texelCount; ++i)
                m.texels[i].visible = random() % 4 < seed ? 15 : random() % 4 ? 0 : 1;
            tie(m);
            EXPECT_LE(m.texelCount, m.texelRoom) << levels;
            EXPECT_LE(m.cellCount, m.cellRoom) << levels;
            EXPECT_LE(m.tieCount, m.tieRoom) << levels;
            if (seed % 3 == 0) {
                EXPECT_EQ(m.cellCount, m.cellRoom) << levels;
            }
        }
}

TEST(Model, CannotBeDividedIfTooLarge) {
    Divided d;
    Model &m = *d.model;
    auto divides = [&] { return d.model->divide(*d.scene, d.memory.arena, d.workers, 1, 0); };
    d.scene->finish();
    m.addRect({}, {0, 0, 1}, {1, 0, 0}, 0, 1, Model::kPieces);
    for (int i = 0; i < kMaxFacets; ++i) m.addFacet(0, 0, 1, 1);
    EXPECT_FALSE(m.overflow);
    m.addFacet(0, 0, 1, 1);
    EXPECT_TRUE(m.overflow);
    EXPECT_FALSE(divides());
    d.model = std::make_unique<Model>();
    Model &other = *d.model;
    for (int i = 0; i < kMaxCharts; ++i) other.addRect({}, {0, 0, 1}, {1, 0, 0}, 0, 1, Model::kPieces);
    EXPECT_FALSE(other.overflow);
    EXPECT_TRUE(divides());
    other.addRect({}, {0, 0, 1}, {1, 0, 0}, 0, 1);
    EXPECT_FALSE(divides());
    EXPECT_EQ(other.chartCount, kMaxCharts);
}

// An edge of light crosses a floor: only the cells along it are divided.
TEST(Refine, FollowsTheEdge) {
    Divided d;
    d.model->addRect({0, 0, 0}, {0, 0, 8}, {8, 0, 0}, 0, 1);
    d.divide();
    Model &m = *d.model;
    auto light = [](float u, float v) { return u + 0.3f * v > 5 ? 1.f : 0.f; };
    auto lit = [&] {
        for (int i = 0; i < m.texelCount; ++i) m.texels[i].visible = 15;
        return d.plane([&](const Texel &t) { return light((float)t.x / kSteps, (float)t.y / kSteps); });
    };
    std::vector<float> plane = lit();
    for (int level = 0; level < kFinest; ++level) {
        Measure seen;
        ASSERT_TRUE(measure(m, plane.data(), 0.2f, seen));
        refine(m, level, &seen, 1, 0.2f);
        plane = lit();
        settleFresh(m);
    }
    for (int i = 0; i < m.cellCount; ++i) {
        const Cell &cell = m.cells[i];
        if (cell.divided()) continue;
        float low = 1, high = 0;
        for (int corner : cell.corner)
            low = std::fmin(low, plane[(size_t)corner]), high = std::fmax(high, plane[(size_t)corner]);
        if (high > low) {
            EXPECT_EQ(cell.level, kFinest);
        }
    }
    // The finest cells form a line, not an area
    EXPECT_LT(m.cellCount, 8 * 8 + 4 * 8 * (2 + 4 + 8) * 2);
    Measure dark;
    std::fill(plane.begin(), plane.end(), 0.f);
    EXPECT_FALSE(measure(m, plane.data(), 0.2f, dark));
}

// A block stands on the floor. Cells along its edge are divided to the finest level, and texels under it take
// the light around it.
TEST(Refine, DividesWhatIsHiddenInPart) {
    Divided d;
    d.model->solid = true;
    addRoom(*d.model, {-4, 0, -4}, {4, 3, 4}, 1);
    d.model->addBox({-1.3f, 0, -1.3f}, {1.3f, 1, 1.3f}, 0, 1, Model::kUpright | Model::kTop);
    d.divide();
    Model &m = *d.model;
    for (int level = 0; level < 2; ++level) {
        refine(m, level, nullptr, 0, 1);
        findVisible(m, *d.scene, d.workers);
        settleFresh(m);
    }
    int hidden = 0;
    auto plane = d.plane([&](const Texel &t) {
        if (t.chart != 0) return 0.f;
        Vec3 p = m.charts[0].at((float)t.x / kSteps, (float)t.y / kSteps);
        bool under = std::fabs(p.x) < 1.2f && std::fabs(p.z) < 1.2f;
        if (under) {
            EXPECT_EQ(t.visible, 0) << p.x << ' ' << p.z;
        } else if (std::fabs(p.x) > 1.4f || std::fabs(p.z) > 1.4f) {
            EXPECT_NE(t.visible, 0) << p.x << ' ' << p.z;
        }
        hidden += t.visible == 0;
        return t.visible ? 5.f : 0.f;
    });
    EXPECT_GT(hidden, 20);
    tie(m);
    settle(m, plane.data());
    for (float u = 0.1f; u < 8; u += 0.1f)
        for (float v = 0.1f; v < 8; v += 0.1f) ASSERT_FLOAT_EQ(d.at(plane, 0, u, v), 5) << u << ' ' << v;
    // The mean of a patch counts only what is visible of it
    std::vector<float> mean((size_t)m.patchCount);
    meansOfPatches(m, plane.data(), mean.data(), 1);
    for (int i = 0; i < m.patchCount; ++i)
        if (m.patches[i].chart == 0 && m.patches[i].area > 0) {
            EXPECT_NEAR(mean[(size_t)i], 5, 1e-4f);
        }
}

// In open models, places that see only backs are hidden; places below a sheet that hovers are not.
TEST(Hidden, InOpenModelsOnlyWhatSeesNothingElse) {
    Divided d;
    addRoom(*d.model, {-4, 0, -4}, {4, 3, 4}, 1);
    d.model->addBox({-0.6f, 0, -0.6f}, {0.6f, 3, 0.6f}, 0, 1,
                    Model::kUpright);                        // a tube up to the ceiling, without lids
    d.model->addRect({2, 1, 2}, {0, 0, 1}, {1, 0, 0}, 0, 1); // a sheet lit from above
    d.divide();
    const Model &m = *d.model;
    const Chart &floor = m.charts[0];
    auto texel = [&](float x, float z) { // the floor's u is z, its v is x
        return m.texels[floor.texel((int)std::lround(z + 4), (int)std::lround(x + 4))];
    };
    EXPECT_EQ(texel(0, 0).visible, 0);
    EXPECT_EQ(texel(2, 2).visible, 15);
    EXPECT_EQ(texel(3, 3).visible, 15);
    EXPECT_EQ(texel(-3, 2).visible, 15);
}

TEST(Triangles, AreMetAsPartOfTheirChart) {
    auto scene = std::make_unique<Scene>();
    Dice dice(7);
    // Two triangles share a side: no ray passes between them, and rays beside both miss
    for (int i = 0; i < 200; ++i) {
        scene->clear();
        Vec3 a = dice.point(1), u = dice.point(1), v = dice.point(1);
        if (length(cross(u, v)) < 0.05f) continue;
        Vec3 n = normalize(cross(u, v));
        scene->add(triangle(a, u, v, n));
        scene->add(triangle(a + u + v, -u, -v, n));
        scene->finish();
        for (int k = 0; k < 50; ++k) {
            float s = dice(0, 1), t = k % 2 ? 1 - s : dice(0, 1);
            Vec3 p = a + u * s + v * t, from = p + n * 2.f + u * dice(-1, 1);
            auto meet = [&](Vec3 o, Vec3 d) {
                return intersect(*scene, {broadcast(o), broadcast(d)}, kLanes < 1);
            };
            Vec3 out = a + u * (1.01f + std::fabs(s)) + v * t;
            ASSERT_EQ(meet(out + n, -n).shape[0], -1);
            // A ray from behind does not hit; light is stopped from both sides
            ASSERT_EQ(meet(p - n, n).shape[0], -1);
            if (s < 1e-3f || s > 0.999f || t < 1e-3f || t > 0.999f) continue;
            ASSERT_NEAR(meet(from, normalize(p - from)).t[0], length(p - from), 1e-4f);
            Ray8 behind = {broadcast(p - n), broadcast(n)};
            ASSERT_EQ(transmittance(*scene, behind, broadcast(2.f), kLanes < 1, broadcast(-1)).x[0], 0);
        }
    }
}
