// The command line of pack.
#pragma once

#include "packer/model/model.h"
#include "tools/common/command_line.h"

#include <optional>

namespace pack {

inline constexpr long kNoBudget = -1;

// A path that was not given is empty.
struct PackOptions {
    std::string in, test, unpack, out; // exactly one of the first three is given
    bool pe = false, loader = false, plain = false, fast = false;
    std::optional<long> budget;           // bytes, or kNoBudget
    double seconds = 0;                   // time to search
    std::optional<ModelParameters> model; // contexts to start with
    std::string safeName, modelFile, saveModel, map, symbols, rooms, report, html, text, than;
};

// Parses the options and reads the model file. Throws common::Refused for options that contradict each other,
// and for outputs that would replace an input or another output.
PackOptions parseOptions(common::CommandLine &line);

} // namespace pack
