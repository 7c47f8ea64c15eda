// The command line of pack.
#pragma once

#include "packer/write/texts.h"

#include <string>

namespace pack {

// A line for the user and the status to end with.
struct Refusal {
    std::string line;
    int status;
};

inline constexpr long kNoBudget = -1;
inline constexpr long kUsualBudget = -2; // by the kind of program

struct Options {
    const char *in = nullptr, *out = nullptr, *test = nullptr, *unpack = nullptr, *model = nullptr,
               *map = nullptr, *symbols = nullptr, *saveModel = nullptr, *report = nullptr, *html = nullptr,
               *text = nullptr, *than = nullptr, *rooms = nullptr;
    bool pe = false, loader = false, plain = false, fast = false;
    Names names;
    long budget = kUsualBudget; // bytes
    double seconds = 0;
    const char *onlyToPack = nullptr; // an option given that has no meaning otherwise
};

// Prints the usage and ends with status 0 for --help. Throws Refusal of status 2 for what makes no sense.
Options parseOptions(int argc, char **argv);

} // namespace pack
