// Tests the transfer of any model: closed forms (an open plane, a white corner, a furnace), compression,
// gloss and damaged files. (test_radiosity_transfer.py compares rooms with solutions for one light, by exact
// rows and by clusters, and a turned sky with the sky that lies there.)
#include "tests/support/open_room.h"
#include "tests/support/thrown.h"
#include "tools/common/folders.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/rays/light_grid.h"
#include "tools/radiosity/solution/arrays.h"
#include "tools/radiosity/transfer/environment.h"

using namespace odraz;
using namespace odraz::radiosity;

// On an open plane, a function Y of band l gives A(l) Y / pi, where A is pi, 2 pi / 3, pi / 4, 0, -pi / 24, 0
// (Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps", 2001).
TEST(Transfer, OfAnOpenPlaneIsTheCosineLobe) {
    const double lobe[kMostBands] = {M_PI, 2 * M_PI / 3, M_PI / 4, 0, -M_PI / 24, 0};
    for (Vec3d normal : {Vec3d{0, 1, 0}, Vec3d{1, 2, -2}, Vec3d{-3, -1, 0.5}}) {
        Vec3d n = normalize(normal), u = normalize(cross(n, Vec3d{0.3, 0.2, 0.9})), v = cross(n, u);
        Mesh mesh = meshOf({{{1, 2, 3}, u, v, 0}}, {{"grey", {0.5f, 0.5f, 0.5f}, {}}});
        TransferRoom room = transferOf(mesh, settingsOf(kMostBands, 4096, 0.25));
        Float8 y[kMostSh];
        evaluateBands(broadcast(toFloat(n)), kMostBands, y);
        double worst = 0;
        for (int k = 0; k < kMostSh; ++k)
            for (size_t t = 0; t < room.texels(); ++t)
                worst = std::max(
                    worst, std::fabs((double)room.plane(k, 1)[t] - lobe[bandOf(k)] / M_PI * (double)y[k][0]));
        EXPECT_LT(worst, 1.5e-3);
    }
}

// Under an even sky, surfaces that reflect all light have the sky's radiance.
TEST(Transfer, OfAWhiteCornerIsWhite) {
    Mesh mesh = meshOf({{{0, 0, 0}, {0, 0, 2}, {2, 0, 0}, 0},
                        {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, 0},
                        {{0, 0, 0}, {0, 2, 0}, {0, 0, 2}, 0}},
                       {{"white", {1, 1, 1}, {}}});
    TransferRoom room = transferOf(mesh, settingsOf(2, 256, 0.04));
    for (const Rgb &light : lightOf(room, project(Rgb{3, 2, 1}).light)) {
        EXPECT_NEAR(light.x, 3, 2e-4);
        EXPECT_NEAR(light.z, 1, 1e-4);
    }
}

// If all surfaces of a closed room emit E and reflect rho, E / (1 - rho) arrives everywhere.
TEST(Transfer, OfAFurnaceIsItsClosedForm) {
    std::vector<Quad> sides = {{{0, 0, 2}, {2, 0, 0}, {0, 0, -2}, 0}, {{0, 2, 0}, {2, 0, 0}, {0, 0, 2}, 0},
                               {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, 0},  {{2, 0, 2}, {-2, 0, 0}, {0, 2, 0}, 0},
                               {{0, 0, 2}, {0, 0, -2}, {0, 2, 0}, 0}, {{2, 0, 0}, {0, 0, 2}, {0, 2, 0}, 0}};
    TransferRoom room =
        transferOf(meshOf(sides, {{"glow", {0.5f, 0.8f, 0.9f}, {1, 2, 3}}}), settingsOf(1, 64, 0.1));
    ASSERT_EQ(room.lamps, std::vector<std::string>{"glow"});
    for (const Rgb &light : lightOf(room, {}, 1)) {
        EXPECT_NEAR(light.x, 1 / 0.5, 2e-4);
        EXPECT_NEAR(light.y, 2 / 0.2, 2e-3);
        EXPECT_NEAR(light.z, 3 / 0.1, 1e-2);
    }
}

// All axes together reproduce the rows, and each axis reduces the error.
TEST(Clusters, HoldTheRows) {
    TransferSettings settings = settingsOf(3, 64, 0.03);
    settings.clusters = 16, settings.rank = 28;
    TransferRoom room = transferOf(openRoom(), settings);
    std::vector<float> rows = room.rows(), scale = columnScale(room, rows);
    const Clusters &many = room.clusters;
    EXPECT_LT(compressionError(many, rows, scale, 28), 2e-3); // 28 lights, most of them grey
    double last = 1;
    for (int rank = 0; rank <= many.rank; ++rank) {
        double loss = compressionError(many, rows, scale, rank);
        EXPECT_LE(loss, last * 1.0001) << rank;
        last = loss;
    }
    // A cluster's axes are in descending order of the variance that they explain
    for (int c = 0; c < many.count; ++c) {
        std::vector<double> squares((size_t)many.rank);
        for (size_t t = 0; t < many.of.size(); ++t)
            for (size_t d = 0; many.of[t] == c && d < squares.size(); ++d)
                squares[d] += std::pow((double)many.weights[t * squares.size() + d], 2);
        for (size_t d = 1; d < squares.size(); ++d) EXPECT_LE(squares[d], squares[d - 1] * 1.0001 + 1e-20);
    }
}

// Relighting by exact rows equals a sum in double precision.
TEST(Relighting, IsASumOfRows) {
    TransferRoom room = transferOf(openRoom(), settingsOf(4, 32, 0.1));
    Dice dice(7);
    BandLight sky = randomLight(4, dice);
    std::vector<Rgb> light = lightOf(room, sky, 0.5f);
    for (size_t t = 0; t < room.texels(); ++t) {
        double sum = 0, all = 0;
        for (int k = 0; k < room.bases(); ++k) {
            double term = (double)room.plane(k, 1)[t] * (k < 16 ? (double)sky[(size_t)k].y : 0.5);
            sum += term, all += std::fabs(term);
        }
        EXPECT_NEAR(light[t].y, sum, 1e-6 * all);
    }
}

// Gloss is a mirror image blurred by a lobe. It is compared with dense rays over the upper half-space, on a
// floor without walls, which sees only sky, and in the open room, where rays bring the solution for this
// light.
TEST(Gloss, IsTheLobeOfWhatArrives) {
    auto shown = [&](const Mesh &mesh, const Vec3 &eye, bool lamps, const char *what, double limit) {
        TransferSettings settings = settingsOf(kBands, 256, 0.15);
        settings.glossy = "grey", settings.polish = 0.3f, settings.exponent = 20, settings.glossRays = 512;
        TransferRoom room = transferOf(mesh, settings);
        ASSERT_FALSE(room.gloss.empty());
        BandLight sky = bandLimitedSkies(kBands, false)[2].light;
        Lighting lighting = {
            .sky = sky, .lamps = std::vector<float>(room.lamps.size(), lamps), .bands = kBands, .rank = -1};
        Solution lit = litModel(room, lighting, &eye);
        RayTree tree(cornersOf(mesh));
        Regions regions = joinRegions(mesh, std::sqrt(0.15));
        const Chart &floor = lit.charts[0];
        const int step = 6;
        double error = 0, all = 0;
        for (int j = 3; j < floor.down; j += step)
            for (int i = 3; i < floor.across; i += step) {
                Vec3 p = floor.at((float)i / (float)floor.across * floor.width,
                                  (float)j / (float)floor.down * floor.height);
                Vec3 from = p + floor.n * 1e-3f, d = normalize(p - eye),
                     mirror = d - floor.n * (2 * dot(d, floor.n));
                double sum = 0;
                const int around = 128, count = 64 * around;
                for (int k = 0; k < count; ++k) {
                    // Take directions on rings about the normal, at equal intervals of height
                    float high = ((float)(k / around) + 0.5f) / (count / around),
                          wide = std::sqrt(1 - high * high);
                    float angle =
                        ((float)(k % around) + 0.25f * (float)(k / around % 4)) * (float)(2 * M_PI / around);
                    Vec3 direction = floor.u * (wide * std::cos(angle)) + floor.v * (wide * std::sin(angle)) +
                                     floor.n * high;
                    RayHit hit = tree.nearest(from, direction);
                    Rgb light = {};
                    if (hit.triangle < 0)
                        light = radiance(sky, kBands, direction);
                    else if (!hit.back) {
                        auto chart = (size_t)regions.chartOf[(size_t)hit.triangle];
                        light = lit.lightAt((int)chart, from + direction * hit.t) * lit.reflects[chart] +
                                lit.emits[chart];
                    }
                    sum += (double)light.y * lobeAt((double)dot(direction, mirror), 20) * 2 * M_PI / count;
                }
                double grazing = 1 - (double)-dot(d, floor.n), schlick = 0.3 + 0.7 * std::pow(grazing, 5),
                       exact = std::fmax(sum, 0) * schlick,
                       got = (double)lit.gloss[(size_t)floor.texel(i, j)].y;
                error += (got - exact) * (got - exact), all += exact * exact;
            }
        EXPECT_LT(std::sqrt(error / all), limit) << what;
    };
    Mesh plate = meshOf({{{-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 0}}, {{"grey", {0.5f, 0.5f, 0.5f}, {}}});
    shown(plate, {1, 1.5f, 3}, false, "an open floor", 0.02);
    shown(openRoom(), {0.5f, 1.6f, 5}, true, "an open room", 0.03);
}

// Whether a file is accepted; an accepted one must be safe to use.
static bool accepted(const std::string &file) {
    common::TemporaryFolder folder;
    common::writeWhole(folder / "room.prt", file);
    std::string wrong = thrown([&] {
        TransferRoom room = TransferRoom::read(folder / "room.prt");
        Vec3 eye = {1, 2, 3};
        for (int rank : {-1, room.clusters.rank})
            litModel(room, {.sky = {}, .lamps = {}, .bands = room.bands, .rank = rank}, &eye);
    });
    EXPECT_TRUE(wrong.empty() || wrong.find(folder / "room.prt") == 0) << wrong;
    EXPECT_EQ(wrong.find('\n'), std::string::npos);
    return wrong.empty();
}

// The checksum detects damage. A file with a forged checksum is refused or safe to use. (The fuzzer tries
// many more files.)
TEST(File, SurvivesDamage) {
    TransferSettings settings = settingsOf(1, 8, 4);
    settings.glossy = "grey", settings.glossRays = 64, settings.rank = 1, settings.clusters = 2;
    common::TemporaryFolder folder;
    transferOf(openRoom(), settings).save(folder / "room.prt");
    std::string file = common::readWhole(folder / "room.prt"), body = file.substr(file.find('\n') + 1 + 8);
    ASSERT_TRUE(accepted(file));
    EXPECT_FALSE(accepted(file + "x"));
    EXPECT_FALSE(accepted(withChecksum(kTransferMagic, body + "x")));
    for (size_t end = 0; end < body.size(); end += body.size() / 40) {
        EXPECT_FALSE(accepted(file.substr(0, end))) << end;
        EXPECT_FALSE(accepted(withChecksum(kTransferMagic, body.substr(0, end)))) << end;
        std::string flipped = file;
        flipped[file.size() - body.size() + end] ^= 4;
        EXPECT_FALSE(accepted(flipped)) << end;
    }
}
