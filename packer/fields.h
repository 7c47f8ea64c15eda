// What is known at a place in the program. Each context uses some of these fields.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace pack {

enum Field {
    kWhere, // used by every context: what the next byte of code is part of, and how many bytes of that are
            // to come, as the parser's left << kPhaseBits | phase
    kByte1, // the last byte; a context may use any fields from here on
    kByte5 = 5, // the fifth-last byte
    kColumn,    // address modulo kColumns
    kToMark,    // bytes from here to the next place that an operand has named, at most kFarMark
    kTarget,    // target of the last operand that was relative to its instruction: an offset in the program
    kFunction,  // how many returns came before
    kWritten1,  // the register that the instruction before this one may have written
    kWritten2,  // ... and the one before that
    kInstruction1, // the instruction before this one, hashed
    kOpcode1,      // its opcode
    kOpcode2,      // the opcode of the one before that
    kOpcode3,      // ... and of the one before that
    kModrm1,       // the ModRM byte of the instruction before this one
    kOpcode,       // of this instruction, as far as it is known, with map and prefixes
    kModrm,        // this instruction's ModRM byte, or 0
    kMode,         // that byte without the register operand
    kSoFar,        // all bytes of this instruction so far, hashed
    kFields
};

constexpr uint32_t kChoices = kFields - kByte1; // fields that a context may use or not
constexpr uint32_t kPhases = 7, kPhaseBits = 3, kColumns = 4, kFarMark = 16;
constexpr uint32_t kHash = 0x2c9277b5, kHashShift = 15;

static inline uint32_t mixIn(uint32_t hash, uint32_t value) {
    hash = (hash + value + 1) * kHash;
    return hash ^ hash >> kHashShift;
}

} // namespace pack
