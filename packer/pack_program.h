// Packs a program as the options of pack ask for: searches, packs, proves, reports.
#pragma once

#include "packer/options.h"

namespace pack {

// Packs o.in to o.out. Prints the result and what each part costs. During a search SIGINT ends only that.
// Throws common::Refused, and std::runtime_error if the packed file is over budget.
void packProgram(const Options &o);

} // namespace pack
