#include "maker/symbols.h"

#include <cstdlib>
#include <cstring>
#include <cxxabi.h>
#include <elf.h>
#include <fstream>
#include <iterator>

namespace odraz {

namespace {

std::string plainName(const char *mangled) {
    int status;
    char *whole = abi::__cxa_demangle(mangled, nullptr, nullptr, &status);
    std::string name = whole ? whole : mangled;
    std::free(whole);
    size_t colons = name.rfind("::");
    return colons == name.npos ? name : name.substr(colons + 2);
}

template <class T> const T *part(const std::string &bytes, size_t at, size_t count) {
    bool inside = at <= bytes.size() && count <= (bytes.size() - at) / sizeof(T) && at % alignof(T) == 0;
    return inside ? (const T *)(bytes.data() + at) : nullptr;
}

} // namespace

std::vector<Symbol> readSymbols(const std::string &file, const std::string &known, const void *address) {
    std::ifstream in(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    auto *header = part<Elf64_Ehdr>(bytes, 0, 1);
    if (!header || std::memcmp(header->e_ident, ELFMAG, SELFMAG)) return {};
    auto *sections = part<Elf64_Shdr>(bytes, header->e_shoff, header->e_shnum);
    std::vector<Symbol> found;
    uint64_t knownAt = 0;
    for (int i = 0; sections && i < header->e_shnum; ++i) {
        const Elf64_Shdr &s = sections[i];
        if (s.sh_type != SHT_SYMTAB || s.sh_link >= header->e_shnum) continue;
        size_t count = s.sh_size / sizeof(Elf64_Sym), names = sections[s.sh_link].sh_offset;
        auto *symbols = part<Elf64_Sym>(bytes, s.sh_offset, count);
        std::string source; // stands in front of its symbols
        for (size_t k = 0; symbols && k < count; ++k) {
            if (names + symbols[k].st_name >= bytes.size()) return {};
            const char *name = bytes.c_str() + names + symbols[k].st_name;
            if (ELF64_ST_TYPE(symbols[k].st_info) == STT_FILE) source = name;
            if (name == known) knownAt = symbols[k].st_value;
            if (ELF64_ST_TYPE(symbols[k].st_info) == STT_OBJECT && symbols[k].st_size)
                found.push_back({(const char *)symbols[k].st_value, symbols[k].st_size, plainName(name),
                                 ELF64_ST_BIND(symbols[k].st_info) == STB_LOCAL ? source : ""});
        }
    }
    if (!knownAt) return {};
    for (Symbol &s : found) s.at = (const char *)address - knownAt + (uintptr_t)s.at;
    return found;
}

const Symbol *symbolOf(const std::vector<Symbol> &symbols, const Table &table, int &element) {
    auto *at = (const char *)table.keys;
    size_t one = (size_t)table.count * (table.camera ? sizeof(CameraKey) : sizeof(Key));
    for (const Symbol &s : symbols) {
        if (at < s.at || at >= s.at + s.size) continue;
        element = one < s.size ? (int)((size_t)(at - s.at) / one) : -1;
        return &s;
    }
    return nullptr;
}

} // namespace odraz
