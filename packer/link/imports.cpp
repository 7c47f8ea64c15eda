#include "packer/link/imports.h"

#include "packer/read/program.h"

#include <algorithm>

namespace pack::linking {

namespace {

using Libraries = std::vector<DynamicFile>;

// The libraries of glibc. Several of them may define the same function, identically.
bool isLibc(const std::string &soname) {
    for (const char *part : {"libc.so.6", "libm.so.6", "libmvec.so.1", "libpthread.so.0", "librt.so.1",
                             "libdl.so.2", "ld-linux-x86-64.so.2"})
        if (soname == part) return true;
    return false;
}

const DynamicSymbol *definition(const DynamicFile &library, const std::string &name) {
    auto found = library.symbols.find(name);
    return found != library.symbols.end() && found->second.defined ? &found->second : nullptr;
}

// The library that a loader finds a symbol in, or null.
const DynamicFile *home(const Libraries &libraries, const std::string &name) {
    for (const DynamicFile &library : libraries)
        if (definition(library, name)) return &library;
    return nullptr;
}

void checkObjects(const std::vector<Object> &objects) {
    for (const Object &o : objects) {
        need(!o.exceptions, o.name() + " has tables of exceptions: compile with -fno-exceptions");
        need(!o.threadLocal, o.name() + " has thread-local storage");
        need(!o.oldConstructors, o.name() + " has constructors of an old kind (.ctors or .init)");
        need(!o.indirect, o.name() + " has functions that are chosen at the start (ifunc)");
    }
}

// Refuses what a library looks up in the program, because a packed one has no symbols. libpulse looks for
// main() and does without.
void checkExports(const std::vector<Object> &objects, const DynamicFile &program) {
    for (const Object &o : objects)
        for (const std::string &name : o.defines) {
            auto exported = program.symbols.find(name);
            need(name == "main" || exported == program.symbols.end() || !exported->second.defined,
                 "a library looks for '" + name + "' in the program, where " + o.name() + " has it");
        }
}

// A library that replaces a function of libc would have to be searched first, but libc always is.
void checkOrder(const Libraries &libraries, const DynamicFile &from, const std::string &name) {
    if (isLibc(from.soname)) return;
    for (const DynamicFile &library : libraries)
        need(!isLibc(library.soname) || !definition(library, name),
             from.soname + " replaces '" + name + "' of libc");
}

// How the objects refer to a name: for each kind, one object that does, or "".
struct Uses {
    std::string direct, got;
};
void addUse(Uses &uses, const Object &object, const Reference &r) {
    switch (r.type) {
    case R_X86_64_GOTPCREL:
    case R_X86_64_GOTPCRELX:
    case R_X86_64_REX_GOTPCRELX:
        uses.got = object.name();
        break;
    case R_X86_64_PLT32:
    case R_X86_64_PC32:
    case R_X86_64_32:
    case R_X86_64_32S:
    case R_X86_64_64:
        uses.direct = object.name();
        break;
    default:
        throw common::Refused(object.name() + " refers to '" + r.symbol +
                              "' in an unusual way: compile it with -fno-pic or -fPIE");
    }
}
std::map<std::string, Uses> allUses(const std::vector<Object> &objects, const DynamicFile &program,
                                    const Libraries &libraries) {
    std::set<std::string> own;
    for (const Object &o : objects) own.insert(o.defines.begin(), o.defines.end());
    std::map<std::string, Uses> uses;
    for (const Object &o : objects)
        for (const Reference &r : o.references)
            if (!own.count(r.symbol) && program.symbols.count(r.symbol) && home(libraries, r.symbol))
                addUse(uses[r.symbol], o, r);
    return uses;
}

// Data can be copied if it does not change afterwards. Only programs change the three pointers.
bool mayCopy(const std::string &name, const DynamicSymbol &symbol) {
    return symbol.constant || name == "stdin" || name == "stdout" || name == "stderr";
}

Import plan(const std::string &name, const Uses &uses, const Libraries &libraries) {
    const DynamicFile &from = *home(libraries, name);
    const DynamicSymbol &symbol = *definition(from, name);
    checkOrder(libraries, from, name);
    need(!symbol.threadLocal, "'" + name + "' of " + from.soname + " is thread-local");
    if (uses.direct.empty()) return {Import::kSlot, name, 0};
    if (symbol.function) return {Import::kJump, name, 0};
    need(mayCopy(name, symbol) && symbol.size,
         uses.direct + " reads '" + name + "' of " + from.soname + " directly: compile it with -fPIC");
    return {Import::kCopy, name, symbol.size};
}

} // namespace

bool needsWholeStart(const DynamicFile &program, const Libraries &libraries) {
    for (const char *name : {"pthread_exit", "pthread_cancel", "thrd_exit"})
        if (program.symbols.count(name)) return true;
    return std::any_of(libraries.begin(), libraries.end(), [](const DynamicFile &library) {
        bool system = library.path.rfind("/usr/lib", 0) == 0 || library.path.rfind("/lib", 0) == 0;
        return library.destructors && !system;
    });
}

Plan planImports(const std::vector<Object> &objects, const DynamicFile &program, const Libraries &libraries) {
    need(std::any_of(libraries.begin(), libraries.end(), [](auto &l) { return l.soname == "libc.so.6"; }),
         "it is not linked with glibc");
    need(!program.ownFolders, "it looks for libraries in folders of its own (-rpath)");
    checkObjects(objects);
    checkExports(objects, program);
    Plan made = {};
    for (auto &[name, uses] : allUses(objects, program, libraries))
        made.imports.push_back(plan(name, uses, libraries));
    for (const std::string &name : program.needed)
        if (!isLibc(name) || name == "libm.so.6" || name == "libpthread.so.0" || name == "librt.so.1" ||
            name == "libmvec.so.1")
            made.libraries.push_back(name);
    for (const Object &o : objects) {
        made.constructors |= o.constructors;
        made.destructors |= o.destructors;
    }
    made.whole = needsWholeStart(program, libraries);
    return made;
}

} // namespace pack::linking
