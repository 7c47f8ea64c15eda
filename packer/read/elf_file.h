// Reads an ELF file with checked bounds. The file may be cut short or damaged.
#pragma once

#include "packer/read/program.h"

#include <algorithm>
#include <cstring>
#include <map>

namespace pack {

// Whether the `size` bytes at `address` are within the `span` bytes from `base` on. No value overflows.
inline bool within(uint64_t address, uint64_t size, uint64_t base, uint64_t span) {
    return address >= base && size <= span && address - base <= span - size;
}

// All functions throw common::Refused if the file ends too early or is invalid.
struct ElfFile {
    const Bytes &bytes;

    // Returns the `count` entries of a table in the file.
    template <class T> std::vector<T> table(uint64_t offset, uint64_t count, const char *error) const {
        need(!count || (count <= bytes.size() && within(offset, count * sizeof(T), 0, bytes.size())), error);
        std::vector<T> all(count);
        if (count) std::memcpy(all.data(), &bytes[offset], count * sizeof(T));
        return all;
    }
    template <class T> T at(uint64_t offset, const char *error) const {
        return table<T>(offset, 1, error)[0];
    }
    // Returns no headers for a file without them; some tools strip them.
    std::vector<Elf64_Shdr> sections() const {
        constexpr char kCut[] = "cut short: its section headers are incomplete";
        auto header = at<Elf64_Ehdr>(0, kCut);
        need(header.e_shnum == 0 ||
                 (header.e_shentsize == sizeof(Elf64_Shdr) && header.e_shstrndx < header.e_shnum),
             "its section headers are invalid: link it again");
        return table<Elf64_Shdr>(header.e_shoff, header.e_shnum, kCut);
    }
    // Returns the string at `offset` in the string table that begins at `table` in the file.
    std::string text(uint64_t table, uint64_t offset) const {
        constexpr char kCut[] = "cut short: a table of names is incomplete";
        need(within(table, offset, 0, bytes.size()), kCut);
        auto begin = bytes.begin() + (long)(table + offset), end = std::find(begin, bytes.end(), 0);
        need(end != bytes.end(), kCut);
        return {begin, end};
    }
    std::string text(const Elf64_Shdr &table, uint64_t offset) const { return text(table.sh_offset, offset); }
    // Returns the name of one of `sections`.
    std::string nameOf(const std::vector<Elf64_Shdr> &sections, const Elf64_Shdr &section) const {
        return text(sections[at<Elf64_Ehdr>(0, "cut short").e_shstrndx], section.sh_name);
    }
};

// The dynamic section.
struct Dynamic {
    std::vector<std::string> needed;   // names of libraries
    std::map<int64_t, uint64_t> value; // values of all other entries, by tag
    uint64_t operator[](int64_t tag) const { return value.count(tag) ? value.at(tag) : 0; }
};

// An executable or a shared library for x86-64.
struct ElfProgram : ElfFile {
    Elf64_Ehdr header;
    std::vector<Elf64_Phdr> headers; // the program headers

    explicit ElfProgram(const Bytes &bytes); // throws for all other files

    // Returns the first program header of a type, or null.
    const Elf64_Phdr *firstOf(uint32_t type) const;
    // Returns the headers of the segments that are loaded.
    std::vector<Elf64_Phdr> loads() const;
    // Returns the address in memory of bytes in the file, or 0 if they are not loaded.
    uint64_t addressOf(uint64_t offset, uint64_t size) const;
    // Reads the value that the file loads to an address.
    template <class T> T inMemory(uint64_t address) const {
        return at<T>(offsetOf(address, sizeof(T)), "its dynamic section points outside the file");
    }
    std::string textInMemory(uint64_t address) const { return text(offsetOf(address, 1), 0); }
    // Returns an empty section for a static program.
    Dynamic dynamic() const;

    // Checks the segments and returns the program in memory, with its base, bytes and span.
    Program load() const;
    // Finds the code, from the first instruction to the last, by section headers or else by whole segments.
    void findCode(Program &program) const;

private:
    uint64_t offsetOf(uint64_t address, uint64_t size) const;
};

} // namespace pack
