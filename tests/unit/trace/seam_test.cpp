// Tests that no light passes between rectangles that join, directly or by a mirror, and that none is lost
// there.
#include "tests/support/dice.h"
#include "tests/support/traced_ray.h"

using namespace odraz;

// The size and position of a room, the distance of its light, and the tangent of the light's elevation.
struct Pose {
    float size, away, far, height;
};
constexpr Pose kPoses[] = {
    {1, 1, 300, 1},       {1, 1, 300, 0.1f},    {1, 1, 20, 1},
    {1, 100, 3000, 0.3f}, {1e-3f, 1e-3f, 1, 1}, {1e3f, 1e3f, 1e5f, 1},
};

// Returns offsets of any size to both sides, from 1e-7 to 1e-2.
struct Near {
    Dice dice{5};
    float operator()() {
        float step = std::pow(10.f, -2 - 5 * dice(0, 1));
        return dice(0, 1) < 0.5f ? step : -step;
    }
};

// Traces rays from above and from the right to points around the joint of two rectangles at x. Returns the
// number of samples for which `which` is true.
template <class Which> int count(RayTracer &g, const Pose &p, Which &&which) {
    Near near;
    int count = 0;
    float x = -4.5f * p.away / p.size;
    for (int i = 0; i < 3000; ++i) {
        Vec3 at = {(x + near()) * p.size, near() * p.size, (near.dice(0, 1) - 0.5f) * p.size};
        Vec3 eye = {(x + 3) * p.size, 2 * p.size, (near.dice(0, 1) - 0.5f) * p.size};
        count += which(g.trace(eye, at));
    }
    return count;
}

// A floor and a wall at its end. The sun and a bright sky are behind the wall.
TEST(Seam, OfFloorAndWallLetsNoLightIn) {
    for (const Pose &p : kPoses)
        for (float mirror : {0.f, 0.5f}) {
            RayTracer g;
            Material m = matte({0.5f, 0.5f, 0.5f});
            m.reflect = mirror;
            g.scene->add(m);
            g.scene->add(matte({0.5f, 0.5f, 0.5f}));
            float s = p.size, x = -4.5f * p.away;
            g.scene->add(rect({x + 4.5f * s, 0, 0}, {0, 0, 1}, {1, 0, 0}, 9 * s, 4.5f * s, 0));
            g.scene->add(rect({x, 3 * s, 0}, {0, 1, 0}, {0, 0, 1}, 3 * s, 9 * s, 1));
            ASSERT_GT(g.scene->shapes[0].frame.v.y, 0);
            ASSERT_GT(g.scene->shapes[1].frame.v.x, 0);
            // The sun is so low that its light does not pass over the wall
            Vec3 sun = normalize(Vec3{-1, p.height, 0.2f}) * p.far;
            g.scene->add(Light{sun + Vec3{x, 0, 0}, Rgb{1, 1, 1} * (p.far * p.far)});
            g.scene->sky = plainSky({1, 1, 1}, {1, 1, 1});
            EXPECT_EQ(count(g, p, [](const Sample &s) { return maxComponent(s.radiance()) > 0.01f; }), 0)
                << p.size << " " << p.far << " " << mirror;
        }
}

// The sun lights the top and a side of a box made of rectangles: their common edge is not darker.
TEST(Seam, OfTopAndSideCastsNoShadow) {
    for (const Pose &p : kPoses) {
        RayTracer g;
        g.scene->add(matte({1, 1, 1}));
        float s = p.size, x = -4.5f * p.away;
        g.scene->add(rect({x + 4.5f * s, 0, 0}, {0, 0, 1}, {1, 0, 0}, 9 * s, 4.5f * s, 0));
        g.scene->add(rect({x, -3 * s, 0}, {0, 1, 0}, {0, 0, -1}, 3 * s, 9 * s, 0));
        ASSERT_LT(g.scene->shapes[1].frame.v.x, 0);
        for (float side : {-1.f, 1.f}) {
            Vec3 sun = normalize(Vec3{side, p.height, 0.2f});
            g.scene->lightCount = 0;
            g.scene->add(Light{sun * p.far + Vec3{x, 0, 0}, Rgb{1, 1, 1} * (p.far * p.far)});
            auto dark = [&](const Sample &s) { return s.id == 1 && s.radiance().x < 0.8f * sun.y; };
            EXPECT_EQ(count(g, p, dark), 0) << p.size << " " << p.far << " " << side;
        }
    }
}
