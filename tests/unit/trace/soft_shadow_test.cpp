// Compares soft shadows and caustics with sampled discs, and with rays traced through glass.
#include "trace/shade/soft_shadow.h"

using namespace odraz;

// A ball at height 2 over the plane y = 0, and a lamp above it.
struct Eclipse {
    std::unique_ptr<Scene> scene = std::make_unique<Scene>();
    Light light = {{0, 10, 0}, {1, 1, 1}, 0.5f};
    Blockers blockers;

    Eclipse(float radius, float lamp, float ior, Rgb tint = {1, 1, 1}, float height = 2) {
        scene->clear();
        scene->add(
            sphere({0, height, 0}, radius, scene->add(Material{.diffuse = 1, .ior = ior, .tint = tint})));
        scene->ballsOcclude = true;
        scene->finish();
        light.radius = lamp;
        findBlockers(*scene, light, {{-4, 0, -4}, {4, 0, 4}}, blockers);
    }
    Rgb8 at(Vec3x8 p, int own = -1) const {
        Vec3x8 to = light.position - p;
        Float8 far = length(to);
        return softShadow(*scene, blockers, light, p, to * (1.f / far), far, broadcast(own));
    }
    float at(float x) const { return at({broadcast(x), Float8{}, Float8{}}).x[0]; }
};

// Returns the share of a lamp that a ball hides from (x, 0, 0), by rays to points spread evenly over the
// lamp's disc.
static double hiddenByRays(float x, float radius, float lamp, double height = 2) {
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

TEST(SoftShadow, HidesWhatTheDiscsShare) {
    for (auto [radius, lamp] : {std::pair{0.5f, 0.5f}, {1, 0.1f}, {0.5f, 2}, {0.2f, 3}, {1, 0.01f}}) {
        Eclipse e(radius, lamp, 0);
        double squares = 0;
        for (int i = 0; i < 200; ++i) {
            float x = (float)i * 0.02f;
            double error = 1 - e.at(x) - hiddenByRays(x, radius, lamp);
            squares += error * error;
            EXPECT_NEAR(error, 0, 0.05) << radius << ' ' << lamp << ' ' << x;
        }
        EXPECT_LT(std::sqrt(squares / 200), 0.02) << radius << ' ' << lamp;
    }
}

TEST(SoftShadow, IsCastOnlyByObjectsInBetween) {
    Eclipse e(0.5f, 0.5f, 0);
    EXPECT_EQ(e.blockers.count, 1);
    auto at = [&](float y, int own = -1) { return e.at(broadcast(Vec3{0, y, 0}), own).x[0]; };
    EXPECT_LT(at(0), 0.01); // below the ball
    EXPECT_EQ(at(0, 0), 1); // the ball itself
    EXPECT_EQ(at(5), 1);    // above the ball
    EXPECT_EQ(at(12), 1);   // beyond the lamp
    Blockers none;
    findBlockers(*e.scene, e.light, {{20, 0, -1}, {21, 0, 1}}, none);
    EXPECT_EQ(none.count, 0);
    findBlockers(*e.scene, e.light, {{-1, 12, -1}, {1, 13, 1}}, none);
    EXPECT_EQ(none.count, 0);
}

// Returns the share of the light on a glass ball that arrives in a disc of the radius `within`, on a plane at
// the distance z behind the ball's middle. Both are in units of the ball's radius. The light comes from far
// away and is refracted in and out. Losses follow Fresnel's equations.
static double withinByRays(double z, double within, double n) {
    double sum = 0;
    constexpr int kRays = 20000;
    for (int k = 0; k < kRays; ++k) {
        double height = (k + 0.5) / kRays, i = std::asin(height), r = std::asin(height / n),
               turn = 2 * (i - r), out = 2 * r - i;
        double y = std::sin(out) - std::tan(turn) * (z - std::cos(out));
        double across = std::pow((std::cos(i) - n * std::cos(r)) / (std::cos(i) + n * std::cos(r)), 2);
        double along = std::pow((n * std::cos(i) - std::cos(r)) / (n * std::cos(i) + std::cos(r)), 2);
        if (std::fabs(y) < within) sum += 2 * height / kRays * std::pow(1 - (across + along) / 2, 2);
    }
    return sum;
}

TEST(SoftShadow, OfGlassGathersTheLightThatItTakes) {
    for (float behind : {1.05f, 1.25f, 1.5f, 2.f, 3.f}) {
        constexpr float kRadius = 0.5f;
        Eclipse e(kRadius, 1.f, 1.5f, {0.6f, 1, 1}, behind * kRadius);
        e.light.position.y = 1000; // far away
        findBlockers(*e.scene, e.light, {{-1, 0, -1}, {1, 0, 1}}, e.blockers);
        for (float within : {0.1f, 0.2f, 0.4f, 0.8f}) {
            double sum = 0, red = 0;
            constexpr int kRings = 4000;
            for (int k = 0; k < kRings; ++k) {
                float y = ((float)k + 0.5f) / kRings * within;
                Rgb8 share = e.at(Vec3x8{broadcast(y * kRadius), Float8{}, Float8{}});
                ASSERT_TRUE(share.y[0] >= 0 && std::isfinite(share.y[0]));
                sum += (double)share.y[0] * 2 * y * within / kRings;
                red += (double)share.x[0] * 2 * y * within / kRings;
            }
            double truth = withinByRays(behind, within, 1.5);
            EXPECT_NEAR(sum, truth, 0.11) << behind << ' ' << within;
            EXPECT_LT(sum, 0.85); // no more than the ball receives
            EXPECT_NEAR(red, 0.6 * sum, 0.01);
        }
    }
}

TEST(SoftShadow, StaysFiniteAtTheExtremes) {
    for (float radius : {1e-4f, 1.f, 1e4f})
        for (float lamp : {1e-6f, 1.f, 1e5f})
            for (float ior : {0.f, 1.01f, 1.5f, 3.f}) {
                Eclipse e(radius, lamp, ior);
                for (float x : {0.f, 1e-6f, 1.f, 1e6f})
                    for (float y : {-1e6f, 0.f, 2.f, 9.999f, 10.f}) {
                        float v = e.at(Vec3x8{broadcast(x), broadcast(y), Float8{}}).x[0];
                        ASSERT_TRUE(v >= 0 && v < 121)
                            << v << ' ' << radius << ' ' << lamp << ' ' << x << ' ' << y;
                    }
            }
}
