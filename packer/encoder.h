// Encoding: the mirror of decoder.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pack {

std::vector<uint8_t> encode(const std::vector<uint8_t> &bytes);

// Decodes with the stub's code; for checking.
std::vector<uint8_t> decodeAgain(const std::vector<uint8_t> &coded, std::size_t size);

} // namespace pack
