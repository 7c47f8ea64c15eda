// Model parameters: those that every search starts from, and parameters as text files, one context a line:
//
//     slots 22
//     code byte1+byte2          a context of code sees these fields
//     data column               ... of data
//     code-weights opcode       what selects a set of weights
//     data-weights -            nothing but what every context sees
//
// Code may use all fields but column and byte5, data those up to target (kMayUse in x86.h).
#pragma once

#include "packer/model/model.h"

#include <string>

namespace pack {

const ModelParameters &defaultParameters();

// Four contexts instead of 16: they decode more than twice as fast, and cost 4 to 12 % more bytes.
const ModelParameters &fastParameters();

std::string printParameters(const ModelParameters &parameters);

// Throws common::Refused with the number of the line that is wrong.
ModelParameters parseParameters(const std::string &text);

// The same of a file; its name begins the error.
ModelParameters readParameters(const std::string &path);

} // namespace pack
