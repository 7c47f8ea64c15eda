#include "packer/model/encoder.h"

#include <cstdlib>
#include <cstring>
#include <new>

namespace pack {

constexpr uint64_t kAlignment = 4096;

// New pages are zero already. Clearing old pages would be slower: a short run uses only few pages
Workspace::Workspace(uint64_t size) : memory(std::calloc(size + kAlignment, 1), std::free) {
    if (!memory) throw std::bad_alloc();
}
void *Workspace::zeroed() const {
    return (void *)(((uintptr_t)memory.get() + kAlignment - 1) & ~(kAlignment - 1));
}

template <> Bytes filter<X86Tracker>(const Bytes &image, const Layout &layout) {
    Bytes out = image;
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

template Encoded encode<X86Tracker>(const Bytes &, const Layout &, const ModelParameters &);
template Bytes decode<X86Tracker>(Bytes, const Layout &, const ModelParameters &);

} // namespace pack
