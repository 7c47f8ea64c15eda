// The address filter: displacements of calls, jumps and RIP-relative operands become addresses within the program,
// high byte first, so that the same target looks the same wherever it is named.
//
// It looks at bytes, not at instructions: E8 and E9, 0F 80..8F, and any ModRM byte of the form mod = 0, rm = 5.
// A wrong guess costs a little compression, never correctness: for values in [-position, limit) the mapping is a
// permutation (those that would fall outside the program wrap around), all others stay; and after a displacement
// the search goes on behind it. So the inverse meets the same bytes and decides alike, on any input.
#pragma once

#include <stdint.h>

namespace pack {

// Forward (to addresses) or back, in place over `size` bytes of a program that spans `limit` bytes.
template <bool kForward> static inline void filterAddresses(uint8_t *code, uint32_t size, uint32_t limit) {
    for (uint32_t i = 0; i + 6 <= size; ++i) {
        uint8_t b = code[i];
        bool direct = (b & 0xfe) == 0xe8 || (b & 0xc7) == 5;
        if (!direct && !(b == 0x0f && (code[i + 1] & 0xf0) == 0x80)) continue;
        i += direct ? 1 : 2;
        uint32_t value, position = i + 4;
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
