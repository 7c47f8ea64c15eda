// FNV-1a, the 64-bit hash of Fowler, Noll and Vo. It compares contents; it is not secure.
#pragma once

#include <cstdint>
#include <string_view>

namespace common {

constexpr uint64_t kFnvStart = 0xcbf29ce484222325, kFnvPrime = 0x100000001b3;

// Continues a hash with one more value, usually a byte.
constexpr uint64_t fnv1a(uint64_t hash, uint64_t value) { return (hash ^ value) * kFnvPrime; }

// Returns the hash of bytes, or continues a hash with them.
constexpr uint64_t fnv1a(std::string_view bytes, uint64_t hash = kFnvStart) {
    for (char byte : bytes) hash = fnv1a(hash, (unsigned char)byte);
    return hash;
}

} // namespace common
