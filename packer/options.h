// The command line of pack.
#pragma once

#include "packer/write/messages.h"

#include <optional>

namespace pack {

inline constexpr long kNoBudget = -1;

// Paths are empty where none was given.
struct Options {
    std::string in, test, unpack, out; // one of the first three is given
    bool pe = false, loader = false, plain = false, fast = false;
    std::optional<long> budget; // bytes, or kNoBudget
    double seconds = 0;         // of search
    Names names;
    std::string model, saveModel, map, symbols, rooms, report, html, text, than;
};

// Throws common::Refused for options that do not go together.
Options parseOptions(common::CommandLine &line);

} // namespace pack
