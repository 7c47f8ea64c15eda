// Traces whole rays through small scenes and compares them with Phong's, Snell's and Fresnel's formulas.
#include "base/maths.h"
#include "tests/support/sanitized.h"
#include "tests/support/traced_picture.h"
#include "tests/support/traced_ray.h"

using namespace odraz;

// Materials with one property each.
static Material clearGlass(float ior) { return {.ior = ior}; }
static Material mirror(float reflect) { return {.reflect = reflect}; }
static Material glowing(Rgb radiance) { return {.emit = radiance}; }

static Material shiny(Rgb diffuse, float specular, float exponent) {
    Material m = matte(diffuse);
    m.specular = specular;
    m.exponent = exponent;
    return m;
}

static void expectNear(Rgb c, Rgb expected, float off) {
    EXPECT_NEAR(c.x, expected.x, off);
    EXPECT_NEAR(c.y, expected.y, off);
    EXPECT_NEAR(c.z, expected.z, off);
}

TEST(Phong, LightsAPlaneByDistanceAndAngle) {
    RayTracer g;
    g.scene->add(plane({0, 0, 0}, g.scene->add(matte({0.5f, 0.5f, 0.5f}))));
    g.scene->add(Light{{3, 4, 0}, {50, 100, 150}});
    Rgb expected = Rgb{50, 100, 150} * (0.5f / 25 * 0.8f); // I * albedo / r^2 * cos
    expectNear(g.trace({0, 2, 2}, {0, 0, 0}).radiance(), expected, 1e-4f);
}

TEST(Phong, HighlightIsThePowerOfTheMirrorAngle) {
    RayTracer g;
    g.scene->add(plane({0, 0, 0}, g.scene->add(shiny({0, 0, 0}, 0.7f, 30))));
    g.scene->add(Light{{0, 4, -3}, {25, 25, 25}});
    Vec3 mirrored = normalize(Vec3{0, 4, -3});
    Vec3 eye = {0.4f, 3, 2.5f}, reflected = normalize(eye * Vec3{-1, 1, -1});
    double expected = 0.7 * std::pow((double)dot(mirrored, reflected), 30);
    Sample s = g.trace(eye, {0, 0, 0});
    EXPECT_NEAR(s.radiance().x, expected, 1e-4);
    EXPECT_EQ(s.lights, 2u);
    Quality coarse = kExact;
    coarse.cutoff = 10; // a light this faint has no shadow
    EXPECT_NEAR(g.trace(eye, {0, 0, 0}, coarse).radiance().x, expected, 1e-4);
}

// A highlight that is smaller than a sample's footprint on the ball is drawn wider and paler, so that it does
// not blink when the ball moves. Its total light is the same.
TEST(Phong, HighlightIsWidenedByWhatASampleCovers) {
    RayTracer g;
    g.scene->add(sphere({0, 0, 0}, 1, g.scene->add(shiny({0, 0, 0}, 0.8f, 300))));
    g.scene->add(Light{{300, 300, 600}, {1e5f, 1e5f, 1e5f}});
    auto sumAndMost = [&](float size) {
        double sum = 0, most = 0;
        for (int i = -50; i <= 50; ++i)
            for (int j = -50; j <= 50; ++j) {
                float x = (float)i * 0.02f, y = (float)j * 0.02f, up = 1 - x * x - y * y;
                if (up <= 0) continue;
                // Equal steps across the view
                double v = (double)g.trace({x, y, 500}, {x, y, std::sqrt(up)}, kExact, size).radiance().x;
                sum += v, most = std::max(most, v);
            }
        return std::pair{sum, most};
    };
    auto [sum, most] = sumAndMost(1e-6f);
    auto [widerSum, widerMost] = sumAndMost(0.1f / 500 / 0.728f); // a sample covers 0.1 on the ball
    EXPECT_LT(widerMost, most * 0.25);
    EXPECT_NEAR(widerSum, sum, sum * 0.15);
}

TEST(Phong, DarkSideStaysDarkWithoutNaN) {
    RayTracer g;
    g.scene->add(sphere({0, 0, 0}, 1, g.scene->add(shiny({1, 1, 1}, 1, 7.5f))));
    g.scene->add(Light{{0, 0, -10}, {100, 100, 100}});
    Sample s = g.trace({0, 0, 5}, {0, 0, 0});
    EXPECT_EQ(s.radiance().x, 0);
    EXPECT_EQ(s.lights, 0u);
}

TEST(Shadow, IsHardBehindMatterAndTintedBehindGlass) {
    RayTracer g;
    g.scene->add(plane({0, 0, 0}, g.scene->add(matte({1, 1, 1}))));
    g.scene->add(Light{{0, 10, 0}, {100, 100, 100}});
    float open = g.trace({0, 1, 3}, {0, 0, 0}).light.x;
    EXPECT_NEAR(open, 1, 1e-4);
    Material glass = clearGlass(1.5f);
    glass.tint = {0.5f, 0.25f, 1};
    g.scene->add(sphere({0, 5, 0}, 1, g.scene->add(glass)));
    Sample through = g.trace({0, 1, 3}, {0, 0, 0});
    expectNear(through.light, {0.5f, 0.25f, 1}, 1e-4f);
    EXPECT_EQ(through.lights, 3u);
    g.scene->add(box({0, 3, 0}, {1, 0.1f, 1}, 0));
    EXPECT_EQ(g.trace({0, 1, 3}, {0, 0, 0}).light.x, 0);
}

// A light that is too faint for the quality casts no shadow. The shadow fades in with the light's strength,
// up to the full shadow of lights that matter.
FIGURES_TEST(Shadow, FadesInWithTheLightThatItTakes) {
    Quality coarse = kExact;
    coarse.cutoff = 1 / 24.f;
    float before = 0, most = 0;
    for (int i = 0; i <= 400; ++i) {
        float strength = 0.01f * (float)i / 100; // a share of the floor's light
        RayTracer g;
        g.scene->add(plane({0, 0, 0}, g.scene->add(matte({1, 1, 1}))));
        g.scene->add(box({0, 3, 0}, {1, 0.1f, 1}, 0));
        g.scene->add(Light{{0, 10, 0}, Rgb{100, 100, 100} * strength});
        float light = g.trace({0, 1, 3}, {0, 0, 0}, coarse).light.x;
        EXPECT_LE(std::abs(light - before), 2e-4f) << strength;
        if (strength < 0.2f * coarse.cutoff) {
            EXPECT_NEAR(light, strength, 1e-5f);
        }
        if (strength > 0.4f * coarse.cutoff) {
            EXPECT_EQ(light, 0) << strength;
        }
        before = light, most = std::max(most, light);
    }
    EXPECT_LE(most, 0.25f * coarse.cutoff);
}

TEST(Mirror, ShowsWhatIsBehindTheViewer) {
    RayTracer g;
    Material m = mirror(0.8f);
    m.tint = {1, 0.5f, 0.25f};
    g.scene->add(plane({0, 0, 0}, g.scene->add(m)));
    g.scene->sky = plainSky({1, 1, 1}, {1, 1, 1});
    expectNear(g.trace({0, 3, 3}, {0, 0, 0}).radiance(), {0.8f, 0.4f, 0.2f}, 1e-5f);
}

// The image of a lamp in a small ball, smaller than a sample's footprint, would blink as samples hit and miss
// it. So it is drawn wider and paler. It is bounded, because the mean of samples shows no more than white.
TEST(Mirror, WidensLampsThatNoSampleIsSureToMeet) {
    RayTracer g;
    g.scene->add(sphere({0, 0, 0}, 1, g.scene->add(mirror(1))));
    g.scene->add(sphere({0, 0, 20}, 1, g.scene->add(glowing({60, 60, 60}))));
    Vec3 eye = {0, 8, 8}, place = {0, 0.4f, 0.9f};
    // Find the image on the ball: where the normal is half-way between the directions to eye and lamp
    for (int i = 0; i < 20; ++i)
        place = normalize(normalize(eye - place) + normalize(Vec3{0, 0, 20} - place));
    EXPECT_NEAR(g.trace(eye, place, kExact, 1e-6f).radiance().x, 60, 0.1);
    EXPECT_NEAR(g.trace(eye, place, kExact, 1e-4f).radiance().x, 60, 0.5);
    float pale = g.trace(eye, place, kExact, 0.02f).radiance().x,
          paler = g.trace(eye, place, kExact, 0.04f).radiance().x;
    EXPECT_LT(pale, 20);
    EXPECT_LT(paler, pale * 0.5f);
    EXPECT_GT(paler, 0.005f);
    // Next to the image
    Vec3 beside = normalize(place + Vec3{0.06f, 0, 0});
    EXPECT_EQ(g.trace(eye, beside).radiance().x, 0);
    EXPECT_GT(g.trace(eye, beside, kExact, 0.02f).radiance().x, 0.01f);
}

// Two emitting mirrors face each other. A path ends at the depth limit, so its light is a finite geometric
// series, even with sixty-four bounces.
TEST(Mirror, RecursionEndsByDepthAndByContribution) {
    auto seen = [](float reflect, int depth, float cutoff) {
        RayTracer g;
        int id = g.scene->add(Material{.reflect = reflect, .emit = {1, 1, 1}});
        g.scene->add(plane({0, 0, 0}, id));
        g.scene->add(plane({0, 4, 0}, id));
        Quality q = kExact;
        q.depth = depth, q.cutoff = cutoff;
        return g.trace({0, 2, 0}, {0, 0, 0.01f}, q).radiance().x;
    };
    EXPECT_NEAR(seen(0.5f, 3, 1e-6f), 1 + 0.5 + 0.25 + 0.125, 1e-5);
    EXPECT_NEAR(seen(0.5f, 12, 0.2f), 1 + 0.5 + 0.25, 1e-5); // 0.25 goes on, 0.125 does not
    double all = (1 - std::pow(0.97, kMaxDepth + 1)) / (1 - 0.97);
    EXPECT_NEAR(seen(0.97f, kMaxDepth, 1e-6f), all, all * 1e-5);
}

// A path that ends, by depth or because its share is small, returns the average light, not darkness.
TEST(Mirror, ReturnsTheAverageWhereAPathEnds) {
    RayTracer g;
    g.scene->add(plane({0, 0, 0}, g.scene->add(mirror(0.5f))));
    g.scene->sky = plainSky({1, 1, 1}, {1, 1, 1});
    g.scene->ambientLow = {0.2f, 0.2f, 0.2f};
    g.scene->ambientHigh = {0.8f, 0.6f, 0.4f};
    Quality q = kExact;
    EXPECT_NEAR(g.trace({0, 2, 0}, {0, 0, 0}, q).radiance().y, 0.5, 1e-5);
    q.depth = 0;
    expectNear(g.trace({0, 2, 0}, {0, 0, 0}, q).radiance(), {0.4f, 0.3f, 0.2f}, 1e-5f);
    q.depth = 12;
    q.cutoff = 0.6f;
    EXPECT_NEAR(g.trace({0, 2, 2}, {0, 0, 0}, q).radiance().x, 0.5 * (0.5 + 0.3 * std::sqrt(0.5)), 1e-4);
}

// A ray along the axis of a glass ball: Fresnel's R at both surfaces, with all orders of inner reflection.
// The rest passes through.
TEST(Glass, KeepsEnergyOnTheAxis) {
    RayTracer g;
    g.scene->add(sphere({0, 0, 0}, 1, g.scene->add(clearGlass(1.5f))));
    g.scene->sky = plainSky({1, 1, 1}, {1, 1, 1});
    EXPECT_NEAR(g.trace({0, 0, 5}, {0, 0, 0}).radiance().x, 1, 1e-4);
}

TEST(Glass, FollowsSnell) {
    RayTracer g;
    // A lake, its surface at y = 0
    g.scene->add(box({0, -5, 0}, {100, 5, 100}, g.scene->add(clearGlass(1.5f))));
    double sine = std::sin(0.7) / 1.5, depth = 4, x = depth * sine / std::sqrt(1 - sine * sine);
    g.scene->add(sphere({(float)x, (float)-depth, 0}, 0.01f, g.scene->add(glowing({1, 0, 0}))));
    Vec3 eye = {(float)-std::sin(0.7), (float)std::cos(0.7), 0};
    EXPECT_GT(g.trace(eye, {0, 0, 0}).radiance().x, 0.9f);
    EXPECT_LT(g.trace(eye, {0.02f, 0, 0}).radiance().x, 0.1f);
}

// Behind a ball of glass a sample's footprint widens with its rays, most at the rim. A lamp that is narrower
// fades to the average light.
TEST(Glass, FadesLampsNarrowerThanASampleBehindIt) {
    RayTracer g;
    g.scene->add(sphere({0, 0, 0}, 1, g.scene->add(clearGlass(1.5f))));
    g.scene->add(box({0, 0, -5}, {0.1f, 50, 0.1f}, g.scene->add(glowing({1, 1, 1}))));
    g.scene->ambientLow = g.scene->ambientHigh = {0.2f, 0.2f, 0.2f};
    auto seen = [&](float y, float size) { return g.trace({0, y, 5}, {0, y, 0}, kExact, size).radiance().x; };
    EXPECT_GT(seen(0, 0.008f), 0.9f); // 0.08 wide there
    EXPECT_LT(seen(0, 0.024f), 0.3f);
    EXPECT_GT(seen(0.9f, 0.001f), 0.7f); // 0.04
    EXPECT_LT(seen(0.9f, 0.008f), 0.3f);
}

TEST(Glass, AbsorbsByPathLength) {
    RayTracer g;
    Material m = clearGlass(1.0001f); // hardly reflects
    m.absorb = {1, 2, 0};
    g.scene->add(sphere({0, 0, 0}, 0.5f, g.scene->add(m)));
    g.scene->sky = plainSky({1, 1, 1}, {1, 1, 1});
    // 2^-1 through one unit
    expectNear(g.trace({0, 0, 5}, {0, 0, 0}).radiance(), {0.5f, 0.25f, 1}, 1e-3f);
}

TEST(View, HasAPictureForEveryDegenerateLook) {
    for (Vec3 target : {Vec3{0, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0}, Vec3{1e-20f, 0, 0}, Vec3{0, 0, 1e10f}})
        for (float fov : {0.f, 40.f, 170.f, 1e9f}) {
            View v = lookAt({0, 0, 0}, target, 33, fov, 1, 1);
            for (Vec3 a : {v.forward, v.right, v.down}) {
                float n = length(a);
                EXPECT_TRUE(n > 1e-5f && n < 1e3f) << n;
            }
            EXPECT_NEAR(dot(v.forward, v.right), 0, 1e-3);
        }
}

TEST(View, PutsTheTargetInTheMiddleAndUpOnTop) {
    View v = lookAt({1, 2, 3}, {4, 2, 3}, 0, 90, 200, 100);
    Vec3 middle = normalize(v.direction(100.f, 50.f)), top = v.direction(100.f, 0.f);
    EXPECT_NEAR(middle.x, 1, 1e-6);
    EXPECT_NEAR(top.y / top.x, 1, 1e-5); // half of 90 degrees up
    View rolled = lookAt({1, 2, 3}, {4, 2, 3}, 90, 90, 100, 100);
    EXPECT_NEAR(rolled.direction(50.f, 0.f).y, 0, 1e-5);
}

// A lamp's size softens only shadows of balls, which have closed forms. All other shadows are hard, even
// shadows of objects that are nearer to the floor than the lamp's radius.
TEST(Shadow, OfALargeLampReachesTheFloor) {
    auto s = emptyScene();
    s->add(matte({0.5f, 0.5f, 0.5f}));
    s->add(plane({0, 0, 0}, 0));
    s->add(sphere({0, 0.4f, 0}, 0.3f, 0));
    s->add(Light{{-30, 40, 0}, {2500, 2500, 2500}, 1.8f});
    s->finish();
    // Its shadow lies around x = 0.3
    TracedPicture p = traced(*s, {0, {3, 3, 0}, {0.3f, 0, 0}, 0, 30}, named(QualityName::Play), 160, 90);
    EXPECT_LT(p.at(80, 45, 1), 5);
    EXPECT_GT(p.at(20, 45, 1), 50);
}
