// What the ELF headers of packed files have in common.
#pragma once

#include <cstring>
#include <elf.h>

namespace pack {

// Of an executable for x86-64 with `segments` program headers from `segmentsAt` on.
inline Elf64_Ehdr elfHeader(uint16_t type, uint64_t entry, uint64_t segmentsAt, uint16_t segments) {
    Elf64_Ehdr h = {};
    std::memcpy(h.e_ident, ELFMAG, SELFMAG);
    h.e_ident[EI_CLASS] = ELFCLASS64;
    h.e_ident[EI_DATA] = ELFDATA2LSB;
    h.e_ident[EI_VERSION] = EV_CURRENT;
    h.e_type = type;
    h.e_machine = EM_X86_64;
    h.e_version = EV_CURRENT;
    h.e_entry = entry;
    h.e_phoff = segmentsAt;
    h.e_ehsize = sizeof h;
    h.e_phentsize = sizeof(Elf64_Phdr);
    h.e_phnum = segments;
    return h;
}

} // namespace pack
