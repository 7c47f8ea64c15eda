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
    std::optional<long> budget;           // bytes, or kNoBudget
    double seconds = 0;                   // of search
    std::optional<ModelParameters> model; // contexts to start with
    std::string safeName, modelFile, saveModel, map, symbols, rooms, report, html, text, than;
};

// Reads the model, too. Throws common::Refused for options that do not go together, and for outputs that
// would replace an input or another output.
Options parseOptions(common::CommandLine &line);

} // namespace pack
