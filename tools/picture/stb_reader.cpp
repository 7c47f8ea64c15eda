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

// A number; bytes behind the end are 0.
uint32_t numberIn(std::string_view bytes, size_t at, size_t size, bool highestFirst = true) {
    uint32_t n = 0;
    for (size_t k = 0; k < size; ++k) {
        size_t i = at + (highestFirst ? k : size - 1 - k);
        n = n << 8 | (i < bytes.size() ? (uint8_t)bytes[i] : 0);
    }
    return n;
}

// Only the orientation in EXIF changes what is seen.
void leaveExif(Picture &p, std::string_view exif) {
    auto number = [&](size_t at, size_t size) { return numberIn(exif, at, size, exif[0] == 'M'); };
    const size_t first = number(4, 4) + 2, end = first + 12 * number(first - 2, 2);
    for (size_t at = first; at < end; at += 12)
        if (uint32_t to = number(at + 8, 2); number(at, 2) == 0x112 && to > 1 && to <= 8)
            p.leave("orientation", std::to_string(to));
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
        size_t end = at + numberIn(jpeg, at, 2);
        std::string_view part = jpeg.substr(at, end - at); // with its size
        if (mark == 0xe1 && part.size() > 8 && part.substr(2, 4) == "Exif") leaveExif(p, part.substr(8));
        if (mark == 0xe2 && part.find("ICC_PROFILE") == 2) p.leave("an ICC profile", part);
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
    // That of sRGB. Profiles and codes of others have nothing usual
    static const std::map<std::string, std::vector<uint32_t>> kUsual = {
        {"gAMA", {45455}},
        {"cHRM", {31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000}},
        {"cICP", {}},
        {"iCCP", {}}};
    for (size_t at = kPng.size(); at + 12 <= png.size();) {
        const size_t size = numberIn(png, at, 4);
        if (size > png.size() - at - 12) break;
        std::string_view part = png.substr(at + 4, size + 4); // its kind, of four letters, and its content
        common::need(crc32(0, (const Bytef *)part.data(), (uInt)part.size()) ==
                         numberIn(png, at + 8 + size, 4),
                     "it is damaged: a checksum is wrong");
        const std::string kind(part.substr(0, 4));
        if (auto known = kUsual.find(kind); known != kUsual.end()) {
            bool usual = !known->second.empty() || part == std::string_view("cICP\1\15\0\1", 8);
            for (size_t k = 0; k < known->second.size(); ++k)
                usual &= std::abs((int64_t)numberIn(part, 4 + 4 * k, 4) - known->second[k]) < 100;
            if (!usual) p.leave(kind, part);
        }
        if (kind == "acTL" || kind == "fcTL" || kind == "fdAT") p.leave("an animation (APNG)", part);
        if (kind == "eXIf" && size) leaveExif(p, part.substr(4));
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
    // TGA counts bits of alpha, and BMP has some only with a mask or in a later head; else such bytes are not
    // alpha
    if (p.hasAlpha() && (isTga ? !(file[17] & 15) : file.starts_with("BM") && file[14] == 40 && !file[30]))
        dropAlpha(p);
    p.unused.merge(head.unused);
    return p;
}

} // namespace pictures
