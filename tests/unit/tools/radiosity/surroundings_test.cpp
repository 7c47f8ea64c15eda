// Tests pictures of the sky: no light is lost, and suns replace pixels that are too bright.
#include "tools/common/command_line.h"
#include "tools/common/folders.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/read/surroundings.h"
#include "tools/support/vec3d.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

using namespace odraz;
using namespace odraz::radiosity;

namespace {

constexpr double kTurn = 6.283185307179586;

// An uncompressed picture in Radiance's format.
std::string hdr(int width, int height, const std::function<Rgb(int, int)> &colour) {
    std::string file = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
                       std::to_string(width) + "\n";
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            Rgb c = colour(i, j);
            int exponent;
            std::frexp(std::max({c.x, c.y, c.z, 1e-9f}), &exponent);
            for (float x : {c.x, c.y, c.z}) file += (char)(int)(std::ldexp(x, 8 - exponent));
            file += (char)(exponent + 128);
        }
    return file;
}

SkyPicture read(const std::string &file, bool upIsZ, std::vector<Sun> &suns,
                std::vector<std::string> *notes = nullptr) {
    common::TemporaryFolder folder;
    common::writeWhole(folder / "sky.hdr", file);
    return readSky(folder / "sky.hdr", upIsZ, suns, notes);
}

// Returns the integral of light over all directions, divided by pi.
Rgb all(const SkyPicture &sky, const std::vector<Sun> &suns) {
    Rgb sum = {};
    int high = 4 * std::max(sky.height, 1), wide = 2 * high;
    for (int j = 0; j < high; ++j)
        for (int i = 0; i < wide; ++i) {
            double down = kTurn / 2 * (j + 0.5) / high, around = kTurn * (i + 0.5) / wide;
            Vec3d d = {std::sin(down) * std::sin(around), std::cos(down), std::sin(down) * std::cos(around)};
            sum += sky.radiance(toFloat(d)) * (float)(std::sin(down) / high * (kTurn / wide));
        }
    for (const Sun &s : suns) sum += s.light;
    return sum;
}

} // namespace

// A picture with other primaries is refused. A note reports another aspect ratio.
TEST(Sky, IsAPanoramaOfItsLight) {
    std::vector<Sun> suns;
    std::vector<std::string> notes;
    auto white = [](int, int) { return Rgb{1, 1, 1}; };
    std::string file = hdr(8, 4, white);
    read(file, false, suns, &notes);
    EXPECT_TRUE(notes.empty());
    read(hdr(8, 8, white), false, suns, &notes);
    EXPECT_NE(notes.at(0).find("sky.hdr: it is 8 x 8, not twice as wide as high"), std::string::npos);
    file.insert(file.find('\n') + 1, "PRIMARIES= .3 .6 .64 .33 .15 .06 .3127 .329\n");
    EXPECT_THROW(read(file, false, suns), common::Refused);
}

TEST(Sky, IsAsBrightAsItsPicture) {
    for (int width : {8, 64, 129, 512}) {
        auto colour = [&](int i, int j) {
            return Rgb{1 + 0.5f * (float)((i + j) % 2), 0.25f, j * 2 < width / 2 ? 2.f : 0.5f};
        };
        std::vector<Sun> suns;
        SkyPicture sky = read(hdr(width, width / 2, colour), false, suns);
        Rgb wanted = {}, got = all(sky, suns);
        for (int j = 0; j < width / 2; ++j)
            for (int i = 0; i < width; ++i)
                wanted =
                    wanted +
                    colour(i, j) * (float)(2. / width *
                                           (std::cos(kTurn * j / width) - std::cos(kTurn * (j + 1) / width)));
        EXPECT_TRUE(suns.empty());
        EXPECT_NEAR(got.x, wanted.x, 0.01 * wanted.x) << width;
        EXPECT_NEAR(got.y, wanted.y, 0.01 * wanted.y) << width;
        EXPECT_NEAR(got.z, wanted.z, 0.03 * wanted.z) << width;
    }
}

TEST(Sky, LooksWhereThePictureDoes) {
    // Red towards -z, the middle; green to the right, +x; blue above
    auto colour = [](int i, int j) {
        return j >= 48              ? Rgb{}
               : j < 16             ? Rgb{0, 0, 1}
               : i >= 56 && i < 72  ? Rgb{1, 0, 0}
               : i >= 88 && i < 104 ? Rgb{0, 1, 0}
                                    : Rgb{};
    };
    for (bool upIsZ : {false, true}) {
        std::vector<Sun> suns;
        SkyPicture sky = read(hdr(128, 64, colour), upIsZ, suns);
        Vec3 ahead = upIsZ ? Vec3{0, 1, 0} : Vec3{0, 0, -1}, up = upIsZ ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
        EXPECT_GT(sky.radiance(ahead).x, 0.95f);
        EXPECT_GT(sky.radiance({1, 0, 0}).y, 0.95f);
        EXPECT_GT(sky.radiance(up).z, 0.95f);
        EXPECT_LT(maxComponent(sky.radiance(up * -1.f)), 0.05f);
        EXPECT_LT(maxComponent(sky.radiance({-1, 0, 0})), 0.05f);
    }
}

TEST(Sky, CastsWhatIsTooBrightAsSuns) {
    // One pixel 30,000 times as bright as all others, 30.9 degrees above the horizon towards +x
    for (bool upIsZ : {false, true}) {
        std::vector<Sun> suns;
        SkyPicture sky = read(hdr(256, 128,
                                  [](int i, int j) {
                                      return i == 192 && j == 42 ? Rgb{30000, 20000, 10000} : Rgb{1, 1, 1};
                                  }),
                              upIsZ, suns);
        ASSERT_EQ(suns.size(), 1u);
        Vec3 wanted = sunTowards(90 - 180 * 42.5 / 128, 360 * 192.5 / 256 - 180, upIsZ);
        EXPECT_GT(dot(suns[0].towards, wanted), 0.99999f);
        EXPECT_GT(wanted.x, 0.8f);
        EXPECT_NEAR(upIsZ ? wanted.z : wanted.y, std::sin(30.23 / 360 * kTurn), 1e-3);
        // Its light divided by pi: radiance times solid angle, over pi
        double angle = kTurn / 256 * (std::cos(kTurn * 42 / 256) - std::cos(kTurn * 43 / 256)) / (kTurn / 2);
        EXPECT_NEAR(suns[0].light.x / suns[0].light.z, 3, 0.02); // RGBE has eight bits
        EXPECT_NEAR(suns[0].light.x, 30000 * angle, 0.02 * 30000 * angle);
        Rgb got = all(sky, suns);
        EXPECT_NEAR(got.x, 4 + 30000 * angle, 0.02 * (4 + 30000 * angle));
    }
}

TEST(Sky, CutsWideLightIntoSuns) {
    std::vector<Sun> suns;
    auto colour = [](int i, int j) {
        return i >= 100 && i < 140 && j >= 20 && j < 30 ? Rgb{500, 500, 500} : Rgb{0.1f, 0.1f, 0.1f};
    };
    SkyPicture sky = read(hdr(256, 128, colour), false, suns);
    EXPECT_EQ(suns.size(), 24u);
    double most = 0, least = 1e9;
    for (const Sun &s : suns)
        most = std::max(most, (double)s.light.x), least = std::min(least, (double)s.light.x);
    EXPECT_LT(most, 2.5 * least);
}

TEST(Sky, PutsSunsWhereAsked) {
    auto near = [](const Vec3 &a, const Vec3 &b) { return dot(a, b) > 0.999999f; };
    EXPECT_TRUE(near(sunTowards(0, 0, false), {0, 0, -1}));
    EXPECT_TRUE(near(sunTowards(0, 90, false), {1, 0, 0}));
    EXPECT_TRUE(near(sunTowards(90, 123, false), {0, 1, 0}));
    EXPECT_TRUE(near(sunTowards(0, 0, true), {0, 1, 0}));
    EXPECT_TRUE(near(sunTowards(0, 90, true), {1, 0, 0}));
    EXPECT_TRUE(near(sunTowards(-90, 0, true), {0, 0, -1}));
}

// (hdr_reader_test has files that are not pictures.)
TEST(Sky, RefusesSumsThatAreNoNumbers) {
    std::vector<Sun> suns;
    EXPECT_THROW(read("#?RADIANCE\n\n-Y 1 +X 1\n\xff\xff\xff\xff", false, suns), common::Refused);
}
