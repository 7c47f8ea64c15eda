// An ELF file that may be cut short or damaged, read with checked bounds.
#pragma once

#include "packer/read/program.h"

#include <algorithm>
#include <cstring>

namespace pack {

// Whether `size` bytes at `address` lie in the `span` bytes from `base`, for any values.
inline bool within(uint64_t address, uint64_t size, uint64_t base, uint64_t span) {
    return address >= base && size <= span && address - base <= span - size;
}

// All functions throw common::Refused where the file lacks what they read.
struct ElfFile {
    const Bytes &bytes;

    template <class T> T at(uint64_t offset, const char *otherwise) const {
        need(within(offset, sizeof(T), 0, bytes.size()), otherwise);
        T value;
        std::memcpy(&value, bytes.data() + offset, sizeof value);
        return value;
    }
    // Also reads `header`, the ELF header. Refuses all files but executables for x86-64.
    std::vector<Elf64_Phdr> programHeaders(Elf64_Ehdr &header) const {
        need(bytes.size() >= 4 && !std::memcmp(bytes.data(), ELFMAG, SELFMAG), "not an ELF file");
        need(bytes.size() > EI_DATA && bytes[EI_CLASS] == ELFCLASS64,
             "a 32-bit ELF file: only x86-64 is packed");
        need(bytes[EI_DATA] == ELFDATA2LSB, "a big-endian ELF file: only x86-64 is packed");
        header = at<Elf64_Ehdr>(0, "cut short: its ELF header is incomplete");
        need(header.e_machine == EM_X86_64, "not for x86-64: only that is packed");
        need(header.e_type == ET_EXEC || header.e_type == ET_DYN, "not an executable: link it first");
        need(header.e_phentsize == sizeof(Elf64_Phdr) && header.e_phnum > 0 && header.e_phnum < 64,
             "its program headers make no sense");
        std::vector<Elf64_Phdr> all;
        for (uint64_t i = 0; i < header.e_phnum; ++i)
            all.push_back(at<Elf64_Phdr>(header.e_phoff + i * sizeof(Elf64_Phdr),
                                         "cut short: program headers are missing"));
        return all;
    }
    // Checks a segment to load, which must not begin before `end`, where the one before ends.
    void checkSegment(const Elf64_Phdr &h, uint64_t end) const {
        need(h.p_memsz <= kMostMemory && within(h.p_vaddr, h.p_memsz, 0, kAddressEnd - kPage) &&
                 h.p_filesz <= h.p_memsz,
             "a segment is over 64 MiB, or beyond 2 GiB: it cannot be packed");
        need(within(h.p_offset, h.p_filesz, 0, bytes.size()),
             "cut short: a segment's bytes are missing: get it afresh");
        need((h.p_flags & (PF_W | PF_X)) != (PF_W | PF_X),
             "a segment is both writable and executable: link it without -N or -z rwx");
        need(h.p_vaddr >= end, "its segments overlap or are out of order: link it afresh");
    }
    // Copies the bytes of checked segments to their places in `memory`, which begins at the address `base`.
    void copySegments(const std::vector<Elf64_Phdr> &loads, uint64_t base, Bytes &memory) const {
        for (const Elf64_Phdr &h : loads)
            std::copy_n(bytes.begin() + (long)h.p_offset, h.p_filesz,
                        memory.begin() + (long)(h.p_vaddr - base));
    }
    // Empty for a file without section headers; some tools strip them.
    std::vector<Elf64_Shdr> sections() const {
        constexpr char kCut[] = "cut short: its section headers are incomplete";
        auto header = at<Elf64_Ehdr>(0, kCut);
        need(header.e_shnum == 0 || header.e_shentsize == sizeof(Elf64_Shdr),
             "its section headers make no sense");
        std::vector<Elf64_Shdr> all;
        for (uint64_t i = 0; i < header.e_shnum; ++i)
            all.push_back(at<Elf64_Shdr>(header.e_shoff + i * sizeof(Elf64_Shdr), kCut));
        need(all.empty() || header.e_shstrndx < all.size(), "its section headers make no sense");
        return all;
    }
    // The entries of a section that is a table.
    template <class T> std::vector<T> table(const Elf64_Shdr &section, const char *otherwise) const {
        need(section.sh_size < sizeof(T) || within(section.sh_offset, section.sh_size, 0, bytes.size()),
             otherwise);
        std::vector<T> all(section.sh_size / sizeof(T));
        if (!all.empty()) std::memcpy(all.data(), &bytes[section.sh_offset], all.size() * sizeof(T));
        return all;
    }
    // The string at `offset` in a table of strings, which begins at `table` in the file.
    std::string text(uint64_t table, uint64_t offset) const {
        constexpr char kCut[] = "cut short: a table of names is incomplete";
        need(within(table, offset, 0, bytes.size()), kCut);
        auto begin = bytes.begin() + (long)(table + offset), end = std::find(begin, bytes.end(), 0);
        need(end != bytes.end(), kCut);
        return {begin, end};
    }
    std::string text(const Elf64_Shdr &table, uint64_t offset) const { return text(table.sh_offset, offset); }
};

} // namespace pack
