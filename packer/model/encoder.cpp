#include "packer/model/encoder.h"

#include <new>

namespace pack {

void *Workspace::zeroed(uint64_t size) {
    constexpr uint64_t kPageSize = 4096;
    // New pages are zero already. Clearing old pages would be slower: a short run uses only few pages
    memory.reset();
    memory.reset(std::calloc(size + kPageSize, 1));
    if (!memory) throw std::bad_alloc();
    return (void *)(((uintptr_t)memory.get() + kPageSize - 1) & ~(kPageSize - 1));
}

template Encoded encode<X86Tracker>(const std::vector<uint8_t> &, const Layout &, const ModelParameters &,
                                    Workspace &);
template double measure<X86Tracker>(const std::vector<uint8_t> &, const Layout &, const ModelParameters &,
                                    Workspace &, double);
template std::vector<uint8_t> decode<X86Tracker>(const uint8_t *, size_t, const Layout &,
                                                 const ModelParameters &, Workspace &);

} // namespace pack
