// Tests the reader of PNM byte by byte, and pictures read by stb_image: depth, alpha, several pictures, and
// files that are cut or damaged.
#include "tests/support/thrown.h"
#include "tools/common/command_line.h"
#include "tools/common/folders.h"
#include "tools/common/whole_file.h"
#include "tools/picture/picture_file.h"

using namespace pictures;
using namespace std::string_literals;

static Picture read(const std::string &bytes) {
    PictureFile file("a", bytes);
    Picture p = file.next();
    EXPECT_FALSE(file.more());
    return p;
}

static void expectRefused(const std::string &bytes, const std::string &why) {
    std::string got = thrown<common::Refused>([&] {
        PictureFile file("a", bytes);
        while (file.more()) file.next();
    });
    EXPECT_EQ(got.rfind("a: ", 0), 0u) << got;
    EXPECT_NE(got.find(why), std::string::npos) << bytes.substr(0, 20) << ": " << got;
}

const std::string kFolder = ODRAZ_SOURCE "/tests/support/pictures/";
using Encoded = std::vector<uint16_t>;

static std::string with(std::string file, size_t at, const std::string &to) {
    return file.replace(at, to.size(), to);
}

static std::string tga(int width, int height, int bits, const std::string &pixels, int kind = 2) {
    std::string head(18, '\0');
    head[2] = (char)kind, head[12] = (char)width, head[14] = (char)height, head[16] = (char)bits,
    head[17] = bits == 32 ? 0x28 : 0x20; // top row first; eight bits of alpha if 32
    return head + pixels;
}

static std::string bmp(int width, int height, const std::string &pixels) {
    std::string head(54, '\0');
    head[0] = 'B', head[1] = 'M', head[10] = 54, head[14] = 40, head[18] = (char)width, head[26] = 1,
    head[28] = 24;
    for (size_t k = 0; k < 4; ++k) head[22 + k] = (char)(height >> (8 * k)); // negative: top row first
    return head + pixels;
}

TEST(Pnm, ReadsGreyAndRgbOf8And16Bits) {
    Picture p = read("P6\n2 1\n255\n\1\2\3\xff\0\x80"s);
    EXPECT_EQ(p.width, 2);
    EXPECT_EQ(p.height, 1);
    EXPECT_EQ(p.channels, 3);
    EXPECT_EQ(p.bits, 8);
    EXPECT_EQ(p.encoded, (Encoded{257, 514, 771, 65535, 0, 32896}));
    p = read("P6\n1 1\n65535\n\x00\x80\xff\x80\x12\x34"s); // the high byte comes first
    EXPECT_EQ(p.bits, 16);
    EXPECT_EQ(p.encoded, (Encoded{0x0080, 0xff80, 0x1234}));
    p = read("P5\n2 2\n65535\n\x00\x00\x00\x01\x01\x00\xff\xff"s);
    EXPECT_EQ(p.channels, 1);
    EXPECT_EQ(p.encoded, (Encoded{0, 1, 256, 65535}));
    EXPECT_EQ(read("P5 1 2 255\n\x80\xff"s).encoded, (Encoded{0x8080, 65535}));
}

TEST(Pnm, ScalesByItsLargestValue) {
    EXPECT_EQ(read("P6\n1 1\n15\n\x0f\x00\x05"s).encoded, (Encoded{65535, 0, 21845}));
    EXPECT_EQ(read("P5\n2 1\n1\n\x01\x00"s).encoded, (Encoded{65535, 0}));
    EXPECT_EQ(read("P5\n1 1\n1023\n\x03\xff"s).encoded, (Encoded{65535}));
    EXPECT_EQ(read("P5\n1 1\n256\n\x00\x80"s).encoded, (Encoded{32768})); // above 255: two bytes a value
    expectRefused("P5\n1 1\n15\n\x10", "a pixel above its largest value");
    expectRefused("P5\n1 1\n1023\n\x04\x00"s, "a pixel above its largest value");
}

TEST(Pnm, ReadsCommentsAndText) {
    EXPECT_EQ(read("P5#c\n# by GIMP 1 2 3\n1#\n #x\n\n2 # 7\r255#\n\1\2").encoded, (Encoded{257, 514}));
    EXPECT_EQ(read("P5 1 1 255\n#").encoded, (Encoded{'#' * 257})); // a pixel, not a comment
    EXPECT_EQ(read("P2\n3 1 # c\n15\n0 5\n15\n").encoded, (Encoded{0, 21845, 65535}));
    Picture p = read("P3 1 2 65535 1 2 3\t65535\n0 4096");
    EXPECT_EQ(p.channels, 3);
    EXPECT_EQ(p.encoded, (Encoded{1, 2, 3, 65535, 0, 4096}));
}

TEST(Pnm, ReadsAllPictures) {
    for (std::string all : {"P6 1 1 255\nabcP5 2 1 65535\nABCDP2 1 1 9 9\n\nP5 1 1 255\nz",
                            "P2 1 1 9 9 P2 1 1 9 9 P2 1 1 9 9 P2 1 1 9 8"}) {
        PictureFile file("a", all);
        int count = 0;
        for (; file.more(); ++count) file.next();
        EXPECT_EQ(count, 4) << all;
    }
    expectRefused("P6 1 1 255\nabc\n", "1 bytes follow its last pixel");
    expectRefused("P6 1 1 255\nabcP6", "2 bytes follow its last pixel");
    expectRefused("P5 1 1 255\naP5 1 1 255\n", "ends before its last pixel");
    expectRefused("P2 1 1 9 9 9", "1 bytes follow its last pixel");
    common::TemporaryFolder folder;
    common::writeWhole(folder / "two", "P5 1 1 255\naP5 1 1 255\nb");
    EXPECT_THROW(readPicture(folder / "two"), common::Refused);
}

TEST(Pnm, RefusesWhatIsDamaged) {
    for (const char *file : {"P6 1 1 255\nab", "P6 1 1 255", "P6 640 480 255\n", "P6 1 1", "P6 ",
                             "P5 1 1 65535\na", "P3 1 1 255 1 2", "P3 1 1 255 1 2 ", "P2 30000 4000 255 1"})
        expectRefused(file, "it ends before its last pixel");
    for (const char *file :
         {"P6 0 1 255\n", "P6 1 0 255\n", "P6 -1 1 255\n", "P6 99999999999999999999 1 255\nx", "P6 x"})
        expectRefused(file, "that is not from 1 to 134217728");
    for (const char *file : {"P6 1 1 0\nabc", "P6 1 1 65536\nabcdef"})
        expectRefused(file, "a largest value that is not from 1 to 65535");
    expectRefused("P2 1 1 9 10", "a pixel that is not from 0 to 9");
    expectRefused("P6 40000 40000 255\nabc", "more than 2^27 pixels");
    expectRefused("P6 1 1 255abc", "it has no space between its header and its pixels");
    for (char kind : "147Ff"s)
        expectRefused("P"s + kind + " 1 1 255\nabc", "only P2, P3, P5 and P6 are read");
}

TEST(PictureFile, RefusesOtherFiles) {
    expectRefused("", "it is empty");
    for (const char *file : {"P", "P6", "newmtl m\nKd 1 1 1\n", "GIF89a\1\0\1\0\x80"})
        expectRefused(file,
                      "its format is unknown; PNG, JPEG, TGA, BMP, PNM, Radiance HDR and OpenEXR are read");
    expectRefused("\x89PNG\r\n\x1a\n", "it is damaged: it ends before its last pixel");
    expectRefused(with(bmp(2, 2, std::string(16, 'x')), 30, "\1"), // the compression
                  "it is damaged, or of a kind that is not read");
    EXPECT_THROW(readPicture("/tmp"), common::Refused);
    EXPECT_THROW(readPicture("/dev/zero"), common::Refused);
}

// The reader keeps all 16 bits, and alpha.
TEST(PictureFile, ReadsPngAndJpeg) {
    std::string png = common::readWhole(kFolder + "small.png"),
                jpg = common::readWhole(kFolder + "small.jpg");
    Picture p = read(png);
    EXPECT_EQ(p.bits, 16);
    EXPECT_EQ(p.channels, 4);
    EXPECT_EQ(p.encoded, (Encoded{0x0080, 0x1234, 0xffff, 0x8000, 1, 2, 3, 0xffff}));
    EXPECT_EQ(read(jpg).encoded.size(), 9u * 5 * 3);
    for (size_t size = 60; size < png.size() - 12; ++size)
        expectRefused(png.substr(0, size), "it is damaged");
    for (size_t size = jpg.size() - 140; size < jpg.size(); ++size)
        expectRefused(jpg.substr(0, size), "it is damaged");
    // A file may have several pictures, and the checksum of every chunk is checked
    PictureFile two("a", png + png);
    EXPECT_EQ(two.next().encoded, two.next().encoded);
    EXPECT_FALSE(two.more());
    EXPECT_EQ(read(png + "garbage").encoded, p.encoded);
    for (size_t at = 16; at < png.size(); ++at)
        expectRefused(with(png, at, {(char)(png[at] ^ 4)}), "it is damaged");
    // stb_image copies empty chunks, and assumes that a Huffman table has at most 256 codes
    std::string parts = png, codes = jpg;
    parts.insert(33, "\0\0\0\0IDAT\x35\xaf\x06\x1e"s);
    EXPECT_EQ(read(parts).encoded, p.encoded);
    codes.replace(codes.find("\xff\xc4") + 5, 16, 16, '\xff');
    expectRefused(codes, "it is damaged");
    expectRefused("\xff" + codes, "it is damaged");
    // Without its tables the picture would be grey
    for (const char *table : {"\xff\xc4", "\xff\xdb"}) {
        std::string lacks = jpg;
        for (size_t at; (at = lacks.find(table)) != lacks.npos;) lacks[at + 1] = '\xfe';
        expectRefused(lacks, "it is damaged");
    }
    // The size in the header alone shows that the picture is too large
    expectRefused(
        "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x23\x28\0\0\x23\x28\10\2\0\0\0\xe2\xb7\xe5\xed\0\0\0\0IEND\xae\x42\x60\x82"s,
        "no pixels, or more than 2^26");
}

TEST(PictureFile, ReadsTgaAndBmpToTheirEnds) {
    std::string pixels = "\1\2\3\x80\4\5\6\xff"; // blue, green, red, alpha
    Picture p = read(tga(2, 1, 32, pixels));
    EXPECT_EQ(p.channels, 4);
    EXPECT_EQ(p.encoded, (Encoded{771, 514, 257, 32896, 1542, 1285, 1028, 65535}));
    EXPECT_EQ(read(bmp(1, 2, "\1\2\3\0\4\5\6\0"s)).encoded, (Encoded{1542, 1285, 1028, 771, 514, 257}));
    EXPECT_EQ(read(bmp(1, -2, "\1\2\3\0\4\5\6\0"s)).encoded, (Encoded{771, 514, 257, 1542, 1285, 1028}));
    // Rows that begin on the right
    EXPECT_EQ(read(with(tga(2, 1, 32, pixels), 17, "\x38")).encoded,
              (Encoded{1542, 1285, 1028, 65535, 771, 514, 257, 32896}));
    expectRefused(bmp(1, -(1 << 24), ""), "it ends before its last pixel");
    expectRefused(bmp(127, -(1 << 24), ""), "no pixels, or more than 2^26");
    expectRefused(bmp(0, 9, "abcd"), "no pixels, or more than 2^26");
    for (std::string file : {tga(2, 1, 32, pixels), tga(2, 1, 8, "ab", 3),
                             tga(200, 100, 24, std::string(60000, 'x')), bmp(2, 2, std::string(16, 'x'))}) {
        read(file);
        for (size_t size = file.size() - 1; size > 60; size = size * 9 / 10)
            expectRefused(file.substr(0, size), "it ends before its last pixel");
    }
}

// The fourth byte of a pixel is ignored if the file does not declare it as alpha.
TEST(PictureFile, ReadsAlphaOnlyWhereItIs) {
    EXPECT_EQ(read(with(tga(2, 1, 32, "\1\2\3\x80\4\5\6\xff"), 17, "\x20")).encoded,
              (Encoded{771, 514, 257, 1542, 1285, 1028}));
    EXPECT_EQ(read(with(bmp(1, 1, "\1\2\3\4"), 28, "\x20")).encoded, (Encoded{771, 514, 257}));
}

// Properties of a file that are not used are reported, unless they have their usual values.
TEST(PictureFile, NamesWhatItDoesNotUse) {
    auto unused = [](const char *name, const std::string &more, size_t at) {
        std::string file = common::readWhole(kFolder + name);
        auto all = read(file.insert(std::min(at, file.size()), more)).unused;
        return all.empty() ? "" : all.begin()->first;
    };
    const std::string exif = "\xff\xe1\0\x22"
                             "Exif\0\0II*\0\b\0\0\0\1\0\x12\1\3\0\1\0\0\0X\0\0\0\0\0\0\0"s;
    EXPECT_EQ(unused("small.png", "\0\0\0\4gAMA\0\1\x86\xa0\x31\xe8\x96\x5f"s, 33), "gAMA");
    EXPECT_EQ(unused("small.png", "\0\0\0\4gAMA\0\0\xb1\x8f\x0b\xfc\x61\5"s, 33), "");
    EXPECT_EQ(unused("small.png", "\0\0\0\4cICP\1\xd\0\1\x9c\x69\x3b\x32"s, 33), "");
    EXPECT_EQ(unused("small.png", "\0\0\0\bacTL\0\0\0\2\0\0\0\0\xf3\x8d\x93\x70"s, 33),
              "an animation (APNG)");
    EXPECT_EQ(unused("small.jpg", with(exif, 28, "\1"), 2), "");
    EXPECT_EQ(unused("small.jpg", with(exif, 28, "\6"), 2), "orientation");
    EXPECT_EQ(unused("small.jpg", "\xff\xe2\0\x10ICC_PROFILE\0\1\1"s, 2), "an ICC profile");
    EXPECT_EQ(unused("small.jpg", "trailer", 1 << 20), "");
    EXPECT_EQ(unused("small.jpg", common::readWhole(kFolder + "small.jpg"), 1 << 20), "further pictures");
}

TEST(Picture, HasStepsAndLinearLight) {
    Picture grey = read("P5 1 1 65535\n\x80\x80");
    EXPECT_EQ(grey.steps(0), (std::array<double, 4>{128, 128, 128, 255}));
    EXPECT_NEAR(grey.linear(0)[1], std::pow((128 / 255. + 0.055) / 1.055, 2.4), 1e-6);
    Picture clear = read(tga(1, 1, 32, "\1\2\3\4"));
    EXPECT_EQ(clear.steps(0), (std::array<double, 4>{3, 2, 1, 4}));
    Picture light = {2, 1, 4, 32, {}, {0.5f, 2, -1, 0.25f, 0, 0, 0, 1}};
    EXPECT_EQ(light.steps(0), (std::array<double, 4>{127.5, 510, -255, 63.75}));
    EXPECT_EQ(light.linear(0), (std::array<float, 3>{0.5f, 2, -1}));
    EXPECT_EQ(toImage(light).rgb, (std::vector<uint8_t>{188, 255, 0, 0, 0, 0}));
    EXPECT_EQ(toImage(read("P5 4 1 65535\n\x00\x80\x00\x81\xff\x7e\xff\xff"s)).rgb,
              (std::vector<uint8_t>{0, 0, 0, 1, 1, 1, 254, 254, 254, 255, 255, 255}));
    EXPECT_EQ(linearToImage(read("P5 2 2 65535\n\0\0\xff\xff\xff\xff\0\0"s), 2).rgb,
              (std::vector<uint8_t>{188, 188, 188}));
    EXPECT_THROW(linearToImage(light, 2), common::Refused);
}

// Tests all values of 16 bits, alone and averaged over 4 x 4 pixels. Results are rounded to nearest.
TEST(Picture, LinearLightBecomesSrgb) {
    Picture all = {256, 256, 1, 16, {}};
    for (int i = 0; i < 65536; ++i) all.encoded.push_back((uint16_t)i);
    auto srgb = [](double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; };
    for (size_t by : {1, 4}) {
        Image image = linearToImage(all, (int)by);
        for (size_t y = 0; y < 256; y += by)
            for (size_t x = 0; x < 256; x += by) {
                double mean = ((double)(y * 256 + x) + (double)(by - 1) * 257 / 2) / 65535;
                ASSERT_EQ(image.rgb[(y / by * (256 / by) + x / by) * 3], (int)(srgb(mean) * 255 + 0.5));
            }
    }
}

// Light is limited so that sums of light are finite floats.
TEST(PictureFile, RefusesLightThatIsNoNumberOrTooMuch) {
    auto hdr = [](const char *pixel) {
        return "#?RADIANCE\n\n-Y 1 +X 2\n\x80\x80\x80\x80"s + std::string(pixel, 4);
    };
    EXPECT_EQ(read(hdr("\x80\0\0\xa0")).light[3], 0.5f * 4294967296.f);
    expectRefused(hdr("\xff\xff\xff\xff"),
                  "its pixel 1,0 is 1.69477e+38; light must be a number up to 1e+12");
    expectRefused(hdr("\0\x80\0\xa9"), "its pixel 1,0 is 1.09951e+12");
    std::string exr = common::readWhole(kFolder + "none_half.exr");
    for (const auto &value : {"\0\x7c"s, "\0\xfc"s, "\1\x7e"s}) // infinite, and not a number
        expectRefused(with(exr, exr.size() - 2, value), "its pixel 20,18 is ");
}
