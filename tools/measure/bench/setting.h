// Settings of the tracer as text: a quality ("play"), a quality with changed knobs
// ("draft,threshold=0.02,cutoff=0.015"), or a level of the governor between two qualities ("level=1.5").
// Blanks may replace commas.
#pragma once

#include "trace/quality.h"

#include <string>

namespace odraz::measure {

// Parses a setting. Knobs are the numeric members of Quality, by name. Throws Refused (command_line.h).
Quality settingOf(const std::string &words);

} // namespace odraz::measure
