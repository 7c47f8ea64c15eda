// Tests pictures on materials: means over polygons, and the reflectance of elements.
#include "tests/support/exported.h"
#include "tests/support/headless_gl.h"
#include "tools/common/folders.h"
#include "tools/picture/picture.h"
#include "tools/picture/psnr.h"
#include "tools/radiosity/export/atlas.h"
#include "tools/radiosity/read/reflectance_picture.h"
#include "tools/radiosity/solve/solve.h"
#include "tools/support/machine.h"

using namespace odraz;
using namespace odraz::radiosity;

// White where `white` returns true, black elsewhere.
template <class White> static pictures::Picture pixels(int width, int height, White &&white) {
    pictures::Picture p = {width, height, 1};
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) p.encoded.push_back(white(i, j) ? 65535 : 0);
    return p;
}
static std::vector<TexturePoint> box(double u0, double v0, double u1, double v1) {
    return {{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}};
}

TEST(ReflectancePicture, IsAveragedOverAreas) {
    ReflectancePicture checks(pixels(8, 8, [](int i, int j) { return (i + j) % 2 == 0; }));
    auto mean = [&](const std::vector<TexturePoint> &p, bool clamp = false) {
        return checks.mean(p, clamp).x;
    };
    EXPECT_NEAR(mean(box(0, 0, 1, 1)), 0.5, 1e-4);
    EXPECT_NEAR(mean(box(0, 0.875, 0.125, 1)), 1, 1e-6); // the first pixel, in the upper row
    EXPECT_NEAR(mean(box(0.125, 0.875, 0.25, 1)), 0, 1e-6);
    // A quarter of one pixel and half of the next
    EXPECT_NEAR(mean(box(0.09375, 0.875, 0.1875, 1)), 1 / 3., 1e-6);
    EXPECT_NEAR(mean(box(5, 7.875, 5.125, 8)), 1, 1e-6); // repeated
    EXPECT_NEAR(mean(box(-3, -5.125, -2.875, -5)), 1, 1e-6);
    EXPECT_NEAR(mean(box(-3, 2, -2, 3), true), 1, 1e-6); // the corner pixel
    EXPECT_NEAR(mean(box(-300, -200, 600, 700)), 0.5, 1e-3);
    EXPECT_NEAR(mean({{0, 1}, {0.125, 1}, {0, 0.875}}), 1, 1e-6); // half a pixel
    EXPECT_NEAR(mean({{0, 1}, {0, 0.875}, {0.125, 1}}), 1, 1e-6); // mirrored
    EXPECT_NEAR(mean({{0.05, 0.95}, {0.05, 0.95}, {0.05, 0.95}}), 1, 1e-6);
    for (double odd : {(double)NAN, (double)INFINITY, 1e30, -1e30})
        EXPECT_NEAR(mean({{0, 0}, {odd, 0}, {0, 1}}), 0.5, 1e-4);
    EXPECT_NEAR(ReflectancePicture({1, 1, 3, 8, {188 * 257, 0, 0}, {}}).mean().x, 0.5029, 1e-4); // sRGB
    Rgb linear = ReflectancePicture({1, 1, 3, 32, {}, {0.25f, 2, -1}}).mean();
    EXPECT_NEAR(linear.x, 0.25, 1e-4);
    EXPECT_EQ(linear.y, 1);
    EXPECT_EQ(linear.z, 0);
}

// In sizes that are no powers of two, no texel at the border counts twice.
TEST(ReflectancePicture, HasTheSameMeanInAllItsSizes) {
    for (int width : {1, 3, 100, 129, 255}) {
        ReflectancePicture p(pixels(width, 37, [&](int i, int j) { return 2 * i < width || j == 3; }));
        double wanted = 0;
        for (int i = 0; i < width; ++i) wanted += 2 * i < width ? 1. : 1 / 37.;
        EXPECT_NEAR(p.mean().x, wanted / width, 1e-3) << width;
        EXPECT_NEAR(p.mean(box(0, 0, 1, 1), false).x, wanted / width, 1e-3) << width;
    }
}

// A square of four triangles, tilted in space and rotated on the picture: each element has the mean of its
// part of the picture.
TEST(ElementReflectance, ElementsHaveTheirPartOfThePicture) {
    common::TemporaryFolder folder;
    // Red rises from left to right, in 128 columns
    pictures::Image picture = {128, 4, {}};
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 128; ++i)
            picture.rgb.insert(picture.rgb.end(), {(uint8_t)(2 * i), 0, (uint8_t)(j < 2 ? 255 : 0)});
    pictures::writePng(folder / "fall.png", picture);
    for (int turned = 0; turned < 4; ++turned)
        for (bool patches : {false, true}) {
            Mesh mesh;
            auto &given = mesh.materials.emplace_back(MeshMaterial{"m", {0.5f, 0.5f, 0.5f}, {}, {}}).picture;
            given.path = folder / "fall.png", given.tint = {1, 1, 0.5f};
            // Four triangles around a point away from the middle
            float at[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.3f, 0.6f}};
            for (auto &p : at)
                mesh.points.push_back({(double)p[0] * 2, 1 + (double)p[1] * 0.6, (double)p[1] * -0.8});
            auto turn = [&](const float *p, int axis) {
                float x = p[0] - 0.5f, y = p[1] - 0.5f;
                for (int k = 0; k < turned; ++k) std::tie(x, y) = std::pair{-y, x};
                return (axis ? y : x) + 0.5f;
            };
            for (int k = 0; k < 4; ++k) {
                const int corners[3] = {k, (k + 1) % 4, 4};
                mesh.triangles.push_back({{corners[0], corners[1], corners[2]}, 0});
                std::array<float, 6> &to = mesh.coordinates.emplace_back();
                for (size_t c = 0; c < 6; ++c) to[c] = turn(at[corners[c / 2]], c % 2);
            }
            SolveSettings settings;
            settings.surroundings.sky = evenSky({1, 1, 1});
            settings.element = 0.0005, settings.patch = 0.02;
            settings.method = patches ? SolveMethod::kPatches : SolveMethod::kRays;
            static Workers workers = allProcessors();
            Solved solved = solveModel(mesh, settings, headlessGl(), workers, &kNever, {});
            EXPECT_TRUE(solved.report.notes.empty());
            const Solution &b = solved.solution;
            b.save(folder / "a.rad");
            Solution again(folder / "a.rad");
            std::vector<std::string> notes;
            std::string name = folder / std::to_string(turned * 2 + patches);
            exportAtlas(b, {.radiosity = true}, name, notes);
            Exported out(name, "radiosity");
            out.mustHaveGap(4);
            int elements = 0;
            b.forPieces([&](int, int cell, const std::vector<SolutionPoint> &piece) {
                ++elements;
                Vec3 middle = {};
                float low = 1, high = 0;
                for (const SolutionPoint &p : piece) {
                    middle += p.p * (1 / (float)piece.size());
                    float place[2] = {p.p.x / 2, p.p.z / -0.8f};
                    low = std::min(low, turn(place, 0)), high = std::max(high, turn(place, 0));
                }
                float place[2] = {middle.x / 2, middle.z / -0.8f};
                // The mean of sRGB's curve between two columns
                double wanted = 0;
                for (int k = 0; k < 64; ++k) {
                    double column = ((double)low + (double)(high - low) * (k + 0.5) / 64) * 128;
                    wanted += pictures::linearOfSrgb((uint8_t)(2 * (int)column)) / 64;
                }
                EXPECT_NEAR((double)b.reflectsOf(cell).x, wanted, 0.01);
                const Chart &c = b.charts[0];
                Rgb shown, seen = b.lightIn(cell, dot(middle - c.corner, c.u), dot(middle - c.corner, c.v)) *
                                  b.reflectsOf(cell);
                EXPECT_TRUE(out.radianceAt(0, middle, shown));
                EXPECT_NEAR(shown.x, seen.x, 0.008f * maxComponent(seen)); // a step of the format
                EXPECT_EQ(b.reflectsOf(cell).y, 0);
                double v = (double)turn(place, 1), blue = (double)b.reflectsOf(cell).z;
                EXPECT_TRUE(std::fabs(v - 0.5) < 0.1 || std::fabs(blue - (v > 0.5 ? 0.5 : 0)) < 1e-3);
                EXPECT_EQ(again.reflectsOf(cell).x, b.reflectsOf(cell).x);
            });
            EXPECT_GT(elements, 100);
            // Patches and charts have the means of their elements
            double wanted = 0, reflects = 0, area = 0;
            for (int i = 0; i < 128; ++i) wanted += pictures::linearOfSrgb((uint8_t)(2 * i)) / 128;
            EXPECT_NEAR((double)b.reflects[0].x, wanted, 0.002);
            EXPECT_NEAR(b.reflects[0].z, 0.25f, 0.002f);
            float low = 1, high = 0;
            if (!patches) continue; // solving by rays has no patches
            for (int i = 0; i < solved.patches->model->patchCount; ++i) {
                const Patch &p = solved.patches->model->patches[i];
                reflects += (double)(p.reflects.x * p.area), area += (double)p.area;
                low = std::min(low, p.reflects.x), high = std::max(high, p.reflects.x);
            }
            EXPECT_LT(low, 0.02f);
            EXPECT_GT(high, 0.8f);
            EXPECT_NEAR(reflects / area, wanted, 0.005);
        }
}
