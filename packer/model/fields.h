// What is known at a place in the program. Each context uses some of these fields.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace pack {

enum Field {
    kWhere,  // used by every context: what the next byte of code is part of, and how many bytes of that are
             // to come, as the parser's left << kPhaseBits | phase
    kColumn, // address modulo kColumns
    kByte5,  // the fifth-last byte
    kByte4,
    kByte3,
    kByte2,
    kByte1,    // the last byte
    kToMark,   // bytes from here to the next place that an operand has named, at most kFarMark
    kTarget,   // target of the last operand that was relative to its instruction: an offset in the program
    kFunction, // how many returns came before
    kWritten1, // the register that the instruction before this one may have written
    kWritten2, // ... and the one before that
    kInstruction1, // the instruction before this one, hashed
    kOpcode1,      // its opcode
    kOpcode2,      // the opcode of the one before that
    kOpcode3,      // ... and of the one before that
    kOpcode,       // of this instruction, as far as it is known, with map and prefixes
    kMode,         // this instruction's ModRM byte without the register operand, or 0
    kSoFar,        // all bytes of this instruction so far, hashed
    kModrm,        // its ModRM byte, or 0: for the parser alone
    kFields
};

// The fields that a context may use or not, as bits of a mask from kColumn on: in code 16 of them, in data
// eight.
constexpr uint32_t kChoices = kSoFar + 1 - kColumn, kCodeBits = 16, kDataBits = 8;
constexpr uint32_t kCodeShift = kByte4 - kColumn; // code does not use kColumn and kByte5
constexpr uint32_t kMayUse[2] = {((1u << kCodeBits) - 1) << kCodeShift, (1u << kDataBits) - 1};
static_assert(kCodeShift + kCodeBits == kChoices && kColumn + kDataBits == kTarget + 1);
constexpr uint32_t kPhases = 7, kPhaseBits = 3, kColumns = 4, kFarMark = 16;
constexpr uint32_t kHash = 0x2c9277b5, kHashShift = 15;

static inline uint32_t mixIn(uint32_t hash, uint32_t value) {
    hash = (hash + value + 1) * kHash;
    return hash ^ hash >> kHashShift;
}

} // namespace pack
