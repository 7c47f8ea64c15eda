// An ELF file that may be cut short or lie about itself, read with bounds.
#pragma once

#include "program.h"

#include <algorithm>
#include <cstring>

namespace pack {

// Whether `size` bytes at `address` lie in the `span` bytes from `base`, for any values.
inline bool within(uint64_t address, uint64_t size, uint64_t base, uint64_t span) {
    return address >= base && size <= span && address - base <= span - size;
}

// All of these throw Unsuitable where the file does not hold what is asked for.
struct ElfFile {
    const std::vector<uint8_t> &bytes;

    template <class T> T at(uint64_t offset, const char *otherwise) const {
        need(within(offset, sizeof(T), 0, bytes.size()), otherwise);
        T value;
        std::memcpy(&value, bytes.data() + offset, sizeof value);
        return value;
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
    // A string in `table`, which must be a section of strings.
    std::string text(const Elf64_Shdr &table, uint64_t offset) const {
        constexpr char kCut[] = "cut short: a table of names is incomplete";
        need(within(table.sh_offset, offset, 0, bytes.size()), kCut);
        auto begin = bytes.begin() + (long)(table.sh_offset + offset), end = std::find(begin, bytes.end(), 0);
        need(end != bytes.end(), kCut);
        return {begin, end};
    }
};

} // namespace pack
