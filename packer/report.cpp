#include "report.h"

#include "elf_file.h"

#include <cstdio>
#include <cstdlib>
#include <cxxabi.h>
#include <memory>
#include <sstream>

namespace pack {

namespace {

constexpr char kMapBegins[] = "Linker script and memory map";

// Tells the cost of any range of addresses.
class Sum {
public:
    Sum(const Program &program, const std::vector<float> &bits) : base(program.base), sums(bits.size() + 1) {
        for (size_t i = 0; i < bits.size(); ++i) sums[i + 1] = sums[i] + bits[i];
    }
    // Adds what lies at `address`; parts outside the packed bytes are zeros and cost nothing.
    void add(Cost &cost, uint64_t address, uint64_t size) const {
        uint64_t all = sums.size() - 1;
        if (address < base || address - base >= all) return;
        uint64_t from = address - base, to = std::min(all, from + std::min(size, all));
        cost.bytes += to - from;
        cost.bits += sums[to] - sums[from];
    }

private:
    uint64_t base;
    std::vector<double> sums;
};

std::string demangle(const std::string &name) {
    int status;
    std::unique_ptr<char, void (*)(void *)> plain(
        abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status), std::free);
    return plain ? plain.get() : name;
}

// A function or object, by its name as the linker knows it.
struct Symbol {
    std::string name;
    uint64_t address, size;
};

std::vector<Symbol> readElf(const std::vector<uint8_t> &elf, const Sum &sum, Report &report) {
    std::vector<Symbol> symbols;
    constexpr char kOutside[] = "its symbols lie outside the file: strip it";
    ElfFile in = {elf};
    std::vector<Elf64_Shdr> sections = in.sections();
    auto header = in.at<Elf64_Ehdr>(0, kOutside);
    for (const Elf64_Shdr &s : sections) {
        if (s.sh_flags & SHF_ALLOC && s.sh_type != SHT_NOBITS)
            sum.add(report.sections[in.text(sections[header.e_shstrndx], s.sh_name)], s.sh_addr, s.sh_size);
        if (s.sh_type != SHT_SYMTAB) continue;
        need(s.sh_link < sections.size(), kOutside);
        for (uint64_t at = 0; at + sizeof(Elf64_Sym) <= s.sh_size; at += sizeof(Elf64_Sym)) {
            auto symbol = in.at<Elf64_Sym>(s.sh_offset + at, kOutside);
            int type = ELF64_ST_TYPE(symbol.st_info);
            if (!symbol.st_size || (type != STT_FUNC && type != STT_OBJECT)) continue;
            symbols.push_back(
                {in.text(sections[s.sh_link], symbol.st_name), symbol.st_value, symbol.st_size});
            sum.add(report.symbols[demangle(symbols.back().name)], symbol.st_value, symbol.st_size);
        }
    }
    return symbols;
}

// Which object file defines a symbol, from lines "lib.a:object.o:0000000000000000 T name". Of the same name
// in several files, the first one counts.
using Homes = std::map<std::string, std::string>;
Homes readSymbols(const std::string &symbols) {
    Homes homes;
    std::istringstream lines(symbols);
    for (std::string line; std::getline(lines, line);) {
        size_t name = line.rfind(' '), to = line.rfind(':');
        if (name == std::string::npos || to == std::string::npos || to > name) continue;
        size_t from = line.find_last_of(":/", to - 1);
        from = from == std::string::npos ? 0 : from + 1;
        homes.emplace(line.substr(name + 1), line.substr(from, to - from));
    }
    return homes;
}

// Gives what lies from `address` on, in an object that the linker made when it optimised the whole, to the
// files that define it. What has no name, as constants have none, stays with that object.
void giveHome(const std::vector<Symbol> &symbols, const Homes &homes, uint64_t address, uint64_t size,
              const Sum &sum, Cost &rest, std::map<std::string, Cost> &objects) {
    for (const Symbol &s : symbols) {
        // Of name.constprop.0 the file that defines `name`
        auto home = homes.find(s.name.substr(0, s.name.find('.')));
        if (home == homes.end() || s.address < address || s.address - address >= size) continue;
        Cost cost;
        sum.add(cost, s.address, s.size);
        objects[home->second].bytes += cost.bytes;
        objects[home->second].bits += cost.bits;
        rest.bytes -= std::min(rest.bytes, cost.bytes);
        rest.bits = std::max(0.0, rest.bits - cost.bits);
    }
}

// " .text.name  0xaddress  0xsize  lib.a(object.o)", the first word on a line of its own if it is long.
void readMap(const std::string &map, const std::vector<Symbol> &symbols, const Homes &homes, const Sum &sum,
             Report &report) {
    std::istringstream lines(map.substr(std::min(map.size(), map.find(kMapBegins))));
    std::string pending;
    for (std::string line; std::getline(lines, line);) {
        if (line.size() < 2 || line[0] != ' ') continue;
        std::istringstream words(line);
        std::string section = pending, address, size, object;
        pending.clear();
        if (line[1] == '.' || line[1] == 'C') {
            words >> section;
            if (!(words >> address)) {
                pending = section;
                continue;
            }
        } else if (!(words >> address))
            continue;
        if (section.empty() || !(words >> size) || !std::getline(words >> std::ws, object)) continue;
        if (address.rfind("0x", 0) != 0 || size.rfind("0x", 0) != 0) continue;
        size_t from = object.find('('), slash = object.rfind('/');
        if (from != std::string::npos)
            object = object.substr(from + 1, object.size() - from - 2);
        else if (slash != std::string::npos)
            object = object.substr(slash + 1);
        Cost cost;
        uint64_t begin = std::strtoull(address.c_str(), nullptr, 16),
                 length = std::strtoull(size.c_str(), nullptr, 16);
        sum.add(cost, begin, length);
        if (object.find(".ltrans") != std::string::npos)
            giveHome(symbols, homes, begin, length, sum, cost, report.objects);
        if (!cost.bytes) continue;
        report.objects[object].bytes += cost.bytes;
        report.objects[object].bits += cost.bits;
    }
}

// snprintf for numbers and short words: at most 199 characters.
std::string format(const char *pattern, auto... values) {
    char line[200];
    std::snprintf(line, sizeof line, pattern, values...);
    return line;
}

std::string printCosts(const std::map<std::string, Cost> &all, const char *title, size_t most) {
    if (all.empty()) return "";
    std::vector<std::pair<std::string, Cost>> sorted(all.begin(), all.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](auto &a, auto &b) { return a.second.bits > b.second.bits; });
    if (sorted.size() > most) sorted.resize(most);
    constexpr size_t kWidth = 60;
    std::string text = format("%-60s %7s %7s\n", title, "packed", "before");
    for (auto &[name, cost] : sorted) {
        std::string label = name.substr(0, kWidth);
        if (name.size() > kWidth) label.replace(kWidth - 3, 3, "...");
        text += format("%-60s %7.0f %7llu\n", label.c_str(), cost.bits / 8, (unsigned long long)cost.bytes);
    }
    return text;
}

std::string quote(const std::string &text) {
    std::string quoted = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        if ((unsigned char)c < ' ')
            quoted += format("\\u%04x", (unsigned)c);
        else
            quoted += c;
    }
    return quoted + "\"";
}

} // namespace

bool isMap(const std::string &text) { return text.find(kMapBegins) != std::string::npos; }

Report makeReport(const std::vector<uint8_t> &elf, const std::string &map, const std::string &symbols,
                  const Program &program, const std::vector<float> &bits, size_t fileSize, size_t overhead) {
    Report report = {fileSize, overhead, {}, {}, {}};
    Sum sum(program, bits);
    std::vector<Symbol> all = readElf(elf, sum, report);
    readMap(map, all, readSymbols(symbols), sum, report);
    return report;
}

std::string printReport(const Report &report) {
    return printCosts(report.objects, "object", SIZE_MAX) +
           printCosts(report.symbols, "the 20 costliest symbols", 20);
}

std::string printJson(const Report &report) {
    std::string text = format("{\n\"file\": %zu,\n\"overhead\": %zu", report.fileSize, report.overhead);
    auto part = [&](const char *name, const std::map<std::string, Cost> &costs) {
        text += format(",\n\"%s\": {", name);
        const char *separator = "\n";
        for (auto &[key, cost] : costs) {
            text += separator + quote(key) +
                    format(": {\"bytes\": %llu, \"bits\": %.0f}", (unsigned long long)cost.bytes, cost.bits);
            separator = ",\n";
        }
        text += "\n}";
    };
    part("sections", report.sections);
    part("objects", report.objects);
    part("symbols", report.symbols);
    return text + "\n}\n";
}

} // namespace pack
