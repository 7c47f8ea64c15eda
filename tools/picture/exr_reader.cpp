#include "tools/picture/readers.h"

#include "tools/common/command_line.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#define TINYEXR_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <tinyexr.h>
#pragma GCC diagnostic pop

namespace pictures {

namespace {

using common::need;

constexpr uint32_t kTiled = 0x200, kLongNames = 0x400, kDeep = 0x800, kParts = 0x1000, kVersion = 2;
constexpr const char *kCompressions[] = {"none",  "RLE", "ZIPS", "ZIP",  "PIZ",
                                         "PXR24", "B44", "B44A", "DWAA", "DWAB"};
constexpr int kLinesOfChunk[] = {1, 1, 1, 16, 32}; // for the first five compressions, the readable ones
constexpr int64_t kMostCompressed = 1100;          // the highest ratio that any of these reaches: zlib's
constexpr uint32_t kHuffmanCodes = (1 << 16) + 1;

struct Window { // both ends included
    int x0 = 0, y0 = 0, x1 = -1, y1 = -1;
    int64_t width() const { return (int64_t)x1 - x0 + 1; }
    int64_t height() const { return (int64_t)y1 - y0 + 1; }
};

struct Channel {
    bool half;
    int to = -1; // index in a pixel of the picture; -1: not read
};

// Reads bytes from the front.
struct ByteReader {
    std::string_view rest;

    std::string_view take(size_t size) {
        need(size <= rest.size(), "it is damaged: it ends too early");
        std::string_view taken = rest.substr(0, size);
        rest.remove_prefix(size);
        return taken;
    }
    template <class Number> Number number() {
        Number n;
        std::memcpy(&n, take(sizeof n).data(), sizeof n);
        return n;
    }
    std::string text() { // up to a zero byte
        std::string all(take(std::min(rest.find('\0'), rest.size())));
        take(1);
        return all;
    }
};

class ExrReader {
public:
    explicit ExrReader(std::string_view file) : file(file) {}

    Picture read() {
        ByteReader from = {file.substr(4)};
        readHead(from);
        int64_t lines = kLinesOfChunk[compression];
        chunkWidth = tiled ? std::min(chunkWidth, data.width()) : data.width();
        chunkHeight = tiled ? std::min(chunkHeight, data.height()) : std::min(lines, data.height());
        across = (data.width() + chunkWidth - 1) / chunkWidth;
        int64_t chunks = across * ((data.height() + chunkHeight - 1) / chunkHeight);
        need(data.width() * data.height() * (int64_t)bytesOfPixel <= (int64_t)file.size() * kMostCompressed,
             "it is damaged: it ends too early");
        picture.width = (int)display.width(), picture.height = (int)display.height();
        picture.light.resize(picture.pixels() * (size_t)picture.channels);
        std::vector<bool> seen((size_t)chunks);
        for (int64_t i = 0; i < chunks; ++i) {
            auto offset = from.number<uint64_t>();
            need(offset > 0, "it is not complete: some pixels were never written");
            need(offset < file.size(), "it is damaged: it ends too early");
            size_t number = readChunk({file.substr(offset)});
            need(!seen[number], "it is damaged: it has some pixels twice");
            seen[number] = true;
        }
        return std::move(picture);
    }

private:
    std::string_view file;
    Picture picture = {.channels = 0, .bits = 16};
    std::vector<Channel> channels;          // in the order of the file
    std::vector<EXRChannelInfo> forTinyexr; // the same channels
    size_t bytesOfPixel = 0;
    Window data, display;
    int compression = -1;
    bool tiled = false;
    int64_t chunkWidth = 0, chunkHeight = 0, across = 0;

    void readHead(ByteReader &from) {
        auto version = from.number<uint32_t>();
        need(!(version & kParts), "it has several parts (exrmultipart -separate makes a file of each)");
        need(!(version & kDeep), "it has deep pixels, which are not read");
        need((version & ~(kTiled | kLongNames)) == kVersion, "it is of another version of OpenEXR");
        tiled = version & kTiled;
        while (from.rest.empty() || from.rest[0]) {
            std::string name = from.text(), type = from.text();
            ByteReader value = {from.take(from.number<uint32_t>())};
            if (name == "channels") readChannels(value);
            if (name == "compression") compression = value.number<uint8_t>();
            if (name == "dataWindow") data = value.number<Window>();
            if (name == "displayWindow") display = value.number<Window>();
            if (name == "chromaticities") readPrimaries(value);
            if (name == "envmap" && value.rest != std::string_view("\0", 1)) // not 0, a panorama
                picture.leave("envmap (a cube)", value.rest);
            if ((name == "pixelAspectRatio" || name == "gamma") &&
                value.rest != std::string_view("\0\0\x80\x3f", 4))
                picture.leave(name, value.rest); // not 1
            if (name == "tiles")
                chunkWidth = value.number<uint32_t>(), chunkHeight = value.number<uint32_t>();
        }
        from.take(1);
        need(!channels.empty() && compression >= 0 && (!tiled || (chunkWidth > 0 && chunkHeight > 0)),
             "it is damaged: its head lacks channels, compression or tiles");
        need(compression < (int)std::size(kLinesOfChunk),
             std::string("it is compressed by ") +
                 (compression < (int)std::size(kCompressions) ? kCompressions[compression]
                                                              : "an unknown method") +
                 "; only none, RLE, ZIPS, ZIP and PIZ are read");
        for (const Window &w : {data, display})
            need(w.width() > 0 && w.height() > 0 && w.width() <= kMostPixels &&
                     w.width() * w.height() <= kMostPixels,
                 "it has no pixels, or more than 2^27");
    }

    // Notes primaries and white that are not sRGB's
    void readPrimaries(ByteReader value) {
        bool usual = true;
        const std::string_view bytes = value.rest;
        for (float x : {.64f, .33f, .3f, .6f, .15f, .06f, .3127f, .329f})
            usual &= std::fabs(value.number<float>() - x) < 0.002f;
        if (!usual) picture.leave("chromaticities", bytes);
    }

    void readChannels(ByteReader from) {
        std::map<std::string, size_t> number; // index of each channel
        std::string all;
        std::vector<bool> whole;
        while (from.rest.empty() || from.rest[0]) {
            std::string name = from.text();
            auto type = from.number<int32_t>();
            from.take(4);
            auto across = from.number<int32_t>(), down = from.number<int32_t>();
            need(type >= TINYEXR_PIXELTYPE_UINT && type <= TINYEXR_PIXELTYPE_FLOAT,
                 "it is damaged: its channel " + name + " has no numbers");
            need(across == 1 && down == 1, "its channel " + name + " lacks pixels of the others");
            number[name] = channels.size(), all += " " + name;
            channels.push_back({type == TINYEXR_PIXELTYPE_HALF});
            whole.push_back(type == TINYEXR_PIXELTYPE_UINT);
            forTinyexr.emplace_back().pixel_type = type;
            bytesOfPixel += channels.back().half ? 2 : 4;
        }
        std::vector<std::pair<std::string, std::string>> found; // layers with colours, and their channels
        for (const auto &[name, ignored] : number) {
            const std::string layer = name.substr(0, name.rfind('.') + 1);
            auto has = [&](char c) { return number.count(layer + c) > 0; };
            need(!has('Y') || !(number.count(layer + "RY") || number.count(layer + "BY")),
                 "it has luminance and chroma (Y, RY and BY), which are not read");
            std::string order = has('R') && has('G') && has('B') ? "RGB" : has('Y') && !has('X') ? "Y" : "";
            if (!order.empty() && has('A')) order += 'A';
            if (!order.empty() && (found.empty() || found.back().first != layer))
                found.push_back({layer, order});
        }
        // Take the channels without a layer's name, or the only layer
        need(!found.empty() && (found.size() == 1 || found[0].first.empty()),
             "it has the channels" + all + "; only R, G and B, or Y, with or without A are read");
        const auto &[layer, order] = found[0];
        picture.channels = (int)order.size(), picture.bits = 16;
        for (size_t i = 0; i < order.size(); ++i) {
            const size_t c = number[layer + order[i]];
            need(!whole[c], "its channel " + layer + order[i] +
                                " has whole numbers; only 16 and 32 bits of floats are read");
            channels[c].to = (int)i;
            if (!channels[c].half) picture.bits = 32;
        }
        picture.others = channels.size() > order.size() ? all : "";
    }

    // Reads a chunk: some lines or a tile. Returns its number.
    size_t readChunk(ByteReader from) {
        int64_t x = 0, y;
        if (tiled) {
            x = from.number<int32_t>(), y = from.number<int32_t>();
            need(from.number<uint64_t>() == 0, "it is damaged: its table of tiles is not in order");
        } else {
            int64_t line = (int64_t)from.number<int32_t>() - data.y0;
            need(line % chunkHeight == 0, "it is damaged: its lines are not in order");
            y = line / chunkHeight;
        }
        need(x >= 0 && x < across && y >= 0 && y * chunkHeight < data.height(),
             "it is damaged: it has pixels outside its window");
        int64_t width = std::min(chunkWidth, data.width() - x * chunkWidth),
                height = std::min(chunkHeight, data.height() - y * chunkHeight);
        std::vector<uint8_t> pixels((size_t)(width * height) * bytesOfPixel);
        unpack(from.take(from.number<uint32_t>()), pixels, (int)width, (int)height);
        const uint8_t *p = pixels.data();
        for (int64_t j = 0; j < height; ++j)
            for (const Channel &c : channels)
                for (int64_t i = 0; i < width; ++i, p += c.half ? 2 : 4)
                    put(data.x0 + x * chunkWidth + i, data.y0 + y * chunkHeight + j, c, p);
        return (size_t)(y * across + x);
    }

    void put(int64_t x, int64_t y, const Channel &c, const uint8_t *bytes) {
        if (c.to < 0 || x < display.x0 || x > display.x1 || y < display.y0 || y > display.y1) return;
        float value;
        if (c.half) {
            tinyexr::FP16 half = {};
            std::memcpy(&half.u, bytes, sizeof half.u);
            value = tinyexr::half_to_float(half).f;
        } else {
            std::memcpy(&value, bytes, sizeof value);
        }
        size_t pixel = (size_t)(y - display.y0) * (size_t)picture.width + (size_t)(x - display.x0);
        picture.light[pixel * (size_t)picture.channels + (size_t)c.to] = value;
    }

    void unpack(std::string_view from, std::vector<uint8_t> &to, int width, int height) {
        auto *bytes = (const uint8_t *)from.data();
        unsigned long size = to.size();
        bool good = from.size() == size; // stored without compression
        if (good)
            std::memcpy(to.data(), bytes, size);
        else if (compression == TINYEXR_COMPRESSIONTYPE_RLE)
            good = tinyexr::DecompressRle(to.data(), size, bytes, from.size());
        else if (compression == TINYEXR_COMPRESSIONTYPE_PIZ)
            good =
                isPiz(from) && tinyexr::DecompressPiz(to.data(), bytes, size, from.size(),
                                                      (int)channels.size(), forTinyexr.data(), width, height);
        else if (compression != TINYEXR_COMPRESSIONTYPE_NONE)
            good = tinyexr::DecompressZip(to.data(), &size, bytes, from.size()) && size == to.size();
        need(good, "it is damaged: some of its pixels cannot be decompressed");
    }

    // Returns whether the sizes in a PIZ chunk match its content, which tinyexr does not check.
    static bool isPiz(std::string_view chunk) {
        ByteReader from = {chunk};
        auto first = from.number<uint16_t>(), last = from.number<uint16_t>();
        if (first <= last) from.take((size_t)(last - first) + 1);
        auto size = from.number<uint32_t>(), least = from.number<uint32_t>(), most = from.number<uint32_t>();
        from.take(4);
        auto bits = from.number<uint32_t>();
        from.take(4);
        return size == from.rest.size() + 20 && least <= most && most < kHuffmanCodes &&
               bits <= 8 * from.rest.size();
    }
};

} // namespace

Picture readExr(std::string_view file) { return ExrReader(file).read(); }

} // namespace pictures
