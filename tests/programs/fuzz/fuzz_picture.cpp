// For libFuzzer: whatever a file of pictures holds, the reader refuses it with a line or returns pictures of
// the size that they claim, of numbers that can be compared.
#include "tools/common/command_line.h"
#include "tools/picture/picture_file.h"

#include <cmath>
#include <cstdlib>

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

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    try {
        PictureFile file("a", std::string((const char *)data, size));
        while (file.more()) mustBeSound(file.next());
    } catch (const common::Refused &) {
    }
    return 0;
}
