// Tests the reader of OpenEXR: files by other writers (tests/support/pictures), value by value, and refused
// files.
#include "tests/support/thrown.h"
#include "tools/common/whole_file.h"
#include "tools/picture/readers.h"

using namespace pictures;
using namespace std::string_literals;

constexpr int kWidth = 21, kHeight = 19;

static std::string fileOf(const std::string &name) {
    return common::readWhole(ODRAZ_SOURCE "/tests/support/pictures/" + name + ".exr");
}

static float valueAt(int x, int y, char channel) {
    return channel == 'G'   ? (float)y
           : channel == 'B' ? (float)(x * y % 7) / 4
           : channel == 'A' ? (float)(x % 4) / 4
                            : (float)x + (float)y / 2;
}

// Checks every pixel. All files have the same picture; p begins at its pixel x, y. Pixels of p outside of it
// are 0.
static void expectValues(const Picture &p, const std::string &channels, int x, int y) {
    ASSERT_EQ(p.channels, (int)channels.size());
    ASSERT_EQ(p.light.size(), p.pixels() * channels.size());
    const float *value = p.light.data();
    for (int j = y; j < y + p.height; ++j)
        for (int i = x; i < x + p.width; ++i)
            for (char c : channels) {
                bool inside = i >= 0 && i < kWidth && j >= 0 && j < kHeight;
                EXPECT_EQ(*value++, inside ? valueAt(i, j, c) : 0) << i << " " << j << " " << c;
            }
}

static void refused(const std::string &file, const std::string &why) {
    std::string got = thrown<common::Refused>([&] { readExr(file); });
    EXPECT_NE(got.find(why), std::string::npos) << got;
}

// Returns a copy of the file in which an attribute of the header has another value.
static std::string with(std::string file, const std::string &name, const std::string &type,
                        std::initializer_list<int32_t> value) {
    size_t at = file.find(name + '\0' + type + '\0') + name.size() + type.size() + 6;
    uint32_t size;
    std::memcpy(&size, &file[at - 4], 4);
    for (int32_t v : value) std::memcpy(&file[at], &v, std::min(size, 4u)), at += 4;
    return file;
}

TEST(Exr, ReadsOtherWriters) {
    const std::tuple<const char *, const char *, int> kinds[] = {
        {"none_half", "RGB", 16},          {"rle_float", "RGB", 32},    {"zips_half", "RGB", 16},
        {"zip_rgba", "RGBA", 32},          {"zip_grey", "Y", 16},       {"tiled_piz_half", "RGB", 16},
        {"one_tile_piz_rgba", "RGBA", 32}, {"ripmap_rle_grey", "Y", 16}};
    for (auto [name, channels, bits] : kinds) {
        SCOPED_TRACE(name);
        std::string file = fileOf(name);
        ASSERT_TRUE(isExr(file));
        Picture p = readExr(file);
        EXPECT_EQ(p.width, kWidth);
        EXPECT_EQ(p.height, kHeight);
        EXPECT_EQ(p.bits, bits);
        expectValues(p, channels, 0, 0);
    }
}

// Renderers write other channels as well as the colours: whole numbers, and floats of 16 and 32 bits. Unused
// attributes in the header are reported.
TEST(Exr, ReadsColoursAmongOtherChannels) {
    // A file of 2 x 2 pixels. Each channel is filled with its index
    auto made = [](const std::string &channels, const std::string &more = "", const std::string &value = "") {
        auto number = [](auto n) { return std::string((const char *)&n, sizeof n); };
        std::string file = "\x76\x2f\x31\x01\2\0\0\0"s, list, line;
        auto attribute = [&](const std::string &name, const std::string &type, const std::string &value) {
            file += name + '\0' + type + '\0' + number((int)value.size()) + value;
        };
        std::istringstream words(channels);
        std::string name, type;
        for (int i = 0; words >> name >> type; ++i) {
            list += name + '\0' + number(type == "float" ? 2 : type == "half") + number(0) + number(1) +
                    number(1);
            for (int k = 0; k < 2; ++k)
                line += type == "half"    ? number((uint16_t)(i ? 0x4000 + i * 128 : 0x3c00))
                        : type == "float" ? number((float)i)
                                          : number(i);
        }
        attribute("channels", "chlist", list + '\0');
        attribute("compression", "compression", "\0"s);
        for (const char *window : {"dataWindow", "displayWindow"})
            attribute(window, "box2i", number(0) + number(0) + number(1) + number(1));
        if (!more.empty()) attribute(more, more, value);
        file += '\0';
        const size_t first = file.size() + 16;
        for (size_t y = 0; y < 2; ++y) file += number((uint64_t)(first + y * (line.size() + 8)));
        for (int y = 0; y < 2; ++y) file += number(y) + number((int)line.size()) + line;
        return file;
    };
    using Light = std::vector<float>;
    auto light = [&](const std::string &channels) {
        Picture p = readExr(made(channels));
        EXPECT_FALSE(p.others.empty());
        return Light(p.light.begin(), p.light.begin() + p.channels);
    };
    EXPECT_EQ(light("B float G float R float Z float"), (Light{2, 1, 0}));
    EXPECT_EQ(light("A float B float G float R float id whole"), (Light{3, 2, 1, 0}));
    EXPECT_EQ(light("B half G float R float diffuse.B half diffuse.G half diffuse.R half"), (Light{2, 1, 1}));
    EXPECT_EQ(
        light("Layer.Combined.B float Layer.Combined.G float Layer.Combined.R float Layer.Depth.Z float "
              "Layer.Normal.X half Layer.Normal.Y half Layer.Normal.Z half"),
        (Light{2, 1, 0}));
    EXPECT_EQ(light("Y float Z float"), Light{0});
    auto unused = [&](const std::string &name, const std::string &value) {
        return readExr(made("B float G float R float", name, value)).unused.size();
    };
    auto floats = [](const std::vector<float> &list) {
        return std::string((const char *)list.data(), list.size() * sizeof(float));
    };
    EXPECT_EQ(unused("chromaticities", floats({.64f, .33f, .3f, .6f, .15f, .06f, .3127f, .329f})), 0u);
    EXPECT_EQ(unused("chromaticities", floats({1, 0, 0, 1, 0, 0, 1 / 3.f, 1 / 3.f})), 1u);
    for (const char *name : {"pixelAspectRatio", "gamma"}) {
        EXPECT_EQ(unused(name, floats({1})), 0u);
        EXPECT_EQ(unused(name, floats({2})), 1u);
    }
    EXPECT_EQ(unused("envmap", "\0"s), 0u);
    EXPECT_EQ(unused("envmap", "\1"), 1u);
    refused(made("BY half RY half Y half"), "luminance");
    for (const char *channels :
         {"a.B half a.G half a.R half b.B half b.G half b.R half", "X half Y half Z half"})
        refused(made(channels), "only R, G and B, or Y");
}

// Lines that are stored from the bottom give the same picture.
TEST(Exr, IgnoresTheOrderOfLines) {
    for (const char *name : {"none_half", "zips_half", "tiled_piz_half"})
        expectValues(readExr(with(fileOf(name), "lineOrder", "lineOrder", {1})), "RGB", 0, 0);
}

// The picture is the display window, which may be smaller or larger than the data.
TEST(Exr, ShowsTheDisplayWindow) {
    for (const char *name : {"none_half", "tiled_piz_half"})
        for (auto [x, y, width, height] : {std::array{3, 5, 7, 4}, {-2, -4, 40, 30}, {100, -100, 2, 3}}) {
            Picture p =
                readExr(with(fileOf(name), "displayWindow", "box2i", {x, y, x + width - 1, y + height - 1}));
            EXPECT_EQ(p.width, width);
            EXPECT_EQ(p.height, height);
            expectValues(p, "RGB", x, y);
        }
}

TEST(Exr, RefusesByName) {
    refused(fileOf("tiled_pxr24"), "it is compressed by PXR24; only none, RLE, ZIPS, ZIP and PIZ are read");
    std::string file = fileOf("none_half");
    auto changed = [&](size_t at, const std::string &to) {
        return std::string(file).replace(at, to.size(), to);
    };
    refused(changed(5, "\b"), "it has deep pixels");
    refused(changed(5, "\x10"), "it has several parts");
    refused(with(file, "compression", "compression", {9}), "compressed by DWAB");
    refused(with(file, "compression", "compression", {10}), "compressed by an unknown method");
    const size_t red = file.find("R\0\1"s);
    refused(changed(red, "Z"),
            "it has the channels B G Z; only R, G and B, or Y, with or without A are read");
    refused(changed(red + 2, "\0"s), "its channel R has whole numbers");
    refused(with(file, "dataWindow", "box2i", {0, 0, -1, 0}), "no pixels, or more than 2^27");
    refused(with(file, "displayWindow", "box2i", {0, 0, 99999, 99999}), "no pixels, or more than 2^27");
    refused(with(file, "dataWindow", "box2i", {INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX}),
            "no pixels, or more");
    refused(with(file, "dataWindow", "box2i", {0, 0, 9999, 9999}), "ends too early");
    refused(with(file, "dataWindow", "box2i", {0, 1, 20, 18}), "damaged");
    // Change the first line's offset in the file to none, to another line's, and to one outside the file
    size_t table = file.find("lavc") + 5; // after the header's last value and a zero byte
    refused(changed(table, std::string(8, '\0')), "it is not complete");
    refused(changed(table, file.substr(table + 8, 8)), "it has some pixels twice");
    refused(changed(table + 5, "\1"), "ends too early");
}

// A file is refused wherever it is cut.
TEST(Exr, RefusesWhatIsCutShort) {
    for (const char *name : {"none_half", "rle_float", "zip_rgba", "tiled_piz_half"}) {
        std::string file = fileOf(name);
        // The tiled file ends with smaller mip levels, which are not read
        size_t end = std::string(name) == "tiled_piz_half" ? 2 * file.size() / 3 : file.size();
        for (size_t size = 4; size < end; size += size < 700 ? 1 : 97)
            EXPECT_THROW(readExr(file.substr(0, size)), common::Refused) << name << " " << size;
    }
}
