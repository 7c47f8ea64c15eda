// FNV-1a, the hash of Fowler, Noll and Vo: 64 bits, to compare contents, not for security.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace common {

constexpr uint64_t kFnvStart = 0xcbf29ce484222325, kFnvPrime = 0x100000001b3;

// Continues a hash with one more value, which is usually a byte.
constexpr uint64_t fnv1a(uint64_t hash, uint64_t value) { return (hash ^ value) * kFnvPrime; }

// The hash of bytes, or a hash continued with them.
constexpr uint64_t fnv1a(std::string_view bytes, uint64_t hash = kFnvStart) {
    for (char byte : bytes) hash = fnv1a(hash, (unsigned char)byte);
    return hash;
}

} // namespace common
