// Tests the reader of Radiance HDR byte by byte: runs of both kinds, factors, CIE XYZ, orders of pixels.
#include "tests/support/thrown.h"
#include "tools/common/command_line.h"
#include "tools/picture/readers.h"

using namespace pictures;

static Picture readHdr(std::string_view file) { return takeHdr(file); }

static Picture read(const std::string &head, const std::string &size, const std::string &pixels) {
    return readHdr("#?RADIANCE\n" + head + "\n" + size + "\n" + pixels);
}

// A string of these bytes. In a pixel an exponent of 136 keeps their values.
static std::string bytes(std::initializer_list<int> list) { return {list.begin(), list.end()}; }

// The red values, which are enough to identify pixels.
static std::vector<int> reds(const Picture &p) {
    std::vector<int> all;
    for (size_t i = 0; i < p.light.size(); i += 3) all.push_back((int)p.light[i]);
    return all;
}

static void refused(const std::string &head, const std::string &size, const std::string &pixels,
                    const std::string &why) {
    std::string got = thrown<common::Refused>([&] { read(head, size, pixels); });
    EXPECT_NE(got.find(why), std::string::npos) << head << size << ": " << got;
}

TEST(Hdr, ReadsPlainPixels) {
    Picture p = read("FORMAT=32-bit_rle_rgbe\n", "-Y 1 +X 2", bytes({128, 64, 32, 129, 200, 100, 50, 136}));
    EXPECT_EQ(p.width, 2);
    EXPECT_EQ(p.height, 1);
    EXPECT_EQ(p.light, (std::vector<float>{1, 0.5f, 0.25f, 200, 100, 50}));
}

TEST(Hdr, RepeatsPixelsByOlderRuns) {
    std::string a = bytes({200, 2, 3, 136}), b = bytes({150, 5, 6, 136});
    EXPECT_EQ(reds(read("", "-Y 1 +X 5", a + bytes({1, 1, 1, 3}) + b)),
              (std::vector<int>{200, 200, 200, 200, 150}));
    EXPECT_EQ(reds(read("", "-Y 2 +X 3", a + bytes({1, 1, 1, 2}) + b + b + bytes({1, 1, 1, 1}))),
              (std::vector<int>{200, 200, 200, 150, 150, 150}));
    // The runs 44 and 1 repeat 44 + 256 pixels. After another pixel a run starts with the lowest byte again
    Picture p = read("", "-Y 1 +X 304", a + bytes({1, 1, 1, 44, 1, 1, 1, 1}) + b + bytes({1, 1, 1, 2}));
    std::vector<int> wanted(304, 200);
    wanted[301] = wanted[302] = wanted[303] = 150;
    EXPECT_EQ(reds(p), wanted);
    EXPECT_EQ(p.light[3 * 300 + 2], 3);
    // The runs 0 and 1 repeat 256 pixels
    EXPECT_EQ(reds(read("", "-Y 1 +X 257", a + bytes({1, 1, 1, 0, 1, 1, 1, 1}))), std::vector<int>(257, 200));
}

// Two rows of 8: the first has all four planes as runs, the second is plain.
TEST(Hdr, ReadsNewerRuns) {
    Picture p = read("", "-Y 2 +X 8",
                     bytes({2, 2, 0, 8, 136, 200, 136, 100, 136, 50, 136, 136}) +
                         bytes({2, 2, 0, 8, 8, 1, 2, 3, 4, 5, 6, 7, 8, 136, 0, 136, 0, 136, 136}));
    EXPECT_EQ(reds(p), (std::vector<int>{200, 200, 200, 200, 200, 200, 200, 200, 1, 2, 3, 4, 5, 6, 7, 8}));
    EXPECT_EQ(p.light[7 * 3 + 1], 100);
    EXPECT_EQ(p.light[7 * 3 + 2], 50);
    EXPECT_EQ(p.light[15 * 3 + 1], 0);
}

TEST(Hdr, RefusesRunsThatDoNotFit) {
    std::string a = bytes({200, 2, 3, 136});
    const char *size = "-Y 1 +X 3", *longer = "longer than its row";
    refused("", size, a + bytes({1, 1, 1, 3}), longer);
    refused("", size, a + bytes({1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 9}), longer);
    refused("", size, bytes({1, 1, 1, 3}), "begins with a run");
    refused("", size, a + bytes({1, 1, 1, 1}), "ends before");
}

TEST(Hdr, DividesByAllFactors) {
    std::string pixel = bytes({200, 100, 50, 136});
    EXPECT_EQ(read("EXPOSURE=4\n", "-Y 1 +X 1", pixel).light, (std::vector<float>{50, 25, 12.5f}));
    EXPECT_EQ(read("EXPOSURE=4\nSOFTWARE=x\nEXPOSURE= 0.5\n", "-Y 1 +X 1", pixel).light,
              (std::vector<float>{100, 50, 25}));
    EXPECT_EQ(read("COLORCORR=2 1 0.5\nEXPOSURE=2\nCOLORCORR= 1 5 1\n", "-Y 1 +X 1", pixel).light,
              (std::vector<float>{50, 10, 50}));
    // FreeImage writes 0 for an unknown factor
    for (const char *zero :
         {"EXPOSURE=0\n", "EXPOSURE= 0.000\n", "COLORCORR=0 0 0\n", "EXPOSURE=2\nEXPOSURE=0\nEXPOSURE=.5\n"})
        EXPECT_EQ(read(zero, "-Y 1 +X 1", pixel).light, (std::vector<float>{200, 100, 50})) << zero;
    for (const char *line : {"EXPOSURE=\n", "EXPOSURE=-1\n", "EXPOSURE=nan\n", "EXPOSURE=x\n",
                             "EXPOSURE=1e-19\n", "COLORCORR=1 2\n"})
        refused(line, "-Y 1 +X 1", pixel, "has a damaged line");
}

// The primaries of sRGB in CIE XYZ (IEC 61966-2-1) in Radiance's lumens: 179 times the channels' values.
TEST(Hdr, TurnsXyzIntoSrgbsPrimaries) {
    std::string pixels = bytes({206, 106, 10, 136, 107, 215, 36, 136, 45, 18, 238, 136, 190, 200, 218, 136});
    Picture p = read("FORMAT=32-bit_rle_xyze\n", "-Y 1 +X 4", pixels);
    const double wanted[4][3] = {{500, 0, 0}, {0, 300, 0}, {0, 0, 250}, {200, 200, 200}};
    for (size_t i = 0; i < 4; ++i)
        for (size_t k = 0; k < 3; ++k)
            EXPECT_NEAR((double)p.light[3 * i + k], wanted[i][k] / 179, 3. / 179) << i << " " << k;
    for (float c : p.light) EXPECT_GE(c, 0);
    // Radiance converts its pictures to XYZ in watts, with a factor in EXPOSURE
    p = read("EXPOSURE=5.586592e-03\nFORMAT=32-bit_rle_xyze\n", "-Y 1 +X 4", pixels);
    EXPECT_NEAR(p.light[0], 500, 3);
    refused("FORMAT=32-bit_rle_spec\n", "-Y 1 +X 4", pixels, "format 32-bit_rle_spec");
}

// The usual primaries are sRGB's, or Radiance's default.
TEST(Hdr, NamesWhatItDoesNotUse) {
    auto unused = [](const std::string &line) {
        return read(line, "-Y 1 +X 1", bytes({1, 2, 3, 136})).unused.size();
    };
    for (const char *line :
         {"PRIMARIES=0.640 0.330 0.290 0.600 0.150 0.060 0.333 0.333\n",
          "PRIMARIES= .64 .33 .3 .6 .15 .06 .3127 .329\n", "GAMMA=1\n", "PIXASPECT= 1.0\n", "VIEW= -vtl\n"})
        EXPECT_EQ(unused(line), 0u) << line;
    for (const char *line :
         {"PRIMARIES= .3 .6 .64 .33 .15 .06 .3127 .329\n", "PRIMARIES=\n", "GAMMA=2.2\n", "PIXASPECT=2\n"})
        EXPECT_EQ(unused(line), 1u) << line;
}

// A picture of three columns and two rows, 10 11 12 above 20 21 22, in all orders.
TEST(Hdr, ReadsAllOrders) {
    const std::pair<const char *, std::vector<int>> orders[] = {
        {"-Y 2 +X 3", {10, 11, 12, 20, 21, 22}}, {"+Y 2 +X 3", {20, 21, 22, 10, 11, 12}},
        {"-Y 2 -X 3", {12, 11, 10, 22, 21, 20}}, {"+Y 2 -X 3", {22, 21, 20, 12, 11, 10}},
        {"+X 3 -Y 2", {10, 20, 11, 21, 12, 22}}, {"+X 3 +Y 2", {20, 10, 21, 11, 22, 12}},
        {"-X 3 -Y 2", {12, 22, 11, 21, 10, 20}}, {"-X 3 +Y 2", {22, 12, 21, 11, 20, 10}}};
    for (const auto &[size, inFile] : orders) {
        std::string pixels;
        for (int red : inFile) pixels += bytes({red, 0, 0, 136});
        Picture p = read("", size, pixels);
        EXPECT_EQ(p.width, 3) << size;
        EXPECT_EQ(p.height, 2) << size;
        EXPECT_EQ(reds(p), (std::vector<int>{10, 11, 12, 20, 21, 22})) << size;
    }
    for (const char *size : {"-Y 1 -Y 1", "-X 1 +X 1", "Y 1 X 1", "-Z 1 +X 1", "1 1", "-Y 1", ""})
        refused("", size, bytes({1, 2, 3, 136}), "no line like -Y HEIGHT +X WIDTH");
}

// Windows editors end lines with CR LF.
TEST(Hdr, ReadsLinesOfWindows) {
    Picture p = readHdr("#?RGBE\r\nEXPOSURE=2\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n-Y 1 +X 2\r\n" +
                        bytes({200, 100, 50, 136, 20, 40, 60, 136}));
    EXPECT_EQ(p.light, (std::vector<float>{100, 50, 25, 10, 20, 30}));
}

// Another picture may follow. Other bytes are dropped.
TEST(Hdr, LeavesWhatFollows) {
    const std::string one = "#?RGBE\n\n-Y 1 +X 1\n" + bytes({200, 100, 50, 136});
    std::string several = one + one + "garbage";
    std::string_view rest = several;
    takeHdr(rest);
    EXPECT_EQ(rest, one + "garbage");
    takeHdr(rest);
    EXPECT_EQ(rest, "");
}

TEST(Hdr, RefusesHeadsCutShort) {
    for (std::string head :
         {"#?", "#?RADIANCE\n", "#?RADIANCE\n\n", "#?RADIANCE\n\n-Y 1 +X 1", "#?RADIANCE\n\n-Y 1 +X 1\n"})
        EXPECT_THROW(readHdr(head), common::Refused) << head;
    for (const char *size : {"-Y 0 +X 0", "-Y 40000 +X 40000", "-Y -1 +X 1"})
        refused("", size, "", "no pixels, or more");
}
