#include "packer/model/encoder.h"

#include <cstring>

namespace pack {

template <> std::vector<uint8_t> filter<X86Tracker>(const std::vector<uint8_t> &image, const Layout &layout) {
    std::vector<uint8_t> out = image;
    uint8_t opcodes[kOpcodes];
    expandOpcodes(opcodes);
    X86Parser parser = {};
    uint32_t fields[kFields] = {};
    for (uint32_t i = layout.codeBegin; i < layout.codeBegin + layout.codeSize; ++i) {
        uint32_t relative = parser.relative, toNext = parser.step(fields, image[i], opcodes);
        if (toNext && relative == 4) {
            uint32_t value;
            std::memcpy(&value, &out[i - 3], 4);
            value = __builtin_bswap32(value + i + toNext);
            std::memcpy(&out[i - 3], &value, 4);
        }
    }
    return out;
}

} // namespace pack
