// What is known about a place in the program, as small numbers for contexts to choose from.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace pack {

enum Field {
    kWhere, // part of every context. Code: what the next byte is part of, how many bytes of it are to come.
            // The parser's left << kPhaseBits | phase
    kByte1, // the last byte; from here on each context chooses
    kByte5 = 5, // the fifth-last byte
    kColumn,    // address modulo kColumns
    kTarget, // what the last operand named that is relative to its instruction, as an offset in the program
    kInstruction1, // the instruction before this one, hashed
    kOpcode1,      // its opcode
    kOpcode2,      // the opcode of the one before that
    kOpcode3,      // ... and of the one before that
    kModrm1,       // the ModRM byte of the instruction before this one
    kOpcode,       // of this instruction, as far as it is known, with map and prefixes
    kModrm,        // its ModRM byte, or 0
    kMode,         // the same without the register operand
    kSoFar,        // all its bytes so far, hashed
    kFields
};

constexpr uint32_t kPhases = 6, kPhaseBits = 3, kColumns = 4;
constexpr uint32_t kHash = 0x2c9277b5, kHashShift = 15;

static inline uint32_t mixIn(uint32_t hash, uint32_t value) {
    hash = (hash + value + 1) * kHash;
    return hash ^ hash >> kHashShift;
}

} // namespace pack
