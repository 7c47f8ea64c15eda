#include "packer/link/tries.h"

#include "packer/model/model_parameters.h"
#include "packer/pack_program.h"
#include "packer/read/elf_file.h"
#include "packer/read/elf_reader.h"
#include "packer/read/loader_reader.h"
#include "packer/write/packed_file.h"
#include "tools/common/text.h"

#include <cstdio>
#include <filesystem>

namespace pack::linking {

namespace {

namespace fs = std::filesystem;

constexpr uint64_t kLarge = 300'000; // bytes; a larger program takes seconds to pack: no variants
constexpr uint64_t kSmall = 100'000; // bytes; for a smaller program four contexts are tried, too
constexpr uint64_t kHopeless = 8;    // times smaller: no program packs better than that

// Fills sections with zeros, which pack to almost nothing.
void wipe(const std::string &path, const std::vector<std::string> &names) {
    Bytes bytes = readBytes(path);
    ElfFile in = {bytes};
    std::vector<Elf64_Shdr> sections = in.sections();
    for (const Elf64_Shdr &s : sections)
        for (const std::string &name : names)
            if (in.nameOf(sections, s) == name && s.sh_type != SHT_NOBITS &&
                within(s.sh_offset, s.sh_size, 0, bytes.size()))
                std::fill_n(bytes.begin() + (long)s.sh_offset, s.sh_size, 0);
    writeBytes(path, bytes, true);
}

// The bytes that a program takes before it is packed.
uint64_t sizeInFile(const std::string &path) {
    Bytes bytes = readBytes(path);
    uint64_t size = 0;
    for (const Elf64_Phdr &h : ElfProgram(bytes).loads()) size += h.p_filesz;
    return size;
}

} // namespace

void Tries::pack(Try &made) const {
    Bytes file = readBytes(made.linked.program);
    bool imports = made.way == "imports";
    try {
        Program program = imports ? readProgram(file) : readAnyProgram(file);
        made.before = program.bytes.size();
        made.packed =
            makePacked(imports ? kElf : kLoader, program, made.model.value_or(defaultParameters()), {})
                .bytes.size();
    } catch (const common::Refused &e) {
        made.detail = e.what();
    }
}

bool Tries::add(const std::string &way, const std::string &detail, const Linked &linked) {
    for (const Try &t : tries) // equal, for example where there is nothing to sort
        if (t.packed && readBytes(t.linked.program) == readBytes(linked.program)) return true;
    Try made = {way, detail, linked, options.packing.model};
    pack(made);
    if (way == "imports" && !made.model && made.packed && made.before <= kSmall) {
        Try small = made;
        small.model = tinyParameters();
        small.detail += ", four contexts";
        pack(small);
        if (small.packed < made.packed) made = small;
    }
    tries.push_back(made);
    return made.before <= kLarge;
}

void Tries::tryWay(const char *way, void (Tries::*make)()) {
    if (!options.way.empty() && options.way != way) return;
    try {
        (this->*make)();
    } catch (const common::Refused &e) {
        tries.push_back({way, e.what()});
    }
}

void Tries::tryDynamic() {
    for (const char *hash : {"gnu", "sysv"}) {
        std::string name = std::string("dynamic-") + hash;
        Linked linked = linker.linkDynamic(facts, name, {"-Wl,--hash-style=" + std::string(hash)});
        if (!facts.exceptions) wipe(linked.program, {".eh_frame", ".note.gnu.property", ".note.ABI-tag"});
        if (!add("dynamic", std::string("hash table of ") + hash, linked)) return;
    }
}

void Tries::tryImports() {
    Plan plan = planImports(facts.objects, facts.program, facts.libraries);
    std::string detail = std::to_string(plan.imports.size()) + " imports";
    const struct {
        const char *name, *detail;
        Words flags;
    } kVariants[] = {{"imports", "", {}},
                     {"imports-sorted", ", sections sorted by name", {"-Wl,--sort-section=name"}},
                     {"imports-aligned", ", sections sorted by alignment", {"-Wl,--sort-section=alignment"}}};
    for (auto &variant : kVariants) {
        Linked linked = linker.linkImports(facts, plan, variant.name, variant.flags);
        wipe(linked.program, {".got.plt"}); // only a PLT would need it
        if (!add("imports", detail + variant.detail, linked)) return;
    }
}

void Tries::tryStatic() {
    Linked linked = linker.linkStatic(facts);
    uint64_t before = sizeInFile(linked.program), least = UINT64_MAX;
    for (const Try &t : tries)
        if (t.packed) least = std::min(least, t.packed);
    need(least == UINT64_MAX || before / kHopeless <= least,
         common::thousands((double)before) + " bytes before packing: far too large");
    add("static", "with its libraries", linked);
}

void Tries::run() {
    facts = linker.linkFirst();
    tryWay("dynamic", &Tries::tryDynamic);
    tryWay("imports", &Tries::tryImports);
    tryWay("static", &Tries::tryStatic);
    for (const Try &t : tries)
        if (t.packed) return;
    throw common::Refused(tries.front().way + ": " + tries.front().detail);
}

const Try &Tries::best() const {
    const Try *best = nullptr;
    for (const Try &t : tries)
        if (t.packed && (!best || t.packed < best->packed)) best = &t;
    return *best;
}

std::string Tries::print() const {
    std::string text = "way         before   packed\n";
    for (const Try &t : tries)
        common::append(text, "%-9s%9s%9s   %s%s\n", t.way.c_str(),
                       t.packed ? common::thousands((double)t.before).c_str() : "-",
                       t.packed ? common::thousands((double)t.packed).c_str() : "-", t.detail.c_str(),
                       &t == &best() ? "   <- taken" : "");
    return text;
}

// A file with the symbols of LTO objects; "" without them or without gcc-nm.
std::string Tries::namesOfIntermediate() const {
    if (facts.intermediate.empty()) return "";
    Words tool = {"gcc-nm", "-A"};
    tool.insert(tool.end(), facts.intermediate.begin(), facts.intermediate.end());
    Outcome names = pack::run(tool);
    if (names.status) return "";
    common::writeWhole(folder + "/names", names.output);
    return folder + "/names";
}

void Tries::keepFiles(const Try &taken) const {
    fs::create_directories(options.keep);
    auto keep = [&](const std::string &from, const std::string &to) {
        if (fs::exists(from))
            fs::copy_file(from, options.keep + "/" + to, fs::copy_options::overwrite_existing);
    };
    bool imports = taken.way == "imports";
    std::string name = imports ? "imports" : fs::path(taken.linked.program).stem().string();
    keep(taken.linked.program, "program.elf");
    keep(taken.linked.map, "program.map");
    keep(folder + "/" + name + ".s", "start.s");
    if (imports) keep(folder + "/imports.ld", "program.ld");
}

void Tries::finish() const {
    const Try &taken = best();
    if (!options.keep.empty()) keepFiles(taken);
    Options packing = options.packing;
    packing.in = taken.linked.program;
    packing.map = taken.linked.map;
    packing.symbols = namesOfIntermediate();
    packing.loader = taken.way != "imports";
    packing.model = taken.model;
    packProgram(packing);
}

} // namespace pack::linking
