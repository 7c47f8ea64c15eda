#include "packer/report/attribution.h"

#include "packer/read/elf_file.h"

#include <cstdlib>
#include <cxxabi.h>
#include <map>
#include <memory>
#include <queue>
#include <sstream>

namespace pack {

namespace {

constexpr char kMapBegins[] = "Linker script and memory map";
constexpr uint64_t kMostSymbolBytes = 1ull << 40; // larger values make no sense

std::string demangle(const std::string &name) {
    if (name.rfind("_Z", 0) != 0) return name; // else a C function i would become "int"
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

// Sections, functions and objects, by the linker's names.
void readElf(const Bytes &elf, std::vector<Claim> &names, std::vector<Claim> &symbols) {
    constexpr char kOutside[] = "its symbols lie outside the file: strip it";
    ElfFile in = {elf};
    std::vector<Elf64_Shdr> sections = in.sections();
    for (const Elf64_Shdr &s : sections) {
        if (s.sh_flags & SHF_ALLOC && s.sh_type != SHT_NOBITS)
            add(names, s.sh_addr, s.sh_size, in.nameOf(sections, s));
        if (s.sh_type != SHT_SYMTAB) continue;
        need(s.sh_link < sections.size(), kOutside);
        for (const Elf64_Sym &symbol : in.table<Elf64_Sym>(s, kOutside)) {
            int type = ELF64_ST_TYPE(symbol.st_info);
            if (type == STT_FUNC || type == STT_OBJECT || type == STT_GNU_IFUNC)
                add(symbols, symbol.st_value, symbol.st_size, in.text(sections[s.sh_link], symbol.st_name));
        }
    }
}

// Which object file defines a symbol, from lines "lib.a:object.o:0000000000000000 T name". Of the same name
// in several files, the first one counts.
using Homes = std::map<std::string, Home>;
Homes readSymbols(const std::string &symbols) {
    Homes homes;
    std::istringstream lines(symbols);
    for (std::string line; std::getline(lines, line);) {
        size_t name = line.rfind(' '), to = line.rfind(':');
        if (name == std::string::npos || to == std::string::npos || to > name) continue;
        std::string path = line.substr(0, to);
        size_t member = path.find(".a:");
        if (member != std::string::npos)
            path = path.substr(0, member + 2) + "(" + path.substr(member + 3) + ")";
        homes.emplace(line.substr(name + 1), homeOf(path));
    }
    return homes;
}

// " .text.name  0xaddress  0xsize  lib.a(object.o)", the first word on a separate line if it is long.
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
        Home home = homeOf(path);
        if (isWholeProgram(home.object)) home = {kWholeProgram, kNothingNamed};
        add(objects, std::strtoull(address.c_str(), nullptr, 16), std::strtoull(size.c_str(), nullptr, 16),
            home.object, home.room);
    }
    return objects;
}

// Goes through exclusive claims in order of address.
class Cursor {
public:
    explicit Cursor(const std::vector<Claim> &claims) : at(claims.data()), end(at + claims.size()) {}
    // The claim that holds `address`, or null. Addresses must not become smaller.
    const Claim *operator()(uint64_t address) {
        while (at != end && at->end <= address) ++at;
        return at != end && at->begin <= address ? at : nullptr;
    }

private:
    const Claim *at, *end;
};

// The addresses in the program where a claim begins or ends, and the program's own ends.
std::vector<uint64_t> boundaries(uint64_t base, uint64_t end,
                                 std::initializer_list<const std::vector<Claim> *> lists) {
    std::vector<uint64_t> all = {base, end};
    for (const std::vector<Claim> *list : lists)
        for (const Claim &c : *list)
            for (uint64_t address : {c.begin, c.end})
                if (address > base && address < end) all.push_back(address);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

std::string sectionWithout(const std::vector<Claim> &sections, const Program &program, uint64_t offset) {
    if (sections.empty())
        return offset - program.codeBegin < program.codeSize ? "(instructions)" : "(no section)";
    return program.base + offset < sections.front().begin ? "(headers)" : "(between sections)";
}

} // namespace

std::vector<Claim> exclusive(std::vector<Claim> claims) {
    std::sort(claims.begin(), claims.end(), [](const Claim &a, const Claim &b) { return a.begin < b.begin; });
    std::vector<uint64_t> edges = boundaries(0, UINT64_MAX, {&claims});
    // Claims that have begun, the one that wins on top
    auto later = [&](size_t i, size_t j) {
        const Claim &a = claims[i], &b = claims[j];
        if (a.begin != b.begin) return a.begin < b.begin;
        if (a.end != b.end) return a.end > b.end;
        return a.name > b.name;
    };
    std::priority_queue<size_t, std::vector<size_t>, decltype(later)> begun(later);
    std::vector<Claim> result;
    size_t next = 0, last = SIZE_MAX;
    for (size_t e = 0; e + 1 < edges.size(); ++e) {
        while (next < claims.size() && claims[next].begin <= edges[e]) begun.push(next++);
        while (!begun.empty() && claims[begun.top()].end <= edges[e]) begun.pop();
        if (begun.empty()) {
            last = SIZE_MAX;
            continue;
        }
        if (begun.top() == last)
            result.back().end = edges[e + 1];
        else {
            last = begun.top();
            result.push_back({edges[e], edges[e + 1], claims[last].name, claims[last].room});
        }
    }
    return result;
}

Home homeOf(const std::string &path) {
    auto folderAndName = [](const std::string &p) {
        size_t slash = p.rfind('/');
        return slash == std::string::npos ? Home{p, "."} : Home{p.substr(slash + 1), p.substr(0, slash)};
    };
    size_t member = path.rfind('(');
    if (member == std::string::npos || path.back() != ')') return folderAndName(path);
    return {path.substr(member + 1, path.size() - member - 2), folderAndName(path.substr(0, member)).object};
}

bool isMap(const std::string &text) { return text.find(kMapBegins) != std::string::npos; }

std::vector<Stretch> attribute(const Bytes &elf, const std::string &map, const std::string &symbols,
                               const Program &program) {
    std::vector<Claim> sections, functions, objects = exclusive(readMap(map));
    readElf(elf, sections, functions);
    sections = exclusive(sections);
    functions = exclusive(functions);
    Homes homes = readSymbols(symbols);
    Cursor section(sections), function(functions), object(objects);
    std::vector<uint64_t> edges =
        boundaries(program.base, program.base + program.bytes.size(), {&sections, &functions, &objects});
    std::vector<Stretch> stretches;
    for (size_t e = 0; e + 1 < edges.size(); ++e) {
        uint64_t at = edges[e];
        const Claim *s = section(at), *f = function(at), *o = object(at);
        Stretch stretch = {(uint32_t)(at - program.base), (uint32_t)(edges[e + 1] - at), "", "", "", ""};
        stretch.section = s ? s->name : sectionWithout(sections, program, at - program.base);
        std::string nothing = "(nothing named in " + stretch.section + ")";
        stretch.symbol = f ? demangle(f->name) : nothing;
        if (!objects.empty()) {
            stretch.object = o ? o->name : nothing;
            stretch.room = o ? o->room : kNothingNamed;
        }
        if (o && o->name == kWholeProgram && f) {
            // name.constprop.0 belongs to the file that defines `name`
            auto home = homes.find(f->name.substr(0, f->name.find('.')));
            if (home != homes.end()) {
                stretch.object = home->second.object;
                stretch.room = home->second.room;
            }
        }
        stretches.push_back(std::move(stretch));
    }
    return stretches;
}

} // namespace pack
