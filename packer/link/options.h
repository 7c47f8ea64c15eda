// The command line of pack-link: that of a compiler which links, and options of its own.
#pragma once

#include "packer/link/process.h"
#include "tools/common/command_line.h"

namespace pack::linking {

// The words of a command line, divided: those for the compiler, and pack-link's own.
struct DividedWords {
    Words compiler, own;
};
DividedWords divide(int argc, char **argv);

struct Options {
    Words inputs; // for the compiler, in their order: files, -l, -L and other words for linking
    std::string out = "a.out", way, keep, compiler; // empty if not given
    Words model, packing;                           // for `pack`: with every try; with the last one alone
    bool budget = false;                            // is one of `packing`
    bool verbose = false;                           // print the commands
};

// `line`: of pack-link's own words. Throws common::Refused.
Options parseOptions(common::CommandLine &line, const Words &compiler);

} // namespace pack::linking
