// Machine code for measuring the packer: parts of the instructions of this film and of system libraries.
#pragma once

#include "packer/read/program.h"

namespace pack {

struct Sample {
    std::string name;
    Bytes bytes;
    Layout layout;
};

// Reads the program in a file. Throws common::Refused with a line that names the file.
Program programIn(const std::string &file);

inline constexpr char kWholeFilm[] = "the whole film"; // the name of its sample
// Samples of 16, 48, 128 and 256 KB. Files that are not installed or too small are left out and named in
// `missing`. `film`: a path of odraz-safe. Throws like programIn().
std::vector<Sample> corpus(const std::string &film, std::vector<std::string> &missing);

} // namespace pack
