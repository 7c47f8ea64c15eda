// Settings of the tracer in words: "play", or "draft,threshold=0.02,cutoff=1/64", which is a quality with
// some knobs turned, or "level=1.5", which is the governor's between two qualities. Blanks may replace
// commas.
#pragma once

#include "trace/quality.h"

#include <string>

namespace odraz::measure {

// Parses a setting. Knobs are the numbers of Quality, by their names. Throws Refused (command_line.h).
Quality settingOf(const std::string &words);

} // namespace odraz::measure
