// Transfer of any model: closed forms (an open plane, a white corner, a furnace), solutions made for one
// light, a model that is turned, and what files may hold.
#include "tools/radiosity/rays/light_grid.h"
#include "tools/radiosity/transfer/check.h"

#include "tests/support/random.h"
#include "tests/support/sanitized.h"
#include "tools/common/temporary_folder.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/transfer/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

using namespace odraz;

namespace {

Workers serial = serialWorkers();

struct Quad {
    Vec3d corner, u, v;
    int material;
};

// A model of rectangles, lit on the side of u x v.
Mesh meshOf(const std::vector<Quad> &quads, const std::vector<MeshMaterial> &materials) {
    Mesh mesh;
    mesh.materials = materials;
    auto point = [&](const Vec3d &p) {
        for (size_t i = 0; i < mesh.points.size(); ++i)
            if (length(mesh.points[i] - p) < 1e-9) return (int)i;
        mesh.points.push_back(p);
        return (int)mesh.points.size() - 1;
    };
    for (const Quad &q : quads) {
        int a = point(q.corner), b = point(q.corner + q.u), c = point(q.corner + q.u + q.v),
            d = point(q.corner + q.v);
        mesh.triangles.push_back({{a, b, c}, q.material});
        mesh.triangles.push_back({{a, c, d}, q.material});
    }
    return mesh;
}

// A room of 4 x 3 x 4 without its wall at +z: floor, ceiling, back, left and right, and a lamp below the
// ceiling.
Mesh openRoom() {
    std::vector<MeshMaterial> materials = {{"grey", {0.7f, 0.7f, 0.7f}, {}},
                                           {"red", {0.8f, 0.2f, 0.1f}, {}},
                                           {"blue", {0.1f, 0.3f, 0.8f}, {}},
                                           {"lamp", {}, {9, 8, 6}}};
    return meshOf({{{-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 0},
                   {{-2, 3, -2}, {4, 0, 0}, {0, 0, 4}, 0},
                   {{-2, 0, -2}, {4, 0, 0}, {0, 3, 0}, 0},
                   {{-2, 0, 2}, {0, 0, -4}, {0, 3, 0}, 1},
                   {{2, 0, -2}, {0, 0, 4}, {0, 3, 0}, 2},
                   {{-0.5, 2.9, -0.5}, {1, 0, 0}, {0, 0, 1}, 3}},
                  materials);
}

TransferSettings settingsOf(int bands, int rays, double element) {
    TransferSettings s;
    s.bands = bands;
    s.solve.rays = rays;
    s.solve.element = element;
    s.solve.residual = 1e-6f;
    return s;
}

TransferRoom transferOf(const Mesh &mesh, const TransferSettings &settings) {
    TransferReport report;
    return findTransfer(mesh, settings, serial, nullptr, report);
}

std::vector<Rgb> lightOf(const TransferRoom &room, const BandLight &sky, float lamps = 0, int rank = -1) {
    std::vector<Rgb> light;
    Relighter(room).relight({.sky = sky,
                             .lamps = std::vector<float>(room.lamps.size(), lamps),
                             .bands = kMostBands,
                             .rank = rank},
                            light);
    return light;
}

float between(Random &random, float least, float most) { return least + (most - least) * random.next(); }

Vec3 randomDirection(Random &random) {
    for (;;) {
        Vec3 d = {between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
        if (float l = length(d); l > 0.1f && l < 1) return d * (1 / l);
    }
}

BandLight randomLight(int bands, Random &random) {
    BandLight light = {};
    for (int k = 0; k < bands * bands; ++k)
        light[(size_t)k] = {between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
    return light;
}

double legendre(int l, double x) {
    double a = 1, b = x;
    if (l == 0) return a;
    for (int k = 2; k <= l; ++k) {
        double c = ((2 * k - 1) * x * b - (k - 1) * a) / k;
        a = b, b = c;
    }
    return b;
}

} // namespace

// The sum over a band's orders is (2 l + 1) / 4 pi times Legendre's polynomial of the angle.
TEST(Bands, ObeyTheAdditionTheorem) {
    Random random = {1};
    double worst = 0;
    for (int i = 0; i < 1000; ++i) {
        Vec3 a = randomDirection(random), b = randomDirection(random);
        Float8 ya[kMostSh], yb[kMostSh];
        evaluateBands(broadcast(a), kMostBands, ya);
        evaluateBands(broadcast(b), kMostBands, yb);
        for (int l = 0; l < kMostBands; ++l) {
            double sum = 0;
            for (int k = l * l; k < (l + 1) * (l + 1); ++k) sum += (double)ya[k][0] * (double)yb[k][0];
            worst =
                std::max(worst, std::fabs(sum - (2 * l + 1) / (4 * M_PI) * legendre(l, (double)dot(a, b))));
        }
    }
    EXPECT_LT(worst, 2e-6);
}

TEST(Bands, AreOrthonormal) {
    double products[kMostSh][kMostSh] = {};
    for (int i = 0; i < kDirections; i += 8) {
        float solidAngle;
        Vec3x8 d = direction(i, solidAngle);
        Float8 y[kMostSh];
        evaluateBands(d, kMostBands, y);
        for (int a = 0; a < kMostSh; ++a)
            for (int b = 0; b < kMostSh; ++b) products[a][b] += (double)(total(y[a] * y[b]) * solidAngle);
    }
    for (int a = 0; a < kMostSh; ++a)
        for (int b = 0; b < kMostSh; ++b) EXPECT_NEAR(products[a][b], a == b, 5e-6) << a << " " << b;
}

TEST(Bands, TurnWithTheirLight) {
    Random random = {2};
    for (int bands = 1; bands <= kMostBands; ++bands) {
        BandLight light = randomLight(bands, random);
        Turn turn = turnAbout(randomDirection(random), (double)between(random, -180, 180)) *
                    turnAbout(randomDirection(random), (double)between(random, -180, 180));
        BandLight after = turned(light, bands, turn);
        for (int i = 0; i < 50; ++i) {
            Vec3 d = randomDirection(random);
            Rgb was = radiance(light, bands, d), is = radiance(after, bands, turn.of(d));
            EXPECT_LT(length(was - is), 3e-5f) << bands;
        }
        BandLight back = turned(after, bands, turn.inverse());
        for (int k = 0; k < bands * bands; ++k) EXPECT_LT(length(back[(size_t)k] - light[(size_t)k]), 2e-5f);
    }
}

// A picture of a band-limited light gives its coefficients back, and all of its energy; a small bright spot
// leaves little in the bands, by Parseval.
TEST(Environment, IsProjected) {
    for (bool upIsZ : {false, true}) {
        Random random = {3};
        BandLight light = randomLight(kMostBands, random);
        SkyPicture sky = pictureOf(light, kMostBands, upIsZ);
        HdrPicture picture = {sky.width, sky.height, {}};
        for (const Rgb &c : sky.pixels) picture.pixels.insert(picture.pixels.end(), {c.x, c.y, c.z});
        Projected p = project(picture, upIsZ);
        for (int k = 0; k < kMostSh; ++k)
            EXPECT_LT(length(p.light[(size_t)k] - light[(size_t)k]), 2e-4f) << k;
        EXPECT_NEAR(p.held[kMostBands - 1], 1, 1e-4);
        for (int l = 1; l < kMostBands; ++l) EXPECT_GT(p.held[l], p.held[l - 1]);
        double energy = 0, first = 0;
        for (int k = 0; k < kMostSh; ++k) {
            energy += (double)dot(light[(size_t)k], light[(size_t)k]);
            if (k < 4) first += (double)dot(light[(size_t)k], light[(size_t)k]);
        }
        EXPECT_NEAR(p.held[1], first / energy, 1e-4);
    }
    // A row of pixels around the zenith is a disc, of which a band holds an integral of Legendre's polynomial
    HdrPicture disc = {64, 32, std::vector<float>((size_t)64 * 32 * 3)};
    std::fill(disc.pixels.begin(), disc.pixels.begin() + (ptrdiff_t)64 * 3, 100.f);
    Projected p = project(disc, false);
    double rim = std::cos(M_PI / 32), held = 0;
    for (int l = 0; l < kMostBands; ++l) {
        double integral = l ? (legendre(l - 1, rim) - legendre(l + 1, rim)) / (2 * l + 1) : 1 - rim;
        held += (2 * l + 1) / (4 * M_PI) * std::pow(2 * M_PI * integral, 2) / (2 * M_PI * (1 - rim));
        EXPECT_NEAR(p.held[l], held, 2e-5) << l;
    }
}

// An open plane gets A(l) Y / pi of every function, where A is pi, 2 pi / 3, pi / 4, 0, -pi / 24, 0
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
        std::printf("open plane, largest difference %.1e\n", worst);
        EXPECT_LT(worst, 1.5e-3);
    }
}

// Under an even sky everything that reflects all light has the sky's radiance.
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
    Mesh mesh;
    std::vector<Quad> sides = {{{0, 0, 2}, {2, 0, 0}, {0, 0, -2}, 0}, {{0, 2, 0}, {2, 0, 0}, {0, 0, 2}, 0},
                               {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, 0},  {{2, 0, 2}, {-2, 0, 0}, {0, 2, 0}, 0},
                               {{0, 0, 2}, {0, 0, -2}, {0, 2, 0}, 0}, {{2, 0, 0}, {0, 0, 2}, {0, 2, 0}, 0}};
    mesh = meshOf(sides, {{"glow", {0.5f, 0.8f, 0.9f}, {1, 2, 3}}});
    TransferSettings settings = settingsOf(1, 64, 0.1);
    TransferRoom room = transferOf(mesh, settings);
    ASSERT_EQ(room.lamps, std::vector<std::string>{"glow"});
    for (const Rgb &light : lightOf(room, {}, 1)) {
        EXPECT_NEAR(light.x, 1 / 0.5, 2e-4);
        EXPECT_NEAR(light.y, 2 / 0.2, 2e-3);
        EXPECT_NEAR(light.z, 3 / 0.1, 1e-2);
    }
}

// Against solutions by the tool's other solver from the same rays, of every environment and the lamps.
TEST(Transfer, IsWithinATenThousandthOfFreshSolutions) {
    Mesh mesh = openRoom();
    for (int bands = 1; bands <= kMostBands; bands += kSanitized ? 5 : 1) {
        TransferSettings settings = settingsOf(bands, 64, 0.03);
        TransferRoom room = transferOf(mesh, settings);
        double rows = 0, clusters = 0;
        for (const TriedSky &sky : bandLimitedSkies(bands, false)) {
            std::vector<Rgb> exact = freshLight(mesh, settings, 64, sky, serial);
            rows = std::max(rows, difference(lightOf(room, sky.light), exact));
            clusters = std::max(clusters, difference(lightOf(room, sky.light, 0, room.clusters.rank), exact));
        }
        double lamps = difference(lightOf(room, {}, 1), freshLamps(mesh, settings, 64, serial));
        std::printf("%d bands: %.4f %% by rows, %.2f %% by clusters; lamps %.4f %%\n", bands, 100 * rows,
                    100 * clusters, 100 * lamps);
        EXPECT_LT(rows, 1e-4);
        EXPECT_LT(clusters, 1e-2);
        EXPECT_LT(lamps, 1e-4);
    }
}

// Turning the environment is turning the model the other way.
TEST(Transfer, TurnsWithTheModel) {
    Mesh mesh = openRoom(), other = mesh;
    const double angle = 30;
    Turn turn = turnAbout({0, 1, 0}, angle);
    double c = std::cos(angle * M_PI / 180), s = std::sin(angle * M_PI / 180);
    for (Vec3d &p : other.points) p = {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
    TransferSettings settings = settingsOf(kBands, 64, 0.03);
    TransferRoom room = transferOf(mesh, settings), turnedRoom = transferOf(other, settings);
    ASSERT_EQ(room.texels(), turnedRoom.texels());
    double worst = 0;
    for (const TriedSky &sky : bandLimitedSkies(kBands, false))
        worst = std::max(worst, difference(lightOf(turnedRoom, sky.light),
                                           lightOf(room, turned(sky.light, kBands, turn.inverse()))));
    std::printf("turned model against turned environment: %.1e\n", worst);
    EXPECT_LT(worst, 1e-4);
}

// All axes give the rows back; each axis adds; the same memory in one subspace holds less.
TEST(Clusters, HoldTheRows) {
    TransferSettings settings = settingsOf(3, 64, 0.03);
    settings.clusters = 16, settings.rank = 28;
    TransferRoom room = transferOf(openRoom(), settings);
    std::vector<float> rows = room.rows(), scale = columnScale(room, rows);
    const Clusters &many = room.clusters;
    EXPECT_LT(lossOf(many, rows, scale, 28), 2e-3); // of 28 lights, most of them grey
    double last = 1;
    for (int rank = 0; rank <= many.rank; ++rank) {
        double loss = lossOf(many, rows, scale, rank);
        EXPECT_LE(loss, last * 1.0001) << rank;
        last = loss;
    }
    for (int rank : {4, 8, 12}) {
        Clusters few = findClusters(rows, room.columns(), scale, blocksOf(room.model, 16), 16, rank, serial);
        int same = rank;
        Clusters one = {.count = 1,
                        .rank = 0,
                        .columns = room.columns(),
                        .of = std::vector<int>(room.texels()),
                        .axes = {},
                        .weights = {}};
        while (one.floats(same) < few.floats(rank)) ++same;
        one = findClusters(rows, room.columns(), scale, one.of, 1, same, serial);
        double clusters = lossOf(few, rows, scale, rank), subspace = lossOf(one, rows, scale, same);
        std::printf("%d axes: clusters %.2f %%, one subspace of %d axes %.2f %%\n", rank, 100 * clusters,
                    same, 100 * subspace);
        EXPECT_LT(clusters, 0.7 * subspace);
    }
    // Axes are in order: those of a cluster explain less and less
    for (int c = 0; c < many.count; ++c) {
        std::vector<double> squares((size_t)many.rank);
        for (size_t t = 0; t < many.of.size(); ++t)
            for (size_t d = 0; many.of[t] == c && d < squares.size(); ++d)
                squares[d] += std::pow((double)many.weights[t * squares.size() + d], 2);
        for (size_t d = 1; d < squares.size(); ++d) EXPECT_LE(squares[d], squares[d - 1] * 1.0001 + 1e-20);
    }
    std::vector<int> blocks = blocksOf(room.model, 16), sizes(16);
    for (int block : blocks) ++sizes[(size_t)block];
    for (int size : sizes) EXPECT_NEAR(size, (double)blocks.size() / 16, 2);
}

// The exact rows, summed in double precision by hand.
TEST(Relighting, IsASumOfRows) {
    TransferRoom room = transferOf(openRoom(), settingsOf(4, 32, 0.1));
    Random random = {7};
    BandLight sky = randomLight(4, random);
    std::vector<Rgb> light = lightOf(room, sky, 0.5f),
                     compressed = lightOf(room, sky, 0.5f, room.clusters.rank);
    for (size_t t = 0; t < room.texels(); ++t) {
        double sum = 0, all = 0;
        for (int k = 0; k < room.bases(); ++k) {
            double term = (double)room.plane(k, 1)[t] * (k < 16 ? (double)sky[(size_t)k].y : 0.5);
            sum += term, all += std::fabs(term);
        }
        EXPECT_NEAR(light[t].y, sum, 1e-6 * all);
    }
    EXPECT_LT(difference(compressed, light), 0.01);
}

// A mirror blurred by a lobe, over a floor without walls: the sky's own coefficients, in the half-space
// above, by dense quadrature. Then in the open room, by random rays through the solution for this light.
TEST(Gloss, IsTheLobeOfWhatArrives) {
    auto lobeOf = [](double cosine, double exponent) { // of the bands' windows, around the mirrored direction
        double sum = 0;
        for (int l = 0; l < kBands; ++l)
            sum += (2 * l + 1) / (4 * M_PI) * (double)window(l, (float)exponent) * legendre(l, cosine);
        return sum;
    };
    auto shown = [&](const Mesh &mesh, const Vec3 &eye, bool lamps, const char *what, double limit) {
        TransferSettings settings = settingsOf(kBands, 256, 0.05);
        settings.glossy = "grey", settings.polish = 0.3f, settings.exponent = 20;
        TransferRoom room = transferOf(mesh, settings);
        ASSERT_FALSE(room.gloss.empty());
        BandLight sky = bandLimitedSkies(kBands, false)[2].light;
        Lighting lighting = {
            .sky = sky, .lamps = std::vector<float>(room.lamps.size(), lamps), .bands = kBands, .rank = -1};
        Solution lit = litModel(room, lighting, &eye);
        RayTree tree(cornersOf(mesh));
        Regions regions = joinRegions(mesh, std::sqrt(0.05));
        const Chart &floor = lit.charts[0];
        double error = 0, all = 0;
        for (int j = 3; j < floor.down; j += 5)
            for (int i = 3; i < floor.across; i += 5) {
                Vec3 p = floor.at((float)i / (float)floor.across * floor.width,
                                  (float)j / (float)floor.down * floor.height);
                Vec3 from = p + floor.n * 1e-3f, d = normalize(p - eye),
                     mirror = d - floor.n * (2 * dot(d, floor.n));
                double sum = 0;
                const int around = 128, count = 64 * around;
                for (int k = 0; k < count; ++k) {
                    // Rings about the normal, of equal height
                    float high = ((float)(k / around) + 0.5f) / (count / around),
                          wide = std::sqrt(1 - high * high);
                    float angle =
                        ((float)(k % around) + 0.25f * (float)(k / around % 4)) * (float)(2 * M_PI / around);
                    Vec3 way = floor.u * (wide * std::cos(angle)) + floor.v * (wide * std::sin(angle)) +
                               floor.n * high;
                    RayHit hit = tree.nearest(from, way);
                    double light = 0;
                    if (hit.triangle < 0)
                        light = (double)radiance(sky, kBands, way).y;
                    else if (!hit.back) {
                        int chart = regions.chartOf[(size_t)hit.triangle];
                        Vec3 at = from + way * hit.t;
                        light = (double)(lit.lightAt(chart, at) * lit.reflects[(size_t)chart] +
                                         lit.emits[(size_t)chart])
                                    .y;
                    }
                    sum += light * lobeOf((double)dot(way, mirror), 20) * 2 * M_PI / count;
                }
                double grazing = 1 - (double)-dot(d, floor.n), schlick = 0.3 + 0.7 * std::pow(grazing, 5),
                       exact = std::fmax(sum, 0) * schlick,
                       got = (double)lit.gloss[(size_t)floor.texel(i, j)].y;
                error += (got - exact) * (got - exact), all += exact * exact;
            }
        std::printf("gloss against dense rays, %s: %.2f %% rms\n", what, 100 * std::sqrt(error / all));
        EXPECT_LT(std::sqrt(error / all), limit);
    };
    Mesh plate = meshOf({{{-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 0}}, {{"grey", {0.5f, 0.5f, 0.5f}, {}}});
    shown(plate, {1, 1.5f, 3}, false, "an open floor", 0.02);
    shown(openRoom(), {0.5f, 1.6f, 5}, true, "an open room", 0.03);
}

namespace {

std::string fileOf(const TransferRoom &room) {
    TemporaryFolder folder;
    room.save(folder / "room.prt");
    return readWhole(folder / "room.prt");
}

// Whether a file is accepted, and can be worked with then.
bool accepted(const std::string &file) {
    TemporaryFolder folder;
    writeWhole(folder / "room.prt", file);
    try {
        TransferRoom room = TransferRoom::read(folder / "room.prt");
        Vec3 eye = {1, 2, 3};
        for (int rank : {-1, 0, room.clusters.rank})
            litModel(room, {.sky = {}, .lamps = {}, .bands = room.bands, .rank = rank}, &eye);
        return true;
    } catch (const std::runtime_error &e) {
        EXPECT_EQ(std::string(e.what()).find(folder / "room.prt"), 0u) << e.what();
        EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
        return false;
    }
}

} // namespace

TEST(File, KeepsTheRoom) {
    TransferSettings settings = settingsOf(2, 16, 0.5);
    settings.glossy = "grey", settings.upIsZ = true;
    TransferRoom room = transferOf(openRoom(), settings);
    std::string file = fileOf(room);
    TemporaryFolder folder;
    writeWhole(folder / "room.prt", file);
    EXPECT_TRUE(TransferRoom::is(folder / "room.prt"));
    EXPECT_FALSE(TransferRoom::is(folder / "none.prt"));
    TransferRoom again = TransferRoom::read(folder / "room.prt");
    EXPECT_EQ(fileOf(again), file);
    EXPECT_EQ(again.lamps, std::vector<std::string>{"lamp"});
    EXPECT_EQ(again.bands, 2);
    EXPECT_TRUE(again.upIsZ);
}

// Damage is found by the checksum; where a forger computes it anew, what is read is refused or can be worked
// with.
TEST(File, SurvivesDamage) {
    TransferSettings settings = settingsOf(2, 8, 4);
    settings.glossy = "grey", settings.rank = 1, settings.clusters = 2;
    TransferRoom room = transferOf(openRoom(), settings);
    std::string file = fileOf(room);
    size_t head = file.find('\n') + 1 + 8;
    ASSERT_TRUE(accepted(file));
    for (size_t end = 0; end < file.size(); end += end < 64 ? 1 : file.size() / 50)
        EXPECT_FALSE(accepted(file.substr(0, end))) << end;
    EXPECT_FALSE(accepted(file + "x"));
    std::string body = file.substr(head);
    EXPECT_FALSE(accepted(TransferRoom::withChecksum(body + "x")));
    for (size_t end = 0; end < body.size(); end += 1 + body.size() / 100)
        EXPECT_FALSE(accepted(TransferRoom::withChecksum(body.substr(0, end)))) << end;
    // Bytes changed: most of the file is small numbers, so some changes are accepted
    int taken = 0, tried = 0;
    for (size_t at = 0; at < body.size(); at += at < 2048 ? 11 : body.size() / 100) {
        for (int value : {0, 0xff, 0x80, 1}) {
            std::string other = body;
            other[at] = (char)(other[at] ^ value);
            if (other != body) taken += accepted(TransferRoom::withChecksum(other)), ++tried;
        }
        std::string flipped = file;
        flipped[head + at] = (char)(flipped[head + at] ^ 4);
        EXPECT_FALSE(accepted(flipped)) << at;
    }
    std::printf("%d of %d changed files could be worked with\n", taken, tried);
    EXPECT_GT(taken, 0);
    EXPECT_LT(taken, tried);
}
