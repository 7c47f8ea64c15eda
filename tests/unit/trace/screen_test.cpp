// Soft shadows and caustics against discs sampled by hand, and against rays traced through glass.
#include "trace/shade/screen.h"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>

using namespace odraz;

namespace {

// A ball at height 2 over the plane y = 0, and a lamp above it.
struct Eclipse {
    std::unique_ptr<Scene> scene = std::make_unique<Scene>();
    Light light = {{0, 10, 0}, {1, 1, 1}, 0.5f};
    Screens screens;

    Eclipse(float radius, float lamp, float ior, Rgb tint = {1, 1, 1}, float height = 2) {
        scene->clear();
        Material m = {};
        m.diffuse = 1;
        m.ior = ior;
        m.tint = tint;
        scene->add(m);
        scene->add(sphere({0, height, 0}, radius, 0));
        scene->contact = true;
        scene->finish();
        light.radius = lamp;
        findScreens(*scene, light, {{-4, 0, -4}, {4, 0, 4}}, screens);
    }
    Rgb8 at(Vec3x8 p, int own = -1) const {
        Vec3x8 to = light.position - p;
        Float8 far = length(to);
        return passScreens(*scene, screens, light, p, to * (1.f / far), far, broadcast(own));
    }
    float at(float x) const { return at({broadcast(x), Float8{}, Float8{}}).x[0]; }
};

// What a ball hides of a lamp seen from (x, 0, 0), by rays to places evenly spread over the lamp's disc
double hiddenByRays(float x, float radius, float lamp, double height = 2) {
    Vec3 p = {x, 0, 0}, axis = normalize(Vec3{0, 10, 0} - p), u = normalize(cross(axis, Vec3{0, 0, 1})),
         v = cross(axis, u);
    int hidden = 0, all = 0;
    for (int a = 0; a < 200; ++a)
        for (int b = 0; b < 200; ++b) {
            float s = ((float)a + 0.5f) / 100 - 1, t = ((float)b + 0.5f) / 100 - 1;
            if (s * s + t * t > 1) continue;
            Vec3 d = normalize(Vec3{0, 10, 0} + u * (s * lamp) + v * (t * lamp) - p),
                 to = Vec3{0, (float)height, 0} - p;
            float along = dot(to, d);
            Vec3 off = to - d * along;
            hidden += along > 0 && dot(off, off) < radius * radius;
            ++all;
        }
    return (double)hidden / all;
}

} // namespace

TEST(Screens, HideWhatTheDiscsShare) {
    struct Case {
        float radius, lamp;
    };
    for (Case c : {Case{0.5f, 0.5f}, {1, 0.1f}, {0.5f, 2}, {0.2f, 3}, {1, 0.01f}}) {
        Eclipse e(c.radius, c.lamp, 0);
        double squares = 0;
        for (int i = 0; i < 200; ++i) {
            float x = (float)i * 0.02f;
            double error = 1 - e.at(x) - hiddenByRays(x, c.radius, c.lamp);
            squares += error * error;
            EXPECT_NEAR(error, 0, 0.05) << c.radius << ' ' << c.lamp << ' ' << x;
        }
        EXPECT_LT(std::sqrt(squares / 200), 0.02) << c.radius << ' ' << c.lamp;
    }
}

TEST(Screens, AreWhatStandsBetweenAlone) {
    Eclipse e(0.5f, 0.5f, 0);
    EXPECT_EQ(e.screens.count, 1);
    Vec3x8 below = {Float8{}, Float8{}, Float8{}}, above = {Float8{}, broadcast(5.f), Float8{}},
           beyond = {Float8{}, broadcast(12.f), Float8{}};
    EXPECT_LT(e.at(below).x[0], 0.01);
    EXPECT_EQ(e.at(below, 0).x[0], 1); // its own
    EXPECT_EQ(e.at(above).x[0], 1);
    EXPECT_EQ(e.at(beyond).x[0], 1);
    Screens none;
    findScreens(*e.scene, e.light, {{20, 0, -1}, {21, 0, 1}}, none);
    EXPECT_EQ(none.count, 0);
    findScreens(*e.scene, e.light, {{-1, 12, -1}, {1, 13, 1}}, none);
    EXPECT_EQ(none.count, 0);
}

// All that arrives on a plane behind a ball of glass is what would have, less what the tint takes; and it is
// gathered as strongly as rays find that are refracted twice.
TEST(Screens, GatherWhatGlassTakes) {
    for (float height : {0.55f, 0.75f, 1.f, 2.f, 4.f}) {
        for (float tint : {1.f, 0.6f}) {
            Eclipse e(0.5f, 0.05f, 1.5f, {tint, 1, 1}, height);
            double change = 0, shadow = 0, brightest = 0;
            constexpr float kStep = 0.01f;
            for (int a = -200; a < 200; ++a)
                for (int b = -200; b < 200; b += 8) {
                    Vec3x8 p = {broadcast(((float)a + 0.5f) * kStep), Float8{},
                                (toFloat(kLanes) + ((float)b + 0.5f)) * kStep};
                    Rgb8 share = e.at(p);
                    for (int k = 0; k < 8; ++k) {
                        ASSERT_TRUE(share.x[k] >= 0 && std::isfinite(share.x[k]));
                        change += (share.x[k] - 1) * kStep * kStep;
                        shadow += std::fmax(1 - share.y[k], 0.) * kStep * kStep;
                        brightest = std::fmax(brightest, share.y[k]);
                    }
                }
            // The shadow's area, seen from a lamp so far
            double area = M_PI * 0.25 * std::pow(10 / (10 - height), 2);
            EXPECT_LE(change, 0.01 * area) << height;
            EXPECT_NEAR(change, (tint - 1) * area, 0.25 * area) << height;
            EXPECT_GT(shadow, 0);
            EXPECT_GT(brightest, height < 1.5f ? 3 : 0) << height;
        }
    }
}

TEST(Screens, StayFiniteAtTheExtremes) {
    for (float radius : {1e-4f, 1.f, 1e4f})
        for (float lamp : {1e-6f, 1.f, 1e5f})
            for (float ior : {0.f, 1.01f, 1.5f, 3.f}) {
                Eclipse e(radius, lamp, ior);
                for (float x : {0.f, 1e-6f, 1.f, 1e6f})
                    for (float y : {-1e6f, 0.f, 2.f, 9.999f, 10.f}) {
                        float v = e.at(Vec3x8{broadcast(x), broadcast(y), Float8{}}).x[0];
                        ASSERT_TRUE(v >= 0 && v < 100)
                            << v << ' ' << radius << ' ' << lamp << ' ' << x << ' ' << y;
                    }
            }
}
