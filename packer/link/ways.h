// Links and packs a program in every way that is possible, to find the smallest file.
#pragma once

#include "packer/link/linker.h"

namespace pack::linking {

// Prints a line for each way and packs the smallest program as `options.packing` asks for. Other files are
// made in `folder`. Throws common::Refused if the program cannot be linked at all, or not in the way that was
// asked for.
void packSmallest(const LinkOptions &options, const std::string &folder);

} // namespace pack::linking
