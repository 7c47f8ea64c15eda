#include "packer/report/attribution.h"

#include "packer/read/elf_file.h"

#include <cstdlib>
#include <cxxabi.h>
#include <map>
#include <memory>
#include <sstream>
#include <tuple>

namespace pack {

namespace {

constexpr char kMapBegins[] = "Linker script and memory map";
constexpr uint64_t kMostSymbolBytes = 1ull << 40; // larger sizes and addresses are wrong

std::string demangle(const std::string &name) {
    if (name.rfind("_Z", 0) != 0) return name; // otherwise a C function named i would become "int"
    int status;
    std::unique_ptr<char, void (*)(void *)> plain(
        abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status), std::free);
    return plain ? plain.get() : name;
}

void add(std::vector<Claim> &claims, uint64_t address, uint64_t size, std::string name,
         std::string room = "") {
    if (size && size < kMostSymbolBytes && address < kMostSymbolBytes)
        claims.push_back({address, address + size, std::move(name), std::move(room)});
}

// Reads the claims of the sections to `names`, and the claims of functions and variables to `symbols`.
void readElf(const Bytes &elf, std::vector<Claim> &names, std::vector<Claim> &symbols) {
    constexpr char kOutside[] = "its symbols are outside the file: strip it";
    ElfFile in = {elf};
    std::vector<Elf64_Shdr> sections = in.sections();
    for (const Elf64_Shdr &s : sections) {
        if (s.sh_flags & SHF_ALLOC && s.sh_type != SHT_NOBITS)
            add(names, s.sh_addr, s.sh_size, in.nameOf(sections, s));
        if (s.sh_type != SHT_SYMTAB) continue;
        need(s.sh_link < sections.size(), kOutside);
        for (const Elf64_Sym &symbol :
             in.table<Elf64_Sym>(s.sh_offset, s.sh_size / sizeof(Elf64_Sym), kOutside)) {
            int type = ELF64_ST_TYPE(symbol.st_info);
            if (type == STT_FUNC || type == STT_OBJECT || type == STT_GNU_IFUNC)
                add(symbols, symbol.st_value, symbol.st_size, in.text(sections[s.sh_link], symbol.st_name));
        }
    }
}

// Reads the first file that defines each symbol, from lines "lib.a:object.o:0000000000000000 T name".
using Origins = std::map<std::string, Origin>;
Origins readSymbols(const std::string &symbols) {
    Origins origins;
    std::istringstream lines(symbols);
    for (std::string line; std::getline(lines, line);) {
        size_t name = line.rfind(' '), to = line.rfind(':');
        if (name == std::string::npos || to == std::string::npos || to > name) continue;
        std::string path = line.substr(0, to);
        size_t member = path.find(".a:");
        if (member != std::string::npos)
            path = path.substr(0, member + 2) + "(" + path.substr(member + 3) + ")";
        origins.emplace(line.substr(name + 1), originOf(path));
    }
    return origins;
}

// Reads lines " .text.name  0xaddress  0xsize  lib.a(object.o)". A long first word has its own line.
std::vector<Claim> readMap(const std::string &map) {
    std::vector<Claim> objects;
    std::istringstream lines(map.substr(std::min(map.size(), map.find(kMapBegins))));
    std::string pending;
    for (std::string line; std::getline(lines, line);) {
        if (line.size() < 2 || line[0] != ' ') continue;
        std::istringstream words(line);
        std::string section = pending, address, size, path;
        pending.clear();
        if (line[1] == '.' || line[1] == 'C') {
            words >> section;
            if (!(words >> address)) {
                pending = section;
                continue;
            }
        } else if (!(words >> address))
            continue;
        if (section.empty() || !(words >> size) || !std::getline(words >> std::ws, path)) continue;
        if (address.rfind("0x", 0) != 0 || size.rfind("0x", 0) != 0) continue;
        Origin origin = originOf(path);
        if (isWholeProgram(origin.object)) origin = {kWholeProgram, kNothingNamed};
        add(objects, std::strtoull(address.c_str(), nullptr, 16), std::strtoull(size.c_str(), nullptr, 16),
            origin.object, origin.room);
    }
    return objects;
}

std::string noSection(const std::vector<Claim> &sections, const Program &program, uint64_t offset) {
    if (sections.empty())
        return offset - program.codeBegin < program.codeSize ? "(instructions)" : "(no section)";
    return program.base + offset < sections.front().begin ? "(headers)" : "(between sections)";
}

} // namespace

std::vector<uint32_t> assignClaims(std::vector<Claim> &claims, uint64_t base, size_t size) {
    std::sort(claims.begin(), claims.end(), [](const Claim &a, const Claim &b) {
        return std::tie(a.begin, b.end, b.name) < std::tie(b.begin, a.end, a.name);
    });
    std::vector<uint32_t> claimOf(size, kUnclaimed);
    for (uint32_t i = 0; i < claims.size(); ++i) {
        uint64_t begin = std::max(claims[i].begin, base), end = std::min(claims[i].end, base + size);
        if (begin < end) std::fill_n(claimOf.begin() + (long)(begin - base), end - begin, i);
    }
    return claimOf;
}

Origin originOf(const std::string &path) {
    auto folderAndName = [](const std::string &p) {
        size_t slash = p.rfind('/');
        return slash == std::string::npos ? Origin{p, "."} : Origin{p.substr(slash + 1), p.substr(0, slash)};
    };
    size_t member = path.rfind('(');
    if (member == std::string::npos || path.back() != ')') return folderAndName(path);
    return {path.substr(member + 1, path.size() - member - 2), folderAndName(path.substr(0, member)).object};
}

bool isMap(const std::string &text) { return text.find(kMapBegins) != std::string::npos; }

std::vector<Stretch> attribute(const Bytes &elf, const std::string &map, const std::string &symbols,
                               const Program &program) {
    std::vector<Claim> sections, functions, objects = readMap(map);
    readElf(elf, sections, functions);
    Origins origins = readSymbols(symbols);
    size_t size = program.bytes.size();
    std::vector<uint32_t> section = assignClaims(sections, program.base, size),
                          function = assignClaims(functions, program.base, size),
                          object = assignClaims(objects, program.base, size);
    auto claim = [](const std::vector<Claim> &claims, uint32_t i) {
        return i == kUnclaimed ? nullptr : &claims[i];
    };
    std::vector<Stretch> stretches;
    for (uint32_t at = 0; at < size; ++at) {
        if (at && section[at] == section[at - 1] && function[at] == function[at - 1] &&
            object[at] == object[at - 1]) {
            ++stretches.back().size;
            continue;
        }
        const Claim *s = claim(sections, section[at]), *f = claim(functions, function[at]),
                    *o = claim(objects, object[at]);
        Stretch stretch = {at, 1, "", "", "", ""};
        stretch.section = s ? s->name : noSection(sections, program, at);
        std::string nothing = "(nothing named in " + stretch.section + ")";
        stretch.symbol = f ? demangle(f->name) : nothing;
        if (!objects.empty()) {
            stretch.object = o ? o->name : nothing;
            stretch.room = o ? o->room : kNothingNamed;
        }
        if (o && o->name == kWholeProgram && f) {
            // name.constprop.0 belongs to the file that defines `name`
            auto origin = origins.find(f->name.substr(0, f->name.find('.')));
            if (origin != origins.end()) {
                stretch.object = origin->second.object;
                stretch.room = origin->second.room;
            }
        }
        stretches.push_back(std::move(stretch));
    }
    return stretches;
}

} // namespace pack
