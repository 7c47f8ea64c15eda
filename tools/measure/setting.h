// Settings of the tracer in words: "play", or "draft,threshold=0.02,cutoff=1/64", a quality of which some
// knobs are turned. Blanks serve as commas do.
#pragma once

#include "trace/quality.h"

#include <string>

namespace odraz {

// Knobs are the numbers of Quality by their names. Throws Refused (arguments.h).
Quality settingOf(const std::string &words);

} // namespace odraz
