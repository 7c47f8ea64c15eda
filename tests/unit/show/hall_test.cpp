// Tests the film's hall: its light over the day, and bounces. (traced_hall_test compares its hemicubes with
// rays.)
#include "show/materials.h"
#include "tests/support/figure.h"
#include "tests/support/film_hall.h"
#include "tests/support/hemicube_bench.h"
#include "tests/support/sanitized.h"
#include "tests/support/traced_ray.h"

using namespace odraz;

constexpr Vec3 kEye = {0, 1.6f, 3};

static FilmHall &solved() { return FilmHall::drawn(); }
// Returns a scene with the lit hall.
static std::unique_ptr<Scene> posed(const HallLight &light) {
    auto scene = emptyScene();
    poseHall(*solved().hall, light, 0, kEye, *scene);
    return scene;
}

// The hall fits the memory of a room, with a reserve but without waste. With all its lights on, it is below
// the limits of a scene.
TEST(Hall, FitsAndWastesNothing) {
    FilmHall &s = solved();
    double used = (double)s.memory.arena.used / (double)s.memory.arena.size;
    EXPECT_LT(used, 0.8);
    EXPECT_GT(used, 0.6);
    auto scene = posed({kNight, {1, 0.7f, 0.3f}, {1, 1, 1, 1, 1, 1, 1, 1}, 1});
    EXPECT_LE(scene->materialCount, kMaxMaterials - 8); // the rest are for the balls of a scene in the hall
    EXPECT_LE(scene->lightCount, kMaxLights - 2);
}

// The hall is closed: for every patch, the form factors of the film's hemicube, with windows and lamps, sum
// to 1.
TEST(Hall, IsClosed) {
    FilmHall &s = solved();
    const Model &m = s.hall->model;
    SingleHemicube hemicube(kHallSettings.px);
    for (int i = 0; i < m.patchCount; i += kSanitized ? 7 : 1) {
        const Patch &p = m.patches[i];
        if (p.share == 0 || m.charts[p.chart].open) continue;
        Eye eye = hemicubeEye(p.p, m.charts[p.chart].n, (uint32_t)i);
        double dark;
        std::vector<float> row = hemicube.row(m, eye, &dark);
        EXPECT_NEAR(std::accumulate(row.begin(), row.end(), dark), 1, 1e-6);
        EXPECT_LT(dark, 1e-6) << "patch " << i << " of chart " << p.chart << " at " << p.p.x << ' ' << p.p.y
                              << ' ' << p.p.z;
    }
}

TEST(Hall, IsLitUntilNightAndNeverNegative) {
    const Hall &hall = *solved().hall;
    float noon = 0, sunset = 0, night = 0;
    for (float hour = 0; hour <= (float)kNight; hour += kSanitized ? 1 : 0.25f) {
        auto scene = posed({hour, {}, {}, 1});
        for (float *plane : hall.light)
            for (int i = 0; i < hall.model.texelCount; ++i)
                ASSERT_TRUE(plane[i] >= 0 && plane[i] < 100) << hour;
        if (hour == (float)kNoon) noon = scene->ambientHigh.y;
        if (hour == (float)kSunset) sunset = scene->ambientHigh.y;
        night = scene->ambientHigh.y;
    }
    EXPECT_GT(noon, 0);
    EXPECT_GT(sunset, 0);
    EXPECT_EQ(night, 0); // no light comes from outside
}

// The tracer draws the two strongest lanterns, the lightmap the others. When one lantern overtakes another,
// the sum of both must change as slowly as the lanterns: nothing pops.
TEST(Hall, LanternsSwapWithoutAJump) {
    const Hall &hall = *solved().hall;
    const Chart &floor = hall.model.charts[hall.floor];
    int texel = floor.texel(floor.across / 2, floor.down / 2);
    Vec3 place = floor.at((float)(floor.across / 2) * floor.width / (float)floor.across,
                          (float)(floor.down / 2) * floor.height / (float)floor.down);
    double last = -1;
    int most = 0;
    for (int step = 0; step <= (kSanitized ? 100 : 1000); ++step) {
        float t = (float)step * 0.001f;
        auto scene = posed({kNight, {t, 0.6f, 1 - t}, {}, 1});
        double light = (double)hall.light[1][texel];
        most = std::max(most, scene->lightCount);
        for (int i = 0; i < scene->lightCount; ++i) {
            const Light &l = scene->lights[i];
            if (l.position.y > 100) continue;
            Vec3 to = l.position - place;
            light += (double)(l.intensity.y * to.y / (dot(to, to) * length(to)));
        }
        if (last >= 0) {
            EXPECT_NEAR(light, last, 0.01 * last) << t;
        }
        last = light;
    }
    EXPECT_LE(most, kLanterns); // while two swap; at night there is no sun
    EXPECT_EQ(posed({kNight, {1, 0.7f, 0.3f}, {}, 1})->lightCount, 2);
}

// Each bounce adds light, but less than the one before, and their sum approaches the solution.
TEST(Hall, BouncesConvergeToTheSolution) {
    const Hall &hall = *solved().hall;
    double mean[kBounces + 1] = {}, solution = 0;
    const System &system = hall.radiosity.system;
    LightVector noon = lightVector({kNoon, {}, {}, 1});
    for (int i = 0; i < hall.model.patchCount; ++i) {
        const Patch &p = hall.model.patches[i];
        const Chart &c = hall.model.charts[p.chart];
        Rgb rho = hall.mean[c.material];
        if (p.share == 0 || rho.y == 0) continue;
        for (int b = 0; b <= kBounces; ++b) {
            mean[b] += (double)(hall.bounce[b][i].y * rho.y);
            if (b > 0) {
                EXPECT_GE(hall.bounce[b][i].y, hall.bounce[b - 1][i].y * 0.9999f);
            }
        }
        for (int k = 0; k < kFirstLantern; ++k)
            solution += (double)(system.radiosity[i * system.columns + 3 * k + 1] * noon.bounced[k].y);
    }
    for (int b = 1; b <= kBounces; ++b) {
        EXPECT_GT(mean[b], mean[b - 1]);
        EXPECT_LT(mean[b], solution * 1.001);
        if (b > 1) {
            EXPECT_LT(mean[b] - mean[b - 1], mean[b - 1] - mean[b - 2]);
        }
    }
    expectAtMost("share of later bounces", 1 - mean[kBounces] / solution, 0.1);
}

// Windows let light out and reflect none, in every basis.
TEST(Hall, WindowsReflectNothing) {
    const Hall &hall = *solved().hall;
    const System &system = hall.radiosity.system;
    double out = 0, in = 0;
    for (int i = 0; i < hall.model.patchCount; ++i)
        if (hall.model.charts[hall.model.patches[i].chart].open)
            for (int k = 0; k < system.columns; ++k) {
                out += std::fabs((double)system.radiosity[i * system.columns + k]);
                in += std::fabs((double)system.direct[i * system.columns + k]);
            }
    EXPECT_EQ(out, 0);
    EXPECT_GT(in, 0);
}

// A ball reduces the light of the floor below it by exactly the ball's form factor.
TEST(Hall, ABallDarkensTheFloorBelow) {
    const Hall &hall = *solved().hall;
    constexpr float kRadius = 0.5f;
    Vec3 foot = hall.model.patches[hall.visited].p;
    View view = lookAt(foot + Vec3{0, 3, 0}, foot, 0, 90, 64, 64); // a pixel is 6 / 64 of a metre
    auto lightAround = [&](bool ball) {
        auto scene = posed({kNoon, {}, {}, 0});
        if (ball) scene->add(sphere(foot + Vec3{0, kRadius, 0}, kRadius, scene->add(kMirror)));
        scene->finish();
        std::vector<float> x;
        for (int i = 0; i < 16; ++i) x.push_back(32 + (0.62f + 0.05f * (float)i) * 64 / 6);
        return samplesAt(*scene, view, QualityName::Reference, x, std::vector<float>(16, 32));
    };
    auto open = lightAround(false), covered = lightAround(true);
    for (int i = 0; i < 16; ++i) {
        double d = 0.62 + 0.05 * i, square = d * d + 0.25, factor = 0.5 / std::sqrt(square) * 0.25 / square;
        EXPECT_NEAR((double)(covered[(size_t)i].light.y / open[(size_t)i].light.y), 1 - factor + 1 / 150.,
                    2e-3)
            << d;
    }
}
