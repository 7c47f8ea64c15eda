#include "packer/link/linker.h"

#include "packer/link/start.h"
#include "packer/read/program.h"

#include <algorithm>
#include <filesystem>

namespace pack::linking {

namespace {

namespace fs = std::filesystem;

// Leave out everything that a packed program can do without
const Words kLean = {"-no-pie",
                     "-Wl,--gc-sections,--as-needed,-O1,--build-id=none,--no-ld-generated-unwind-info",
                     "-Wl,-z,norelro,-z,noseparate-code,-z,noexecstack"};

void add(Words &to, const Words &more) { to.insert(to.end(), more.begin(), more.end()); }

bool isInput(const std::string &word) { return word[0] != '-' && fs::exists(word); }

bool holdsObjects(const std::string &path) {
    FileKind kind = kindOf(path);
    return kind == FileKind::kObject || kind == FileKind::kArchive || kind == FileKind::kBitcode;
}

// Read from the inputs before the first link, to choose the compiler.
struct Given {
    Code code = Code::kMachine;
    bool cpp = false; // gcc's LTO objects do not show it: they are linked as C++
};
Given lookAhead(const Words &inputs) {
    Given given;
    for (const std::string &word : inputs) {
        if (!isInput(word) || !holdsObjects(word)) continue;
        for (const Object &object : readObjects(word)) {
            if (object.code == Code::kGcc || object.code == Code::kClang) given.code = object.code;
            for (const Reference &r : object.references)
                given.cpp |= r.symbol.rfind("_Z", 0) == 0 || r.symbol.rfind("__cxa_", 0) == 0 ||
                             r.symbol.rfind("__gxx_", 0) == 0;
        }
    }
    return given;
}
std::string compilerFor(const Given &given) {
    if (given.code == Code::kClang) return "clang++";
    return given.cpp || given.code == Code::kGcc ? "c++" : "cc";
}

// Replaces the first LTO object by the LTO output and drops the others.
Words replaceIntermediate(const Words &inputs, const Words &intermediate, const Words &compiled) {
    Words replaced;
    bool done = false;
    for (const std::string &word : inputs) {
        if (std::find(intermediate.begin(), intermediate.end(), word) == intermediate.end())
            replaced.push_back(word);
        else if (!done) {
            add(replaced, compiled);
            done = true;
        }
    }
    return replaced;
}

// Adds a file of the link to the objects, archives or libraries.
void takeFile(const std::string &path, const Taken &taken, bool optimised, Facts &facts) {
    FileKind kind = kindOf(path);
    if (kind == FileKind::kLibrary) facts.libraries.push_back(readDynamic(path));
    if (!holdsObjects(path)) return;
    bool any = false;
    for (Object &object : readObjects(path)) {
        if (kind == FileKind::kArchive && !taken.members.count({object.path, object.member})) continue;
        any = true;
        bool machine = object.code == Code::kMachine || (object.code == Code::kGcc && !optimised);
        if (machine)
            facts.objects.push_back(std::move(object));
        else if (kind != FileKind::kArchive)
            facts.intermediate.push_back(path);
    }
    if (any && kind == FileKind::kArchive) facts.archives.push_back(path);
}

// Keeps the libraries that the program needs, in the order in which ld.so searches them.
void orderLibraries(Facts &facts) {
    std::vector<DynamicFile> needed;
    for (const std::string &name : facts.program.needed)
        for (const DynamicFile &library : facts.libraries)
            if (library.soname == name) {
                needed.push_back(library);
                break;
            }
    facts.libraries = std::move(needed);
}

// glibc 2.34 runs a program's constructors without help from crt1; it was the first with dlopen in libc.
bool canStart(const std::vector<DynamicFile> &libraries) {
    return std::any_of(libraries.begin(), libraries.end(), [](const DynamicFile &library) {
        return library.soname == "libc.so.6" && library.symbols.count("dlopen");
    });
}

} // namespace

Linker::Linker(const LinkOptions &options, const std::string &folder) : options(options), folder(folder) {
    Given given = lookAhead(options.inputs);
    code = given.code;
    compiler = options.compiler.empty() ? compilerFor(given) : options.compiler;
}

Words Linker::command(const Linked &to, const Words &flags) const {
    Words words = {compiler, "-o", to.program, "-Wl,-Map=" + to.map};
    add(words, kLean);
    add(words, flags);
    return words;
}

void Linker::link(const Words &words, bool isStatic) const {
    std::string line;
    for (const std::string &word : words) line += (line.empty() ? "" : " ") + word;
    if (options.verbose) std::fprintf(stderr, "%s\n", line.c_str());
    Outcome outcome = run(words);
    need(outcome.status != 127,
         "cannot run " + words[0] + ": install gcc or clang, or name a compiler with --cc");
    need(!outcome.status, explainLink(outcome.output, isStatic));
}

std::string Linker::assemble(const std::string &name, const std::string &source) const {
    common::writeWhole(file(name + ".s"), source);
    link({compiler, "-c", file(name + ".s"), "-o", file(name + ".o")});
    return file(name + ".o");
}

Facts Linker::linkFirst() {
    Linked to = linked("first");
    // Keep the LTO output, which the later links use
    std::string optimised = file("program.ltrans.o"), start = assemble("start", startDynamic(true));
    Words words = command(to, {"-nostartfiles", start});
    if (code == Code::kClang) add(words, {"-flto", "-Wl,-plugin-opt,obj-path=" + optimised});
    if (code == Code::kGcc) add(words, {"-flto-partition=one", "-save-temps"});
    add(words, options.inputs);
    link(words);

    Facts facts = {};
    Taken taken = readLinkerMap(common::readWhole(to.map));
    if (taken.files.empty())
        throw common::Refused("the linker's map is not that of GNU ld: leave -fuse-ld out");
    Words compiled;
    for (const std::string &path : taken.files)
        if (path.rfind(folder, 0) == 0 && path.find(".ltrans") != std::string::npos) compiled.push_back(path);
    for (const std::string &path : taken.files)
        if (path != start) takeFile(path, taken, !compiled.empty(), facts);
    std::stable_partition(facts.objects.begin(), facts.objects.end(),
                          [](const Object &o) { return o.member.empty(); });
    facts.inputs = replaceIntermediate(options.inputs, facts.intermediate, compiled);
    facts.program = readDynamic(to.program);
    orderLibraries(facts);
    facts.ownStart = canStart(facts.libraries);
    facts.exceptions =
        std::any_of(facts.objects.begin(), facts.objects.end(), [](auto &o) { return o.exceptions; });
    return facts;
}

Linked Linker::linkDynamic(const Facts &facts, const std::string &name, const Words &flags) {
    Linked to = linked(name);
    Words words = command(to, flags);
    if (!facts.exceptions) words.push_back("-Wl,--no-eh-frame-hdr");
    if (facts.ownStart) {
        bool whole = needsWholeStart(facts.program, facts.libraries) ||
                     std::any_of(facts.objects.begin(), facts.objects.end(), [](const Object &o) {
                         return o.constructors || o.destructors || o.oldConstructors;
                     });
        add(words, {"-nostartfiles", assemble(name, startDynamic(whole))});
    }
    add(words, facts.inputs);
    link(words);
    return to;
}

Linked Linker::linkStatic(const Facts &facts) {
    Linked to = linked("static");
    Words words = command(to, {"-static"});
    add(words, facts.inputs);
    link(words, true);
    return to;
}

// Each file gets a new folder, so that it keeps the name that reports print.
std::string Linker::saveObject(const std::string &path, const Bytes &bytes) const {
    std::string folder = file("objects/" + std::to_string(slotted.size()));
    fs::create_directories(folder);
    std::string to = folder + "/" + fs::path(path).filename().string();
    writeBytes(to, bytes);
    return to;
}

// Writes copies of the program's objects that use slots instead of GOT entries.
void Linker::saveSlots(const Facts &facts, const Plan &plan) {
    std::set<std::string> names;
    for (const Import &import : plan.imports)
        if (import.form == Import::kSlot) names.insert(import.name);
    std::map<std::string, Bytes> changed; // archives
    slotted.clear();
    for (Object object : facts.objects) {
        bool any = makeSlots(object, names);
        if (object.member.empty())
            slotted.push_back(saveObject(object.path, object.bytes));
        else if (any) {
            Bytes &archive = changed[object.path];
            if (archive.empty()) archive = readBytes(object.path);
            std::copy(object.bytes.begin(), object.bytes.end(), archive.begin() + (long)object.offset);
        }
    }
    slotted.push_back("-Wl,--start-group");
    for (const std::string &path : facts.archives)
        slotted.push_back(changed.count(path) ? saveObject(path, changed[path]) : path);
    slotted.push_back("-Wl,--end-group");
}

Linked Linker::linkImports(const Facts &facts, const Plan &plan, const std::string &name,
                           const Words &flags) {
    if (slotted.empty()) {
        saveSlots(facts, plan);
        common::writeWhole(file("imports.ld"), kImportsScript);
        assemble("imports", startImports(plan));
        // A stub of libdl for the linker
        assemble("libdl", ".globl dlopen, dlsym\n.type dlopen, @function\n.type dlsym, @function\ndlopen:\n"
                          "dlsym: ret\n.section .note.GNU-stack, \"\", @progbits\n");
        link({compiler, "-shared", "-nostdlib", "-Wl,-soname,libdl.so.2", file("libdl.o"), "-o",
              file("libdl.so")});
    }
    Linked to = linked(name);
    Words words = command(to, flags);
    add(words, {"-nostdlib", "-Wl,--hash-style=sysv,-z,nodynamic-undefined-weak,-T," + file("imports.ld"),
                "-Wl,--no-eh-frame-hdr"});
    for (const Import &import : plan.imports)
        if (import.name == "dlopen" || import.name == "dlsym") words.push_back("-Wl,--wrap=" + import.name);
    for (const std::string &word : facts.inputs)
        if (word.rfind("-Wl,", 0) == 0 || word.rfind("-m", 0) == 0 || word.rfind("-f", 0) == 0)
            words.push_back(word);
    words.push_back(file("imports.o"));
    add(words, slotted);
    words.push_back(file("libdl.so"));
    link(words);
    return to;
}

} // namespace pack::linking
