// Random numbers as a function of an integer, without state: PCG's output permutation.
// Source: Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020 (pcg).
#pragma once

#include "base/float8.h"

namespace odraz {

// Returns 32 well-mixed bits of x, a uint32_t or eight of them.
template <class T> T pcg(T x) {
    T state = x * 747796405u + 2891336453u;
    T word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
    return (word >> 22) ^ word;
}

// Maps a hash to [0, 1), 24 bits.
inline float unitFloat(uint32_t hash) { return (float)(hash >> 8) * (1.f / 16777216.f); }

} // namespace odraz
