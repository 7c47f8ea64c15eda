// Links a program in each way, by running the compiler.
#pragma once

#include "packer/link/imports.h"
#include "packer/link/options.h"

namespace pack::linking {

// The files of a linked program.
struct Linked {
    std::string program, map;
};

// What the first, dynamic link shows about a program.
struct Facts {
    Words inputs;                // as given, with the LTO output instead of LTO objects
    std::vector<Object> objects; // all that were linked, in order; archive members last
    Words archives;              // those with linked members
    DynamicFile program;
    std::vector<DynamicFile> libraries;
    Words intermediate;        // LTO objects
    bool ownStart, exceptions; // it can start without crt1; it needs unwind tables
};

class Linker {
public:
    Linker(const LinkOptions &options, const std::string &folder);

    // The first link; throws common::Refused if it fails, with the reason in one line.
    Facts linkFirst();

    // These throw common::Refused if the program cannot be linked that way. `name`: of the files, without
    // ending.
    Linked linkDynamic(const Facts &facts, const std::string &name, const Words &flags);
    Linked linkStatic(const Facts &facts);
    Linked linkImports(const Facts &facts, const Plan &plan, const std::string &name, const Words &flags);

private:
    std::string file(const std::string &name) const { return folder + "/" + name; }
    Words command(const Linked &to, const Words &flags) const;
    std::string assemble(const std::string &name, const std::string &source) const;
    Linked linked(const std::string &name) const { return {file(name + ".elf"), file(name + ".map")}; }
    // Throws common::Refused with the reason in one line.
    void link(const Words &words, bool isStatic = false) const;
    std::string saveObject(const std::string &path, const Bytes &bytes) const;
    void saveSlots(const Facts &facts, const Plan &plan);

    const LinkOptions &options;
    std::string folder, compiler;
    Code code;     // the kind of LTO objects; kMachine without any
    Words slotted; // the inputs of the way `imports`: objects that use slots, and archives
};

// The messages of a failed link as one line. `isStatic`: linked with -static.
std::string explainLink(const std::string &messages, bool isStatic = false);

} // namespace pack::linking
