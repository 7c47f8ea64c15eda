// The address filter: displacements of calls and jumps (E8, E9) become addresses within the program, high
// byte first, so that the same target looks the same wherever it is named.
//
// It looks at bytes, not at instructions. A wrong guess costs a little compression, never correctness: for
// values in
// [-position, limit) the mapping is a permutation (those that would fall outside the program wrap around),
// all others stay; and after a displacement the search goes on behind it. So the inverse meets the same bytes
// and decides alike, on any input. (Guessing at RIP-relative operands and at 0F 8x jumps as well made the
// film larger.)
#pragma once

#include <stdint.h>

namespace pack {

// Forward (to addresses) or back, in place over `size` bytes of a program that spans `limit` bytes.
template <bool kForward> static inline void filterAddresses(uint8_t *code, uint32_t size, uint32_t limit) {
    for (uint32_t i = 0; i + 5 <= size; ++i) {
        if ((code[i] & 0xfe) != 0xe8) continue;
        uint32_t value, position = ++i + 4;
        __builtin_memcpy(&value, code + i, 4);
        if (!kForward) value = __builtin_bswap32(value);
        if (kForward) {
            // [-position, limit - position) up to [0, limit); what is left of [.., limit) down below 0
            if (value + position < limit)
                value += position;
            else if (value < limit)
                value -= limit;
        } else {
            if (value < limit)
                value -= position;
            else if (value + position < position)
                value += limit;
        }
        if (kForward) value = __builtin_bswap32(value);
        __builtin_memcpy(code + i, &value, 4);
        i += 3;
    }
}

} // namespace pack
