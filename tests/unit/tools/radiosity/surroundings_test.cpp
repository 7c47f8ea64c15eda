// Tests pictures of the sky: no light is lost, and suns replace pixels that are too bright.
#include "tools/common/command_line.h"
#include "tools/common/folders.h"
#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/read/surroundings.h"
#include "tools/support/vec3d.h"

using namespace odraz;
using namespace odraz::radiosity;

constexpr double kTurn = 6.283185307179586;

// An uncompressed picture in Radiance's format.
static std::string hdr(int width, int height, const std::function<Rgb(int, int)> &colour) {
    std::string file = common::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n", height, width);
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

struct ReadSky {
    std::vector<Sun> suns;
    std::vector<std::string> notes;
    SkyPicture sky;

    explicit ReadSky(const std::string &file, bool upIsZ = false) {
        common::TemporaryFolder folder;
        common::writeWhole(folder / "sky.hdr", file);
        sky = readSky(folder / "sky.hdr", upIsZ, suns, &notes);
    }
    // Expects the integral of light over all directions, divided by pi.
    void expectAll(Rgb wanted, Rgb off) const {
        Rgb sum = {};
        int high = 4 * std::max(sky.height, 1), wide = 2 * high;
        for (int j = 0; j < high; ++j)
            for (int i = 0; i < wide; ++i) {
                double down = kTurn / 2 * (j + 0.5) / high, around = kTurn * (i + 0.5) / wide;
                Vec3d d = {std::sin(down) * std::sin(around), std::cos(down),
                           std::sin(down) * std::cos(around)};
                sum += sky.radiance(toFloat(d)) * (float)(std::sin(down) / high * (kTurn / wide));
            }
        for (const Sun &s : suns) sum += s.light;
        for (float Rgb::*c : {&Rgb::x, &Rgb::y, &Rgb::z}) EXPECT_NEAR(sum.*c, wanted.*c, off.*c * wanted.*c);
    }
};

// A picture with other primaries is refused. A note reports another aspect ratio.
TEST(Sky, IsAPanoramaOfItsLight) {
    auto white = [](int, int) { return Rgb{1, 1, 1}; };
    std::string file = hdr(8, 4, white);
    EXPECT_TRUE(ReadSky(file).notes.empty());
    EXPECT_NE(ReadSky(hdr(8, 8, white)).notes.at(0).find("sky.hdr: it is 8 x 8, not twice as wide as high"),
              std::string::npos);
    file.insert(file.find('\n') + 1, "PRIMARIES= .3 .6 .64 .33 .15 .06 .3127 .329\n");
    EXPECT_THROW(ReadSky{file}, common::Refused);
}

TEST(Sky, IsAsBrightAsItsPicture) {
    for (int width : {8, 64, 129, 512}) {
        auto colour = [&](int i, int j) {
            return Rgb{1 + 0.5f * (float)((i + j) % 2), 0.25f, j * 2 < width / 2 ? 2.f : 0.5f};
        };
        Rgb wanted = {};
        for (int j = 0; j < width / 2; ++j)
            for (int i = 0; i < width; ++i)
                wanted +=
                    colour(i, j) *
                    (float)(2. / width * (std::cos(kTurn * j / width) - std::cos(kTurn * (j + 1) / width)));
        SCOPED_TRACE(width);
        ReadSky sky(hdr(width, width / 2, colour));
        EXPECT_TRUE(sky.suns.empty());
        sky.expectAll(wanted, {0.01f, 0.01f, 0.03f});
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
        SkyPicture sky = ReadSky(hdr(128, 64, colour), upIsZ).sky;
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
    auto colour = [](int i, int j) { return i == 192 && j == 42 ? Rgb{30000, 20000, 10000} : Rgb{1, 1, 1}; };
    for (bool upIsZ : {false, true}) {
        ReadSky sky(hdr(256, 128, colour), upIsZ);
        const std::vector<Sun> &suns = sky.suns;
        ASSERT_EQ(suns.size(), 1u);
        Vec3 wanted = sunTowards(90 - 180 * 42.5 / 128, 360 * 192.5 / 256 - 180, upIsZ);
        EXPECT_GT(dot(suns[0].towards, wanted), 0.99999f);
        EXPECT_GT(wanted.x, 0.8f);
        EXPECT_NEAR(upIsZ ? wanted.z : wanted.y, std::sin(30.23 / 360 * kTurn), 1e-3);
        // Its light divided by pi: radiance times solid angle, over pi
        double angle = kTurn / 256 * (std::cos(kTurn * 42 / 256) - std::cos(kTurn * 43 / 256)) / (kTurn / 2);
        EXPECT_NEAR(suns[0].light.x / suns[0].light.z, 3, 0.02); // RGBE has eight bits
        EXPECT_NEAR(suns[0].light.x, 30000 * angle, 0.02 * 30000 * angle);
        Rgb share = Rgb{3, 2, 1} * (float)(10000 * angle);
        sky.expectAll(Rgb{4, 4, 4} + share, {0.02f, 0.02f, 0.02f});
    }
}

TEST(Sky, CutsWideLightIntoSuns) {
    auto colour = [](int i, int j) {
        return i >= 100 && i < 140 && j >= 20 && j < 30 ? Rgb{500, 500, 500} : Rgb{0.1f, 0.1f, 0.1f};
    };
    const std::vector<Sun> suns = ReadSky(hdr(256, 128, colour)).suns;
    EXPECT_EQ(suns.size(), 24u);
    auto [least, most] = std::minmax_element(
        suns.begin(), suns.end(), [](const Sun &a, const Sun &b) { return a.light.x < b.light.x; });
    EXPECT_LT(most->light.x, 2.5f * least->light.x);
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
    EXPECT_THROW(ReadSky("#?RADIANCE\n\n-Y 1 +X 1\n\xff\xff\xff\xff"), common::Refused);
}
