// Machine code to measure the packer with: stretches of the instructions of this film and of system
// libraries.
#pragma once

#include "program.h"

namespace pack {

struct Sample {
    std::string name;
    std::vector<uint8_t> bytes;
    Layout layout;
};

// The program of a file. Throws odraz::Refused with a line that names it.
Program programIn(const std::string &file);

// 16, 48, 128 and 256 KB each; what is not installed or too small is left out, and named in `missing`.
// `film`: a path of odraz-safe. Throws likewise.
std::vector<Sample> corpus(const std::string &film, std::vector<std::string> &missing);

} // namespace pack
