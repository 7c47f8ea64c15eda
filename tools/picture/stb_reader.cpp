#include "tools/picture/readers.h"

#include "tools/common/command_line.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <utility>
#include <zlib.h>

// A PNG may have empty parts: nothing is copied to nowhere
#define memcpy(to, from, size) ((size) > 0 ? memcpy(to, from, size) : (to))
// Memory that stb_image does not fill is 0: it uses tables that a damaged JPEG lacks
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

// stb_image reads zeros where a file ends early, or leaves pixels uninitialised. So it gets
// zeros there, at least as many as it reads at once (a row of TGA), and whether it took any is then visible.
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

// Whether a JPEG has tables before its pixels, of codes and of steps, and of codes at most 256 in each, as
// stb_image expects. What lies between its segments is skipped, as are pixels; there 255 stands before 0, or
// before the mark of a restart.
bool hasTables(std::string_view jpeg) {
    auto byte = [&](size_t at) { return at < jpeg.size() ? (uint8_t)jpeg[at] : 0; };
    bool codes = false, steps = false;
    for (size_t at = 0; at + 4 <= jpeg.size();) {
        int mark = byte(at + 1);
        if (byte(at) != 0xff || mark == 0xff) {
            ++at;
            continue;
        }
        at += 2;
        if (mark == 0 || (mark >= 0xd0 && mark <= 0xd8)) continue; // nothing belongs to these marks
        codes |= mark == 0xc4, steps |= mark == 0xdb;
        if (mark == 0xda && !(codes && steps)) return false;
        size_t end = at + (size_t)(byte(at) * 256 + byte(at + 1));
        for (size_t table = at + 2; mark == 0xc4 && table < end;) {
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

// The size of a PNG, whose parts must have their checksums: stb_image ignores these.
size_t checkedSize(std::string_view png) {
    auto number = [&](size_t at) {
        uint32_t n = 0;
        for (size_t k = 0; k < 4; ++k) n = n << 8 | (uint8_t)png[at + k];
        return n;
    };
    for (size_t at = kPng.size(); at + 12 <= png.size();) {
        const size_t size = number(at);
        if (size > png.size() - at - 12) break;
        std::string_view part = png.substr(at + 4, size + 4); // its kind, of four letters, and its content
        common::need(crc32(0, (const Bytef *)part.data(), (uInt)part.size()) == number(at + 8 + size),
                     "it is damaged: a checksum is wrong");
        at += size + 12;
        if (part.starts_with("IEND")) return at;
    }
    throw common::Refused("it is damaged: it ends before its last pixel");
}

// Exchanges left and right of a TGA that begins on the right.
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
    if (isPng) {
        size_t size = checkedSize(file);
        if (file.substr(size).starts_with(kPng)) rest = file.substr(size);
        file = file.substr(0, size);
    }
    if (file.starts_with('\xff')) common::need(hasTables(file), "it is damaged");
    auto *bytes = (const stbi_uc *)file.data();
    int width, height, channels, size = (int)file.size();
    common::need(stbi_info_from_memory(bytes, size, &width, &height, &channels),
                 isTga ? "its format is unknown; PNG, JPEG, TGA, BMP, PNM, Radiance HDR and OpenEXR are read"
                       : "it is damaged, or of a kind that is not read");
    int64_t pixels = std::abs((int64_t)width * height); // the height is below 0 if lines go down
    common::need(pixels > 0 && pixels <= kMostByStb, "it has no pixels, or more than 2^26");
    Picture p = stbi_is_16_bit_from_memory(bytes, size)
                    ? read<stbi__uint16>(file, stbi__load_and_postprocess_16bit)
                    : read<stbi_uc>(file, stbi__load_and_postprocess_8bit);
    if (isTga && file[17] & 0x10) mirror(p);
    return p;
}

} // namespace pictures
