// Tests that adaptive pictures have no visible faults: flicker, squares, dashes, stairs, blinking points.
#include "tests/support/figure.h"
#include "tests/support/sanitized.h"
#include "tests/support/traced_picture.h"

using namespace odraz;

// Flicker is an error that changes: if a camera moves by a quarter of a pixel per picture, the error changes
// by less than a level of 255, the least step of a screen, and less than one pixel per picture jumps.
FIGURES_TEST(AdaptiveFaults, DoesNotFlicker) {
    constexpr int kWidth = 320, kHeight = 180, kPictures = 8;
    auto scene = posed(kTable, 70);
    std::vector<std::vector<int>> errors;
    for (int i = 0; i < kPictures; ++i) {
        CameraKey camera = kTableView;
        camera.eye.x += (float)i * 0.0025f;
        TracedPicture play = traced(*scene, camera, named(QualityName::Play), kWidth, kHeight),
                      truth = traced(*scene, camera, named(QualityName::Reference), kWidth, kHeight);
        std::vector<int> &error = errors.emplace_back();
        for (int k = 0; k < kWidth * kHeight * 3; ++k)
            error.push_back(play.at(k / 3, k % 3) - truth.at(k / 3, k % 3));
    }
    double squares = 0;
    int jumps = 0, count = 0;
    for (int i = 1; i < kPictures; ++i)
        for (size_t k = 0; k < errors[0].size(); ++k) {
            int change = errors[(size_t)i][k] - errors[(size_t)i - 1][k];
            squares += change * change;
            jumps += std::abs(change) > 48;
            ++count;
        }
    expectAtMost("change of the error, levels of 255: rms", std::sqrt(squares / count), 1);
    EXPECT_LT(jumps, 3 * (kPictures - 1));
}

// Where squares meet, the picture must be as smooth as inside them. A viewer does not notice the grid if
// second differences there are less than a quarter larger than inside.
FIGURES_TEST(AdaptiveFaults, ShowsNoSquares) {
    TracedPicture p = traced(kTable, 100, kTableView, named(QualityName::Play), 640, 360),
                  truth = traced(kTable, 100, kTableView, named(QualityName::Reference), 640, 360);
    auto bends = [](const TracedPicture &q, int phase) {
        double sum = 0;
        int count = 0;
        for (int y = 0; y < 360; ++y)
            for (int x = 8 + phase; x < 632; x += 8) {
                // Use only smooth parts, because the second differences at edges would hide all others
                int left = q.at(x - 2, y, 1), a = q.at(x - 1, y, 1), b = q.at(x, y, 1),
                    right = q.at(x + 1, y, 1);
                int bend = std::abs(right - b - (a - left));
                if (bend > 12) continue;
                sum += bend;
                ++count;
            }
        return sum / count;
    };
    double inside = 0, insideTruth = 0;
    for (int phase = 2; phase < 7; ++phase)
        inside += bends(p, phase) / 5, insideTruth += bends(truth, phase) / 5;
    double excess = bends(p, 0) / inside, usual = bends(truth, 0) / insideTruth;
    EXPECT_LT(excess, usual * 1.25);
}

// A bright face seen edge-on is thinner than the distance between samples. If only a few samples hit it, it
// would look like dashes.
TEST(AdaptiveFaults, ShowsNoDashesOfFacesSeenFromTheSide) {
    auto face = [](float side, const Quality &quality) {
        auto s = shining({5, 5, 5}, rect({side, 0, -10}, {0, 0, -1}, {0, -1, 0}, 0.25f, 3));
        TracedPicture p = traced(*s, {0, {0, 0, 0}, {0.3f, 0, -10}, 5, 36}, quality, 320, 180);
        int lit = 0; // rows
        for (int y = 0; y < 180; ++y) {
            int most = 0;
            for (int x = 0; x < 320; ++x) most = std::max(most, (int)p.at(x, y, 1));
            lit += most > 8;
        }
        return lit;
    };
    for (QualityName name : {QualityName::Draft, QualityName::Play}) {
        EXPECT_EQ(face(0.11f, named(name)), 0); // 0.15 pixels
        EXPECT_GT(face(1.5f, named(name)), 150);
    }
    EXPECT_GT(face(0.11f, named(QualityName::Reference)), 100);
    // From a few pixels to a tenth of one: the whole face is seen, or nothing
    for (float side = 3; side > 0.1f; side *= 0.9f) {
        int lit = face(side, named(QualityName::Play));
        EXPECT_TRUE(lit > 150 || !lit) << side << ": " << lit << " of 165 rows";
    }
}

// A pixel on an edge shows the share that the edge covers, at every slope, even near the axes, where stairs
// would be long. `bright` is the radiance on one side; the other side is black.
static void smoothsEdges(float bright, QualityName name, double mostOff) {
    auto s = shining(Rgb{1, 1, 1} * bright, rect({0, -100, -10}, {1, 0, 0}, {0, 1, 0}, 200, 100));
    for (float degrees : {0.7f, 3.f, 10.f, 22.f, 41.f, 87.f}) {
        CameraKey camera = {0, {0, 0, 0}, {0, 0, -10}, degrees, 36};
        TracedPicture truth = traced(*s, camera, named(QualityName::Reference), 320, 180);
        TracedPicture p = traced(*s, camera, named(name), 320, 180);
        double squares = 0;
        int edges = 0;
        for (int i = 0; i < p.frame.stride * 180; ++i) {
            float v = truth.frame.plane[0][i] / bright;
            if (v <= 0 || v >= 1) continue;
            squares += std::pow(p.frame.plane[0][i] / bright - v, 2);
            ++edges;
        }
        EXPECT_LT(std::sqrt(squares / edges), mostOff) << named(name).name << " " << degrees;
    }
}
FIGURES_TEST(AdaptiveFaults, SmoothsEdgesOfEverySlope) {
    smoothsEdges(1, QualityName::Film, 0.05);
    // An intensity of 0.05 is 15 of 255 in the picture: stairs of whole pixels would be seen
    const float dim = 0.7f * 0.05f * 0.05f / (1 - 0.05f * 0.05f);
    for (float bright : {1.f, dim})
        for (QualityName name : {QualityName::Draft, QualityName::Play})
            smoothsEdges(bright, name, 0.1); // 3 x 3 samples would give up to 0.15
}

// Returns a wall in the shadow of a box behind the viewer.
static std::unique_ptr<Scene> shadowOf(const Shape &box) {
    auto s = emptyScene();
    s->add(matte({1, 1, 1}));
    s->add(rect({0, 0, -10}, {1, 0, 0}, {0, 1, 0}, 100, 100));
    s->add(box);
    s->add(Light{{0, 0, 50}, {3600, 3600, 3600}});
    s->finish();
    return s;
}

// Steep edges of shadows on one surface have no stairs, not even in `draft`.
TEST(AdaptiveFaults, EdgesOfShadowsHaveNoStairs) {
    auto s = shadowOf(box({-20, 0, 20}, {20, 40, 1}, 0));
    auto look = [&](QualityName name) {
        return traced(*s, {0, {0, 0, 0}, {0, 0, -10}, 4, 36}, named(name), 160, 90);
    };
    TracedPicture truth = look(QualityName::Reference), p = look(QualityName::Draft);
    for (int i = 0; i < 160 * 90; ++i) EXPECT_NEAR(p.frame.plane[0][i], truth.frame.plane[0][i], 0.3) << i;
}

// A strip of shadow on one surface is seen whole, though most of the largest squares have no corner in it:
// where one square finds it, its neighbours follow it along their sides.
TEST(AdaptiveFaults, StripsOfShadowAreNotDashed) {
    auto rows = [](float pixels, float roll, QualityName name) {
        auto s = shadowOf(box({0.7f, 0, 20}, {0.0089f * pixels, 50, 0.01f}, 0));
        TracedPicture p = traced(*s, {0, {0, 0, 0}, {0, 0, -10}, roll, 36}, named(name), 320, 180);
        int found = 0;
        for (int y = 0; y < 180; ++y) {
            float least = 9;
            for (int x = 0; x < 320; ++x) least = std::min(least, p.frame.plane[0][y * p.frame.stride + x]);
            found += least < 0.8f * p.frame.plane[0][y * p.frame.stride];
        }
        return found;
    };
    for (float pixels = 2.3f; pixels < 8; pixels *= 1.3f)
        for (float roll : {2.f, 7.f, 19.f, 31.f}) {
            EXPECT_EQ(rows(pixels, roll, QualityName::Play), 180) << pixels << ' ' << roll;
            EXPECT_GE(rows(pixels, roll, QualityName::Draft), roll > 5 ? 175 : 0) << pixels << ' ' << roll;
        }
}

// A camera moves by fractions of a pixel through 64 positions. A bright point blinks in a position if its
// brightest pixel is below half of its maximum. If it blinks in one of sixteen, a viewer sees it sparkle.
constexpr int kSparkles = 64 / 16;
static int blinks(QualityName quality, void (*pose)(Scene &)) {
    auto s = emptyScene();
    pose(*s);
    s->finish();
    std::vector<int> bright;
    for (int i = 0; i < 64; ++i) {
        float x = (float)(i % 8) * 0.021f, y = (float)(i / 8) * 0.021f;
        TracedPicture p = traced(*s, {0, {x, y, 10}, {x, y, 0}, 0, 36}, named(quality), 320, 180);
        int most = 0;
        for (int k = 0; k < 320 * 180; ++k) most = std::max<int>(most, p.at(k, 1));
        bright.push_back(most);
    }
    int most = *std::max_element(bright.begin(), bright.end());
    EXPECT_GT(most, 60);
    return (int)std::count_if(bright.begin(), bright.end(), [&](int b) { return 2 * b < most; });
}

// Small bright things are found wherever they lie between the corners of squares. (If they light only one
// pixel, this pixel is dimmed as a spark. The dim highlight blinks in 15 positions in draft, so it sparkles,
// which is a fault.)
FIGURES_TEST(AdaptiveFaults, SmallThingsDoNotBlink) {
    const struct {
        const char *what;
        void (*pose)(Scene &s);
        int mostInDraft;
    } kCases[] = {{"the dim highlight of a ball of six pixels",
                   [](Scene &s) {
                       s.add(sphere({0, 0, 0}, 0.22f, s.add(Material{.specular = 0.8f, .exponent = 90})));
                       s.add(Light{{60, 50, 100}, {4e4f, 4e4f, 4e4f}});
                   },
                   4 * kSparkles},
                  {"the image of a lamp in a ball, less than a pixel wide",
                   [](Scene &s) {
                       s.add(sphere({0, 0, 0}, 0.5f, s.add(Material{.reflect = 0.8f})));
                       s.add(sphere({3, 2, 5}, 0.35f, s.add(Material{.emit = {60, 60, 60}})));
                   },
                   kSparkles},
                  {"a ball of two pixels next to an edge, which alone splits the squares there",
                   [](Scene &s) {
                       s.add(box({-2, 0, -1}, {2, 4, 0.5f}, s.add(Material{.emit = {0.05f, 0.05f, 0.05f}})));
                       s.add(sphere({0.05f, 0, 0}, 0.025f, s.add(Material{.emit = {0.6f, 0.6f, 0.6f}})));
                   },
                   kSparkles}};
    for (auto &[what, pose, mostInDraft] : kCases) {
        EXPECT_LE(blinks(QualityName::Draft, pose), mostInDraft) << what;
        EXPECT_LE(blinks(QualityName::Play, pose), kSparkles) << what;
    }
}

// A pixel on the edge of a lamp shows the share that the lamp covers, as if the lamp were just white, however
// bright it is. The edge is steep, so that stairs would be long.
TEST(AdaptiveFaults, EdgesOfLampsHaveNoStairs) {
    auto edge = [](float radiance, const Quality &quality) {
        auto s = shining(Rgb{1, 1, 1} * radiance, rect({-100, 0, -10}, {1, 0, 0}, {0, 1, 0}, 100, 100));
        return traced(*s, {0, {0, 0, 0}, {0, 0, -10}, 4, 36}, quality, 160, 90);
    };
    for (const Quality &quality : kQualities) {
        TracedPicture white = edge(1, quality), bright = edge(50, quality);
        int partly = 0;
        for (int i = 0; i < 160 * 90; ++i) {
            int v = white.at(i, 0);
            if (v <= 20 || v >= 220) continue; // white is shown as 231
            ++partly;
            EXPECT_NEAR(v, bright.at(i, 0), 8) << quality.name;
        }
        EXPECT_GT(partly, 50) << quality.name; // one pixel in each row
    }
}

// Lines between patches are narrower than a pixel. They also run along edges of surfaces that look almost
// alike: there the line must be even, not dashed.
TEST(AdaptiveFaults, LinesBetweenPatchesAreNotDashed) {
    Chart charts[2] = {};
    charts[0].v = {0, -1, 0}, charts[0].n = {0, 0, 1};
    charts[1].v = {0, 0, -1}, charts[1].n = {0, 1, 0};
    for (Chart &c : charts) {
        c.corner = {-8, 0, 0}, c.u = {1, 0, 0};
        c.width = c.height = 16;
        c.across = c.down = 1;
        c.patchesAcross = c.patchesDown = 1;
    }
    const float light[4] = {1, 1, 1, 1};
    Lightmap map = {};
    map.charts = charts;
    for (auto &plane : map.plane) plane = light;

    auto s = emptyScene();
    for (float grey : {0.008f, 0.009f}) s->add(matte({grey, grey, grey}));
    s->add(rect({0, -8, 0}, {1, 0, 0}, {0, 1, 0}, 8, 8))->chart = 0;
    s->add(rect({0, 0, -8}, {0, 0, 1}, {1, 0, 0}, 8, 8, 1))->chart = 1;
    s->lightmap = &map;
    s->lines = -16;
    s->finish();
    for (QualityName quality : {QualityName::Draft, QualityName::Play, QualityName::Film}) {
        // Look from the side, so that the edge climbs by a pixel in three to five
        TracedPicture p = traced(*s, {0, {-5, 2, 6}, {0, 0, 0}, 0, 50}, named(quality), 320, 180);
        double least = 1e9, most = 0;
        for (int x = 80; x < 240; ++x) {
            double sum = 0;
            for (int y = 0; y < 180; ++y) sum += std::pow(p.at(x, y, 1) / 255., 2.2);
            least = std::min(least, sum), most = std::max(most, sum);
        }
        EXPECT_LT(most, 2 * least) << named(quality).name;
    }
}

// Two surfaces that differ only in their textures meet in a line without steps. A viewer does not notice a
// step of a quarter of a pixel, a quarter of the way from black to white.
TEST(AdaptiveFaults, SeamsOfTexturesHaveNoStairs) {
    auto s = emptyScene();
    Material tiles = matte({0.2f, 0.2f, 0.2f});
    tiles.other.palette[0] = {0.8f, 0.8f, 0.8f};
    tiles.cell = 20;
    s->add(matte({0.5f, 0.5f, 0.5f}));
    s->add(tiles);
    s->add(rect({10, 0, 10}, {0, 0, 1}, {1, 0, 0}, 10, 10, 1));
    s->add(rect({10, 10, 0}, {1, 0, 0}, {0, 1, 0}, 10, 10));
    s->ambientLow = s->ambientHigh = {0.5f, 0.5f, 0.5f};
    s->finish();
    const CameraKey camera = {0, {6, 3, 9}, {10, 0, 0}, 4, 50};
    TracedPicture truth = traced(*s, camera, named(QualityName::Reference), 320, 180);
    for (QualityName quality : {QualityName::Draft, QualityName::Play, QualityName::Film}) {
        TracedPicture p = traced(*s, camera, named(quality), 320, 180);
        int worst = 0;
        for (int x = 80; x < 240; ++x) {
            int off = 0;
            for (int y = 0; y < 180; ++y) off += p.at(x, y, 1) - truth.at(x, y, 1);
            worst = std::max(worst, std::abs(off));
        }
        EXPECT_LT(worst, 64) << named(quality).name;
    }
}

// Compares the light of a whole picture with the light of a picture traced in full, for cameras that turn by
// a seventh of a pixel each: the means differ by at most `off`, and single pictures by `mostOff`. A fifth is
// 1 dB, about the least change that is seen in a moving point of light.
static void expectLightKept(Scene &scene, const CameraKey &camera, QualityName name, double off,
                            double mostOff = 0.2) {
    constexpr int kCameras = 15;
    double mean = 0;
    for (int i = 0; i < kCameras; ++i) {
        auto light = [&](QualityName n) {
            CameraKey turned = camera;
            turned.target.x += (float)i * 0.0023f, turned.target.y += (float)i * 0.0011f;
            TracedPicture p = traced(scene, turned, named(n), 160, 90);
            double sum = 0;
            for (int y = 0; y < 90; ++y)
                for (int x = 0; x < 160; ++x) sum += p.frame.plane[1][y * p.frame.stride + x];
            return sum;
        };
        double share = light(name) / light(QualityName::Reference);
        EXPECT_NEAR(share, 1, mostOff) << (int)name << ' ' << i;
        mean += share / kCameras;
    }
    EXPECT_NEAR(mean, 1, off) << (int)name;
}

// The image of a tube in a mirroring ball or wall, a pixel wide or less, has no long gaps. (It has dashes: in
// single pictures it loses up to 45 % of its light in the ball and 32 % in the wall, which is a fault.)
FIGURES_TEST(AdaptiveFaults, KeepsTheLightOfThinTubesInMirrors) {
    for (bool wall : {false, true}) {
        auto s = shining({0.9f, 0.9f, 0.9f}, cylinder({1, 0.5f, 8}, wall ? 0.02f : 0.09f, 0.5f, 0));
        int silver = s->add(Material{.reflect = 1});
        s->add(wall ? rect({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 3, 3, silver) : sphere({0, 0, 0}, 1, silver));
        s->finish();
        for (QualityName name : {QualityName::Draft, QualityName::Play})
            expectLightKept(*s, {0, {0, 0, 6}, {0, 0, 0}, 0, 16}, name, 0.15, wall ? 0.35 : 0.46);
    }
}

// The image of a small lamp behind a ball of glass is never lost between the corners of squares.
FIGURES_TEST(AdaptiveFaults, KeepsTheLightOfLampsInGlass) {
    auto s = shining({0.9f, 0.9f, 0.9f}, sphere({-1.6f, 0.7f, -3}, 0.06f, 0));
    s->add(sphere({0, 0, 0}, 1, s->add(Material{.ior = 1.5f})));
    s->finish();
    expectLightKept(*s, {0, {0, 0, 6}, {0, 0, 0}, 0, 24}, QualityName::Draft, 0.05);
}

// A highlight that is smaller than a square is never lost either.
FIGURES_TEST(AdaptiveFaults, KeepsTheLightOfSmallHighlights) {
    for (float x : {0.f, 0.1f, 0.2f, 0.3f, 0.4f}) {
        auto s = emptyScene();
        s->add(sphere({0, 0, 0}, 1, s->add(Material{.specular = 1, .exponent = 2500})));
        s->add(Light{{3 + x, 2, 8}, {40, 40, 40}});
        s->finish();
        for (QualityName name : {QualityName::Draft, QualityName::Play, QualityName::Film})
            expectLightKept(*s, {0, {0, 0, 6}, {0, 0, 0}, 0, 16}, name,
                            name == QualityName::Draft ? 0.15 : 0.05);
    }
}
