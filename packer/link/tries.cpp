#include "packer/link/tries.h"

#include "packer/link/small_model.h"
#include "packer/read/elf_file.h"
#include "tools/common/arguments.h"

#include <cstdio>
#include <filesystem>

namespace pack::linking {

namespace {

namespace fs = std::filesystem;

constexpr uint64_t kLarge = 300'000; // bytes of a program that takes seconds to pack: no variants
constexpr uint64_t kSmall = 100'000; // ... that may do with fewer contexts
constexpr uint64_t kHopeless = 8;    // no way is that many times larger before and smaller after

// Fills sections with zeros, which cost next to nothing.
void wipe(const std::string &path, const std::vector<std::string> &names) {
    Bytes bytes = readBytes(path);
    ElfFile in = {bytes};
    std::vector<Elf64_Shdr> sections = in.sections();
    for (const Elf64_Shdr &s : sections)
        for (const std::string &name : names)
            if (in.text(sections[in.at<Elf64_Ehdr>(0, "cut short").e_shstrndx], s.sh_name) == name &&
                s.sh_type != SHT_NOBITS && within(s.sh_offset, s.sh_size, 0, bytes.size()))
                std::fill_n(bytes.begin() + (long)s.sh_offset, s.sh_size, 0);
    writeBytes(path, bytes, true);
}

bool sameBytes(const std::string &a, const std::string &b) { return readBytes(a) == readBytes(b); }

// "12345" as "12,345".
std::string grouped(uint64_t number) {
    std::string text = std::to_string(number);
    for (int at = (int)text.size() - 3; at > 0; at -= 3) text.insert((size_t)at, ",");
    return text;
}
std::string padded(const std::string &text, size_t width) {
    return std::string(width > text.size() ? width - text.size() : 0, ' ') + text;
}

// The bytes that a program takes before it is packed.
uint64_t sizeInFile(const std::string &path) {
    Bytes bytes = readBytes(path);
    Elf64_Ehdr header;
    uint64_t size = 0;
    for (const Elf64_Phdr &h : ElfFile{bytes}.programHeaders(header))
        if (h.p_type == PT_LOAD) size += h.p_filesz;
    return size;
}

} // namespace

bool Tries::again(uint64_t before) const { return before <= kLarge; }

void Tries::pack(Try &made) const {
    std::string to = folder + "/try";
    Words words = {packer, made.linked.program, "-o", to, "--budget", "none"};
    if (made.way != "imports") words.push_back("--loader");
    words.insert(words.end(), made.model.begin(), made.model.end());
    Outcome outcome = runKept(words, options.tell);
    // "FILE: 3332 bytes (3149 of them stub and headers) from 4416"
    size_t last = outcome.said.rfind(to + ": ");
    unsigned long packed, overhead, before;
    if (outcome.status || last == std::string::npos ||
        std::sscanf(outcome.said.c_str() + last + to.size(),
                    ": %lu bytes (%lu of them stub and headers) from %lu", &packed, &overhead,
                    &before) != 3) {
        made.detail = outcome.said.substr(0, outcome.said.find('\n'));
        size_t colon = made.detail.rfind(made.linked.program + ": ");
        if (colon != std::string::npos) made.detail.erase(0, colon + made.linked.program.size() + 2);
        return;
    }
    made.packed = packed;
    made.overhead = overhead;
    made.before = before;
}

void Tries::add(const std::string &way, const std::string &detail, const Linked &linked) {
    for (const Try &t : tries) // where there is nothing to sort, say
        if (t.isPacked() && sameBytes(t.linked.program, linked.program)) return;
    Try made;
    made.way = way;
    made.detail = detail;
    made.linked = linked;
    made.model = options.model;
    pack(made);
    if (way == "imports" && options.model.empty() && made.isPacked() && made.before <= kSmall) {
        std::string model = folder + "/small.model";
        common::writeWhole(model, kSmallModel);
        Try small = made;
        small.model = {"--model", model};
        small.detail += ", four contexts";
        pack(small);
        if (small.isPacked() && small.packed < made.packed) made = small;
    }
    tries.push_back(made);
}
void Tries::addFailed(const std::string &way, const std::string &why) {
    Try failed;
    failed.way = way;
    failed.detail = why;
    tries.push_back(failed);
}

void Tries::tryDynamic() {
    try {
        for (const char *hash : {"gnu", "sysv"}) {
            std::string name = std::string("dynamic-") + hash;
            Linked linked = linker.linkDynamic(facts, name, {"-Wl,--hash-style=" + std::string(hash)});
            if (!facts.exceptions) wipe(linked.program, {".eh_frame", ".note.gnu.property", ".note.ABI-tag"});
            add("dynamic", std::string("hash table of ") + hash, linked);
            if (!again(tries.back().before)) return;
        }
    } catch (const common::Refused &e) {
        addFailed("dynamic", e.what());
    }
}

void Tries::tryImports() {
    try {
        Plan plan = planImports(facts.objects, facts.program, facts.libraries);
        std::string detail = std::to_string(plan.imports.size()) + " imports";
        const struct {
            const char *name, *says;
            Words flags;
        } kVariants[] = {
            {"imports", "", {}},
            {"imports-sorted", ", sections sorted by name", {"-Wl,--sort-section=name"}},
            {"imports-aligned", ", sections sorted by alignment", {"-Wl,--sort-section=alignment"}}};
        for (auto &variant : kVariants) {
            Linked linked = linker.linkImports(facts, plan, variant.name, variant.flags);
            wipe(linked.program, {".got.plt"}); // what a PLT needs, which there is none of
            add("imports", detail + variant.says, linked);
            if (!again(tries.back().before)) return;
        }
    } catch (const common::Refused &e) {
        addFailed("imports", e.what());
    }
}

void Tries::tryStatic() {
    try {
        Linked linked = linker.linkStatic(facts);
        uint64_t before = sizeInFile(linked.program), least = UINT64_MAX;
        for (const Try &t : tries)
            if (t.isPacked()) least = std::min(least, t.packed);
        if (least != UINT64_MAX && before / kHopeless > least)
            return addFailed("static", grouped(before) + " bytes before packing: far too large");
        add("static", "with its libraries", linked);
    } catch (const common::Refused &e) {
        addFailed("static", e.what());
    }
}

void Tries::run() {
    facts = linker.linkFirst();
    if (asked("dynamic")) tryDynamic();
    if (asked("imports")) tryImports();
    if (asked("static")) tryStatic();
    for (const Try &t : tries)
        if (t.isPacked()) return;
    throw common::Refused(tries.front().way + ": " + tries.front().detail);
}

const Try &Tries::best() const {
    const Try *best = nullptr;
    for (const Try &t : tries)
        if (t.isPacked() && (!best || t.packed < best->packed)) best = &t;
    return *best;
}

std::string Tries::print() const {
    std::string text = "way         before   packed\n";
    const Try &taken = best();
    for (const Try &t : tries) {
        text += t.way + std::string(9 - t.way.size(), ' ');
        if (t.isPacked())
            text += padded(grouped(t.before), 9) + padded(grouped(t.packed), 9) + "   " + t.detail +
                    (&t == &taken ? "   <- taken" : "") + "\n";
        else
            text += padded("-", 9) + padded("-", 9) + "   " + t.detail + "\n";
    }
    return text;
}

// What pack's report needs to tell which file a function comes from that -flto made: words for pack, none if
// there is no such program as gcc-nm.
Words Tries::namesOfIntermediate() const {
    if (facts.intermediate.empty()) return {};
    Words tool = {"gcc-nm", "-A"};
    tool.insert(tool.end(), facts.intermediate.begin(), facts.intermediate.end());
    try {
        Outcome names = runKept(tool, options.tell);
        std::string to = folder + "/names";
        if (!names.status) {
            common::writeWhole(to, names.said);
            return {"--symbols", to};
        }
    } catch (const common::Refused &) {
    }
    return {};
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

int Tries::finish() const {
    const Try &taken = best();
    if (!options.keep.empty()) keepFiles(taken);
    Words words = {packer, taken.linked.program, "-o", options.out, "--map", taken.linked.map};
    if (taken.way != "imports") words.push_back("--loader");
    if (!options.budget) words.insert(words.end(), {"--budget", "none"});
    for (const Words &more : {namesOfIntermediate(), taken.model, options.packing})
        words.insert(words.end(), more.begin(), more.end());
    return runShown(words, options.tell).status;
}

} // namespace pack::linking
