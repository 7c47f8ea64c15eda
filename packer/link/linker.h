// Links a program in each of the ways, by the compiler.
#pragma once

#include "packer/link/imports.h"
#include "packer/link/options.h"

namespace pack::linking {

// A program that was linked: the files it lies in.
struct Linked {
    std::string program, map;
};

// What is known of a program once it was linked dynamically.
struct Facts {
    Words inputs;                // as given, with machine code in place of what -flto kept
    std::vector<Object> objects; // all that were taken, in their order; last those from archives
    Words archives;              // those with objects that were taken
    DynamicFile program;
    std::vector<DynamicFile> libraries;
    Words intermediate;        // objects of -flto
    bool ownStart, exceptions; // it can start without crt1; it needs its tables for unwinding
};

class Linker {
public:
    Linker(const Options &options, const std::string &folder);

    // The first link; throws common::Refused if it fails, with the reason in one line.
    Facts linkFirst();

    // These throw common::Refused if it cannot be linked so. `name` names the files.
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

    const Options &options;
    std::string folder, compiler;
    Code code;     // what is optimised when it is linked, or kMachine if nothing is
    Words slotted; // what the way `imports` links: the objects of the program, with slots, and archives
};

// The messages of a failed link as one line. `isStatic`: of static libraries.
std::string explainLink(const std::string &messages, bool isStatic = false);

} // namespace pack::linking
