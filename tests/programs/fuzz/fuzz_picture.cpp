// For libFuzzer: whatever a file of pictures holds, the reader either refuses it with one line or returns
// pictures of the stated sizes with finite values.
#include "tools/common/command_line.h"
#include "tools/picture/picture_file.h"

#include <cmath>
#include <cstdlib>
#include <zlib.h>

using namespace pictures;

static void mustBeSound(const Picture &p) {
    bool good = p.width > 0 && p.height > 0 && p.channels >= 1 && p.channels <= 4 &&
                p.encoded.size() + p.light.size() == p.pixels() * (size_t)p.channels &&
                p.encoded.empty() != p.light.empty();
    for (float x : p.light) good &= std::fabs(x) <= 1e12f;
    for (size_t pixel : {(size_t)0, p.pixels() - 1}) {
        for (float x : p.linear(pixel)) good &= std::fabs(x) <= 1e12f;
        for (double x : p.steps(pixel)) good &= std::isfinite(x);
    }
    if (!good) std::abort();
}

// Corrects the checksums of a PNG: otherwise no damage would reach the decoder.
static void mendPng(std::string &file) {
    if (!file.starts_with("\x89PNG")) return;
    for (size_t at = 8, size; at + 12 <= file.size(); at += size + 12) {
        size = (size_t)(uint8_t)file[at + 2] << 8 | (uint8_t)file[at + 3];
        if (file[at] || file[at + 1] || size > file.size() - at - 12) return;
        auto sum = crc32(0, (const Bytef *)&file[at + 4], (uInt)size + 4);
        for (size_t k = 0; k < 4; ++k) file[at + 8 + size + k] = (char)(sum >> (24 - 8 * k));
    }
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    try {
        std::string bytes((const char *)data, size);
        mendPng(bytes);
        PictureFile file("a", bytes);
        while (file.more()) mustBeSound(file.next());
    } catch (const common::Refused &) {
    }
    return 0;
}
