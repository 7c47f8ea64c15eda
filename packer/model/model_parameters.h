// Model parameters: the defaults, and parameters as text files, one context a line:
//
//     slots 22
//     code byte1+byte2          a context of code uses these fields
//     data column               a context of data
//     code-weights opcode       the fields that select a row of a set of weights
//     data-weights -            only the parser's state, which is always used
//
// Code may use all fields except column and byte5; data may use the fields up to target (kMayUse in x86.h).
#pragma once

#include "packer/model/model.h"

#include <string>

namespace pack {

const ModelParameters &defaultParameters();

// Four contexts instead of 16: they decode more than twice as fast, and cost 4 to 12 % more bytes.
const ModelParameters &fastParameters();

std::string printParameters(const ModelParameters &parameters);

// Throws common::Refused, whose text has the number of the wrong line.
ModelParameters parseParameters(const std::string &text);

// Parses a file. The error begins with the file's name.
ModelParameters readParameters(const std::string &path);

} // namespace pack
