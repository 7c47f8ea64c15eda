#include "tools/picture/readers.h"

#include "tools/common/command_line.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <utility>
#include <vector>
#include <zlib.h>

// A PNG may have empty chunks: allow a copy of 0 bytes from a null pointer
#define memcpy(to, from, size) ((size) > 0 ? memcpy(to, from, size) : (to))
// Clear all memory, since stb_image also reads the tables that a damaged JPEG lacks
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC(memory, size) std::realloc(memory, size)
#define STBI_FREE(memory) std::free(memory)
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_ONLY_BMP
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop
#undef memcpy

namespace pictures {

namespace {

// After the end of a file, stb_image reads zeros or leaves pixels uninitialised. So zeros are appended, at
// least as many as it reads at once (a row of a TGA). If it reads any of them, the file ends early.
constexpr size_t kZeros = 65536 * 4;
constexpr int64_t kMostByStb = 1 << 26;

template <class Sample>
Picture read(std::string_view file, Sample *(*load)(stbi__context *, int *, int *, int *, int)) {
    std::string padded(file);
    padded.append(kZeros, '\0');
    stbi__context from;
    stbi__start_mem(&from, (const stbi_uc *)padded.data(), (int)padded.size());
    Picture p;
    std::unique_ptr<Sample, void (*)(void *)> pixels(load(&from, &p.width, &p.height, &p.channels, 0),
                                                     stbi_image_free);
    if (!pixels && std::string_view(stbi_failure_reason()) == "outofmem") throw std::bad_alloc();
    common::need(from.img_buffer <= (const stbi_uc *)padded.data() + file.size(),
                 "it is damaged: it ends before its last pixel");
    common::need(pixels != nullptr, "it is damaged");
    p.bits = 8 * (int)sizeof(Sample);
    p.encoded.resize(p.pixels() * (size_t)p.channels);
    for (size_t i = 0; i < p.encoded.size(); ++i)
        p.encoded[i] = (uint16_t)(pixels.get()[i] * (sizeof(Sample) == 1 ? 257 : 1));
    return p;
}

// Reads a number. Bytes after the end are 0.
uint32_t numberIn(std::string_view bytes, size_t at, size_t size, bool highestFirst = true) {
    uint32_t n = 0;
    for (size_t k = 0; k < size; ++k) {
        size_t i = at + (highestFirst ? k : size - 1 - k);
        n = n << 8 | (i < bytes.size() ? (uint8_t)bytes[i] : 0);
    }
    return n;
}

// Notes an unusual orientation. Nothing else in EXIF changes what is seen.
void leaveExif(Picture &p, std::string_view exif) {
    auto number = [&](size_t at, size_t size) { return numberIn(exif, at, size, exif[0] == 'M'); };
    const size_t first = number(4, 4) + 2, end = first + 12 * number(first - 2, 2);
    for (size_t at = first; at < end; at += 12)
        if (uint32_t to = number(at + 8, 2); number(at, 2) == 0x112 && to > 1 && to <= 8)
            p.leave("orientation", std::to_string(to));
}

// Returns whether a JPEG has Huffman tables and quantisation tables before its pixels, with at most 256 codes
// in each Huffman table, as stb_image expects. Skips pixels and bytes between segments, where
// a byte of 255 is followed by 0 or by a restart marker. Notes unused statements in `p`.
bool hasTables(std::string_view jpeg, Picture &p) {
    auto byte = [&](size_t at) { return at < jpeg.size() ? (uint8_t)jpeg[at] : 0; };
    bool huffman = false, quantisation = false;
    for (size_t at = 0; at + 4 <= jpeg.size();) {
        int marker = byte(at + 1);
        if (byte(at) != 0xff || marker == 0xff) {
            ++at;
            continue;
        }
        at += 2;
        if (marker == 0 || (marker >= 0xd0 && marker <= 0xd8)) continue; // without a segment
        if (marker == 0xd9) {                                            // end of the picture
            size_t more = jpeg.find("\xff\xd8\xff", at);
            if (more != jpeg.npos) p.leave("further pictures", jpeg.substr(more));
            return true;
        }
        huffman |= marker == 0xc4, quantisation |= marker == 0xdb;
        if (marker == 0xda && !(huffman && quantisation)) return false;
        size_t end = at + numberIn(jpeg, at, 2);
        std::string_view segment = jpeg.substr(at, end - at); // begins with its size
        if (marker == 0xe1 && segment.size() > 8 && segment.substr(2, 4) == "Exif")
            leaveExif(p, segment.substr(8));
        if (marker == 0xe2 && segment.find("ICC_PROFILE") == 2) p.leave("an ICC profile", segment);
        for (size_t table = at + 2; marker == 0xc4 && table < end;) {
            int count = 0;
            for (size_t k = 1; k <= 16; ++k) count += byte(table + k);
            if (count > 256) return false;
            table += 17 + (size_t)count;
        }
        at = std::max(end, at);
    }
    return true;
}

constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n";

// Returns the size of a PNG. Checks the checksums of its chunks, which stb_image ignores. Notes unused
// statements in `p`.
size_t checkedSize(std::string_view png, Picture &p) {
    // sRGB's values in these chunks. No profile (iCCP) is usual; cICP is compared below
    static const std::map<std::string, std::vector<uint32_t>> kUsual = {
        {"gAMA", {45455}},
        {"cHRM", {31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000}},
        {"cICP", {}},
        {"iCCP", {}}};
    for (size_t at = kPng.size(); at + 12 <= png.size();) {
        const size_t size = numberIn(png, at, 4);
        if (size > png.size() - at - 12) break;
        std::string_view chunk = png.substr(at + 4, size + 4); // its kind, of four letters, and its content
        common::need(crc32(0, (const Bytef *)chunk.data(), (uInt)chunk.size()) ==
                         numberIn(png, at + 8 + size, 4),
                     "it is damaged: a checksum is wrong");
        const std::string kind(chunk.substr(0, 4));
        if (auto known = kUsual.find(kind); known != kUsual.end()) {
            bool usual = !known->second.empty() || chunk == std::string_view("cICP\1\15\0\1", 8);
            for (size_t k = 0; k < known->second.size(); ++k)
                usual &= std::abs((int64_t)numberIn(chunk, 4 + 4 * k, 4) - known->second[k]) < 100;
            if (!usual) p.leave(kind, chunk);
        }
        if (kind == "acTL" || kind == "fcTL" || kind == "fdAT") p.leave("an animation (APNG)", chunk);
        if (kind == "eXIf" && size) leaveExif(p, chunk.substr(4));
        at += size + 12;
        if (kind == "IEND") return at;
    }
    throw common::Refused("it is damaged: it ends before its last pixel");
}

void dropAlpha(Picture &p) {
    size_t to = 0, channels = (size_t)p.channels--;
    for (size_t i = 0; i < p.encoded.size(); ++i)
        if ((i + 1) % channels) p.encoded[to++] = p.encoded[i];
    p.encoded.resize(to);
}

// Mirrors a TGA whose rows begin on the right.
void mirror(Picture &p) {
    auto channels = (size_t)p.channels, width = (size_t)p.width;
    for (size_t row = 0; row < p.encoded.size(); row += width * channels)
        for (size_t left = 0, right = width - 1; left < right; ++left, --right)
            std::swap_ranges(&p.encoded[row + left * channels], &p.encoded[row + left * channels] + channels,
                             &p.encoded[row + right * channels]);
}

} // namespace

Picture takeByStb(std::string_view &rest) {
    std::string_view file = std::exchange(rest, {});
    common::need(file.size() <= (size_t)256 << 20, "it has more than 256 MB");
    const bool isPng = file.starts_with(kPng),
               isTga = !isPng && !file.starts_with('\xff') && !file.starts_with("BM");
    Picture head; // for the unused statements of the file
    if (isPng) {
        size_t size = checkedSize(file, head);
        if (file.substr(size).starts_with(kPng)) rest = file.substr(size);
        file = file.substr(0, size);
    }
    if (file.starts_with('\xff')) common::need(hasTables(file, head), "it is damaged");
    auto *bytes = (const stbi_uc *)file.data();
    int width, height, channels, size = (int)file.size();
    common::need(stbi_info_from_memory(bytes, size, &width, &height, &channels),
                 isTga ? "its format is unknown; PNG, JPEG, TGA, BMP, PNM, Radiance HDR and OpenEXR are read"
                       : "it is damaged, or of a kind that is not read");
    int64_t pixels = std::abs((int64_t)width * height); // the height is negative if the top row is first
    common::need(pixels > 0 && pixels <= kMostByStb, "it has no pixels, or more than 2^26");
    Picture p = stbi_is_16_bit_from_memory(bytes, size)
                    ? read<stbi__uint16>(file, stbi__load_and_postprocess_16bit)
                    : read<stbi_uc>(file, stbi__load_and_postprocess_8bit);
    if (isTga && file[17] & 0x10) mirror(p);
    // Alpha exists only in a TGA with alpha bits, and in a BMP with an alpha mask or a header above 40 bytes
    if (p.hasAlpha() && (isTga ? !(file[17] & 15) : file.starts_with("BM") && file[14] == 40 && !file[30]))
        dropAlpha(p);
    p.unused.merge(head.unused);
    return p;
}

} // namespace pictures
