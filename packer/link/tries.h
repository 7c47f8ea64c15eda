// Links and packs a program in every way that is possible, to find the smallest file.
#pragma once

#include "packer/link/linker.h"

namespace pack::linking {

// One way to link, and its result.
struct Try {
    std::string way, detail; // detail: how it was linked; or, if it was not packed, why not
    Linked linked = {};
    std::optional<ModelParameters> model = {}; // the contexts that it is packed with, if not the default ones
    uint64_t before = 0, packed = 0;           // bytes of memory, and of the file; 0 if it was not packed
};

class Tries {
public:
    Tries(const LinkOptions &options, const std::string &folder)
        : options(options), folder(folder), linker(options, folder) {}

    // Throws common::Refused if the program cannot be linked at all, or not in the way that was asked for.
    void run();
    // The smallest; at least one is packed.
    const Try &best() const;
    // A line for each way.
    std::string print() const;
    // Packs the best one again, as `options.packing` asks for.
    void finish() const;

private:
    void tryDynamic();
    void tryImports();
    void tryStatic();
    // Tries a way, unless another one was asked for; if it is not possible, keeps the reason.
    void tryWay(const char *way, void (Tries::*make)());
    void pack(Try &made) const;
    std::string namesOfIntermediate() const;
    void keepFiles(const Try &taken) const;
    // Packs a linked program. Returns whether that is quick enough to try variants.
    bool add(const std::string &way, const std::string &detail, const Linked &linked);

    const LinkOptions &options;
    std::string folder;
    Linker linker;
    Facts facts;
    std::vector<Try> tries;
};

} // namespace pack::linking
