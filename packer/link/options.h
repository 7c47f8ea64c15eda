// The command line of pack-link.
#pragma once

#include "packer/link/process.h"

namespace common {
class Arguments;
}

namespace pack::linking {

extern const char kUsage[];

struct Options {
    Words inputs; // for the compiler, in their order: files, -l, -L and other words for linking
    std::string out = "a.out", way, keep, compiler; // empty if not given
    Words model, packing;                           // for `pack`: with every try; with the last one alone
    bool budget = false;                            // is one of `packing`
    bool tell = false;                              // the commands
};

// Throws common::Refused.
Options parseOptions(common::Arguments &arguments);

} // namespace pack::linking
