#include "packer/link/ways.h"

#include "packer/model/model_parameters.h"
#include "packer/pack_program.h"
#include "packer/read/elf_file.h"
#include "packer/read/programs.h"
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

// One way to link, and its result.
struct Try {
    std::string way, detail; // detail: how it was linked; or, if it was not packed, why not
    Linked linked = {};
    std::optional<ModelParameters> model = {}; // the contexts that it is packed with, if not the default ones
    uint64_t before = 0, packed = 0;           // bytes of memory, and of the file; 0 if it was not packed
};

// Fills sections with zeros, which pack to almost nothing.
void wipe(const std::string &path, const std::vector<std::string> &names) {
    Bytes bytes = readBytes(path);
    ElfFile in = {bytes};
    std::vector<Elf64_Shdr> sections = in.sections();
    for (const Elf64_Shdr &s : sections)
        if (std::count(names.begin(), names.end(), in.nameOf(sections, s)) && s.sh_type != SHT_NOBITS &&
            within(s.sh_offset, s.sh_size, 0, bytes.size()))
            std::fill_n(bytes.begin() + (long)s.sh_offset, s.sh_size, 0);
    writeBytes(path, bytes, modeOf(path));
}

void pack(Try &made) {
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

class Tries {
public:
    Tries(const LinkOptions &options, const std::string &folder)
        : options(options), folder(folder), linker(options, folder), facts(linker.linkFirst()) {
        tryWay("dynamic", [&] { tryDynamic(); });
        tryWay("imports", [&] { tryImports(); });
        tryWay("static", [&] { tryStatic(); });
        for (const Try &t : tries)
            if (t.packed && (!best || t.packed < best->packed)) best = &t;
        if (!best) throw common::Refused(tries.front().way + ": " + tries.front().detail);
    }

    void print() const {
        std::string text = "way         before   packed\n";
        for (const Try &t : tries)
            common::append(text, "%-9s%9s%9s   %s%s\n", t.way.c_str(),
                           t.packed ? common::thousands((double)t.before).c_str() : "-",
                           t.packed ? common::thousands((double)t.packed).c_str() : "-", t.detail.c_str(),
                           &t == best ? "   <- taken" : "");
        std::fputs(text.c_str(), stdout);
    }

    // Packs the best one again, with the user's options.
    void packBest() const {
        if (!options.keep.empty()) keepFiles();
        Options packing = options.packing;
        packing.in = best->linked.program;
        packing.map = best->linked.map;
        packing.symbols = namesOfIntermediate();
        packing.loader = best->way != "imports";
        packing.model = best->model;
        packProgram(packing);
    }

private:
    // Tries a way, unless another one was asked for; if it is not possible, keeps the reason.
    template <class Make> void tryWay(const char *way, Make make) {
        if (!options.way.empty() && options.way != way) return;
        try {
            make();
        } catch (const common::Refused &e) {
            tries.push_back({way, e.what()});
        }
    }

    // Packs a linked program. Returns whether that is quick enough to try variants.
    bool add(const std::string &way, const std::string &detail, const Linked &linked) {
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

    void tryDynamic() {
        for (std::string hash : {"gnu", "sysv"}) {
            Linked linked = linker.linkDynamic(facts, "dynamic-" + hash, {"-Wl,--hash-style=" + hash});
            if (!facts.exceptions) wipe(linked.program, {".eh_frame", ".note.gnu.property", ".note.ABI-tag"});
            if (!add("dynamic", "hash table of " + hash, linked)) return;
        }
    }

    void tryImports() {
        Plan plan = planImports(facts.objects, facts.program, facts.libraries);
        std::string detail = std::to_string(plan.imports.size()) + " imports";
        const struct {
            const char *name, *detail;
            Words flags;
        } kVariants[] = {
            {"imports", "", {}},
            {"imports-sorted", ", sections sorted by name", {"-Wl,--sort-section=name"}},
            {"imports-aligned", ", sections sorted by alignment", {"-Wl,--sort-section=alignment"}}};
        for (auto &variant : kVariants) {
            Linked linked = linker.linkImports(facts, plan, variant.name, variant.flags);
            wipe(linked.program, {".got.plt"}); // only a PLT would need it
            if (!add("imports", detail + variant.detail, linked)) return;
        }
    }

    void tryStatic() {
        Linked linked = linker.linkStatic(facts);
        Bytes bytes = readBytes(linked.program);
        uint64_t before = 0;
        for (const Elf64_Phdr &h : ElfProgram(bytes).loads()) before += h.p_filesz;
        for (const Try &t : tries)
            need(!t.packed || before / kHopeless <= t.packed,
                 common::thousands((double)before) + " bytes before packing: far too large");
        add("static", "with its libraries", linked);
    }

    // A file with the symbols of LTO objects, by which costs are counted; "" without them or without gcc-nm.
    std::string namesOfIntermediate() const {
        if (facts.intermediate.empty()) return "";
        Words tool = {"gcc-nm", "-A"};
        tool.insert(tool.end(), facts.intermediate.begin(), facts.intermediate.end());
        Outcome names = run(tool);
        if (names.status) return "";
        common::writeWhole(folder + "/names", names.output);
        return folder + "/names";
    }

    void keepFiles() const {
        fs::create_directories(options.keep);
        auto keep = [&](const std::string &from, const std::string &to) {
            if (fs::exists(from))
                fs::copy_file(from, options.keep + "/" + to, fs::copy_options::overwrite_existing);
        };
        bool imports = best->way == "imports";
        std::string name = imports ? "imports" : fs::path(best->linked.program).stem().string();
        keep(best->linked.program, "program.elf");
        keep(best->linked.map, "program.map");
        keep(folder + "/" + name + ".s", "start.s");
        if (imports) keep(folder + "/imports.ld", "program.ld");
    }

    const LinkOptions &options;
    std::string folder;
    Linker linker;
    Facts facts;
    std::vector<Try> tries;
    const Try *best = nullptr; // of those that are packed
};

} // namespace

void packSmallest(const LinkOptions &options, const std::string &folder) {
    Tries tries(options, folder);
    tries.print();
    tries.packBest();
}

} // namespace pack::linking
