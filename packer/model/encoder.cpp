#include "packer/model/encoder.h"

#include <cstring>
#include <new>
#include <sys/mman.h>

namespace pack {

void Unmap::operator()(void *pages) const { munmap(pages, size); }

// New pages are zero already. Clearing old pages would be slower: a short run uses only few pages
std::unique_ptr<void, Unmap> zeroedPages(size_t size) {
    void *pages = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (pages == MAP_FAILED) throw std::bad_alloc();
    return {pages, {size}};
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
