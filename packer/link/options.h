// The command line of pack-link: a compiler's options for linking, and its own options.
#pragma once

#include "packer/options.h"
#include "packer/read/process.h"

namespace pack::linking {

// A command line, divided into words for the compiler and pack-link's own.
struct DividedWords {
    Words compiler, own;
};
// @FILE stands for the words in a file, as for a compiler. Throws common::Refused if it cannot be read.
DividedWords divide(const Words &given);
// The words of a text, divided by spaces; ", \' and \\ quote as a compiler reads them.
Words wordsOf(const std::string &text);

struct LinkOptions {
    Words inputs; // for the compiler, in their order: files, -l, -L and other words for linking
    std::string way, keep, compiler; // empty if not given
    bool verbose = false;            // print the commands
    Options packing;                 // of the program that is kept: its output, model and reports
};

// `line`: of pack-link's own words. Throws common::Refused.
LinkOptions parseLinkOptions(common::CommandLine &line, const Words &compiler);

} // namespace pack::linking
