#include "tools/picture/readers.h"

#include "tools/common/command_line.h"

#include <algorithm>
#include <array>
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

// The orientation in EXIF; 1: as it is stored, or there is none.
uint32_t orientationOf(std::string_view exif) {
    const bool big = exif.starts_with("MM");
    auto number = [&](size_t at, size_t size) {
        uint32_t n = 0;
        for (size_t k = 0; k < size; ++k) {
            size_t i = at + (big ? k : size - 1 - k);
            n = n << 8 | (i < exif.size() ? (uint8_t)exif[i] : 0);
        }
        return n;
    };
    const size_t first = number(4, 4), count = number(first, 2);
    for (size_t at = first + 2; at < first + 2 + 12 * count; at += 12)
        if (number(at, 2) == 0x112) return number(at + 8, 2);
    return 1;
}

void leaveExif(Picture &p, std::string_view exif) {
    const uint32_t orientation = orientationOf(exif);
    if (orientation > 1 && orientation <= 8) p.leave("orientation", std::to_string(orientation));
}

// Whether a JPEG has tables before its pixels, of codes and of steps, and of codes at most 256 in each, as
// stb_image expects. What lies between its segments is skipped, as are pixels; there 255 stands before 0, or
// before the mark of a restart. What `p` does not use is noted there.
bool hasTables(std::string_view jpeg, Picture &p) {
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
        if (mark == 0xd9) {                                        // its end
            size_t more = jpeg.find("\xff\xd8\xff", at);
            if (more != jpeg.npos) p.leave("further pictures", jpeg.substr(more));
            return true;
        }
        codes |= mark == 0xc4, steps |= mark == 0xdb;
        if (mark == 0xda && !(codes && steps)) return false;
        size_t end = at + (size_t)(byte(at) * 256 + byte(at + 1));
        std::string_view content = jpeg.substr(at, end - at).substr(std::min<size_t>(end - at, 2));
        if (mark == 0xe1 && content.starts_with(std::string_view("Exif\0", 6)))
            leaveExif(p, content.substr(6));
        if (mark == 0xe2 && content.starts_with("ICC_PROFILE")) p.leave("an ICC profile", content);
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

// The size of a PNG, whose parts must have their checksums: stb_image ignores these. What `p` does not use is
// noted there.
size_t checkedSize(std::string_view png, Picture &p) {
    constexpr std::array kPrimaries = {31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000}; // of sRGB
    bool isSrgb = false;
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
        const std::string kind(part.substr(0, 4));
        auto near = [&](size_t k, int usual) {
            return size >= 4 * k + 4 && std::abs((int64_t)number(at + 8 + 4 * k) - usual) < 100;
        };
        bool usual = kind == "gAMA" && near(0, 45455);
        if (kind == "cHRM") {
            usual = true;
            for (size_t k = 0; k < kPrimaries.size(); ++k) usual &= near(k, kPrimaries[k]);
        }
        if (kind == "cICP") usual = part.substr(4) == std::string_view("\1\15\0\1", 4);
        if (!usual && (kind == "gAMA" || kind == "cHRM" || kind == "cICP" || kind == "iCCP"))
            p.leave(kind, part);
        if (kind == "acTL" || kind == "fcTL" || kind == "fdAT") p.leave("an animation (APNG)", part);
        if (kind == "eXIf") leaveExif(p, part.substr(4));
        isSrgb |= kind == "sRGB"; // it goes before gAMA and cHRM
        at += size + 12;
        if (kind != "IEND") continue;
        if (isSrgb) p.unused.erase("gAMA"), p.unused.erase("cHRM");
        return at;
    }
    throw common::Refused("it is damaged: it ends before its last pixel");
}

// Whether a TGA counts bits of alpha, and does not call them undefined in the extension of version 2.
bool hasAlpha(std::string_view tga) {
    constexpr std::string_view kMark("TRUEVISION-XFILE.\0", 18);
    uint32_t extension = 0;
    if (tga.size() > 44 && tga.ends_with(kMark)) std::memcpy(&extension, tga.end() - 26, sizeof extension);
    const bool undefined = extension && extension + 495ul <= tga.size() && tga[extension + 494] < 3;
    return tga[17] & 15 && !undefined;
}

void dropAlpha(Picture &p) {
    size_t to = 0, channels = (size_t)p.channels--;
    for (size_t i = 0; i < p.encoded.size(); ++i)
        if ((i + 1) % channels) p.encoded[to++] = p.encoded[i];
    p.encoded.resize(to);
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
    Picture head; // what the file says
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
    int64_t pixels = std::abs((int64_t)width * height); // the height is below 0 if lines go down
    common::need(pixels > 0 && pixels <= kMostByStb, "it has no pixels, or more than 2^26");
    Picture p = stbi_is_16_bit_from_memory(bytes, size)
                    ? read<stbi__uint16>(file, stbi__load_and_postprocess_16bit)
                    : read<stbi_uc>(file, stbi__load_and_postprocess_8bit);
    if (isTga && file[17] & 0x10) mirror(p);
    const bool isBmp = file.starts_with("BM");
    auto word = [&](size_t at) {
        uint32_t n = 0;
        if (isBmp && at + sizeof n <= file.size()) std::memcpy(&n, file.data() + at, sizeof n);
        return n;
    };
    // Before version 4 of its head a BMP has no alpha, unless a mask says so
    if (p.hasAlpha() && (isTga ? !hasAlpha(file) : isBmp && word(14) == 40 && word(30) == 0)) dropAlpha(p);
    const uint32_t space = word(14) >= 108 ? word(70) : 0;
    if (space && space != 0x73524742 /* sRGB */ && space != 0x57696e20 /* Windows's, which is it */)
        p.leave("a colour space", file.substr(70, 54));
    p.unused.merge(head.unused);
    return p;
}

} // namespace pictures
