// The command line of pack-link: a compiler's options for linking, and its own options.
#pragma once

#include "packer/link/process.h"
#include "tools/common/command_line.h"

namespace pack::linking {

// A command line, divided into words for the compiler and pack-link's own.
struct DividedWords {
    Words compiler, own;
};
DividedWords divide(int argc, char **argv);

struct Options {
    Words inputs; // for the compiler, in their order: files, -l, -L and other words for linking
    std::string out = "a.out", way, keep, compiler; // empty if not given
    Words model, packing;                           // options for pack: in every try; in the last run only
    bool budget = false;                            // `packing` has --budget
    bool verbose = false;                           // print the commands
};

// `line`: of pack-link's own words. Throws common::Refused.
Options parseOptions(common::CommandLine &line, const Words &compiler);

} // namespace pack::linking
