// An incremental parser of x86-64 code: after each byte it returns what the next byte is part of. The model
// uses this as context. The parser also finds the operands that name addresses relative to themselves.
//
// It parses the instructions that compilers write for user programs up to AVX2. After an unknown instruction
// (or data) it may lose its place, and recovers after a few bytes. That costs compression but not
// correctness, because packer and stub lose their place in the same way.
#pragma once

#include "packer/model/fields.h"

namespace pack {

// --- What is known at a place in the program. Each context uses some of these fields ---

enum Field {
    kByte5 = kColumn + 1, // the fifth-last byte; kWhere has the parser's left: how many bytes are to come
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
constexpr MayUse kMayUse = {kCodeShift, kCodeBits, kDataBits};
static_assert(kCodeShift + kCodeBits == kChoices && kColumn + kDataBits == kTarget + 1);
constexpr uint32_t kFarMark = 16;

// --- The parser ---

// What follows an opcode. Bit 0: a ModRM byte follows. Bits 1, 2: the immediate operand.
enum OpcodeClass : uint8_t {
    kHasModrm = 1,
    kImmediate8 = 2,  // one byte
    kImmediate32 = 4, // four bytes; two with prefix 66, eight for a move to a 64-bit register
    kRelative32 = 6,  // four bytes, relative to the next instruction
    kRelative8 = 7,   // one such byte; there is no ModRM byte
};
constexpr uint32_t kClassBits = 3, kOpcodes = 4 << 8; // four maps
struct OpcodeRun {
    uint32_t count, kind;
};
constexpr OpcodeRun kOpcodeRuns[] = {
#define OPCODE_RUN(count, kind) {count, kind},
#include "packer/model/opcodes.h"
};

// The runs of opcodes.h as a table: the class of an opcode is at map << 8 | opcode. In the stub a run is one
// byte, its count above its class. The stub counts down to 0 in eight bits, so a count of 0 means 256.
constexpr void expandOpcodes(uint8_t *classes) {
    for (OpcodeRun run : kOpcodeRuns)
        for (uint32_t i = 0; i < (run.count ? run.count : 256); ++i) *classes++ = (uint8_t)run.kind;
}
static_assert([] {
    uint32_t all = 0;
    for (OpcodeRun run : kOpcodeRuns) {
        if (run.count >> (8 - kClassBits) || run.kind >> kClassBits) return false;
        all += run.count ? run.count : 256;
    }
    return all == kOpcodes;
}());

struct Parser {
    enum Phase : uint32_t { kStart, kVex, kModrmByte, kSibByte, kDisplacement, kOperand, kJump };
    static_assert(kJump + 1 == kPhases && kPhases <= 1 << kPhaseBits);
    // In kStart, `left` holds what has been seen of the instruction, and above it the map of the next opcode:
    // 1 for 0f, 2 for 0f 38, 3 for 0f 3a
    static constexpr uint32_t kSeenRex = 1, kSeenVex = 2, kMapShift = 2, kSeenMap = 1 << kMapShift;
    static constexpr uint32_t kPrefixShift = 16; // in kOpcode: above map and opcode
    static constexpr uint32_t kReturn = 0xc3;

    Phase phase;   // what the next byte is part of
    uint32_t left; // how many bytes of it are to come
    uint32_t map, immediate;
    uint32_t high;     // bits of REX or VEX: 4 extends, or with VEX does not extend, ModRM's register; 8 is W
    uint32_t relative; // bytes of this or the next field that is relative to the next instruction
    bool begins;       // an instruction begins at the next byte

    // Takes the next byte. If this byte ends a field that is relative to the next instruction's address,
    // returns how far that address is from this byte; otherwise 0.
    uint32_t step(uint32_t *f, uint32_t b, const uint8_t *classes) {
        uint32_t found = 0;
        f[kSoFar] = mixIn(f[kSoFar], b);
        begins = false;
        switch (phase) {
        case kStart: {
            if (left < kSeenMap) {
                if ((b & 0xf0) == 0x40) {
                    high = b & 15;
                    left |= kSeenRex;
                    return 0;
                }
                if (b == 0x66 || (b & 0xfe) == 0xf2) {
                    f[kOpcode] |= b << kPrefixShift;
                    return 0;
                }
                if (b == 0x0f) {
                    left |= kSeenMap;
                    return 0;
                }
                if ((b & 0xfe) == 0xc4) {
                    phase = kVex;
                    left = 2 - (b & 1);
                    map = 1;
                    return 0;
                }
            } else if (left < kSeenMap + kSeenVex && (b & 0xfd) == 0x38) {
                left += kSeenMap + (b - 0x38) * 2; // 0f 38, 0f 3a
                return 0;
            }
            uint32_t opcode = left >> kMapShift << 8 | b;
            // The eight arithmetic operations, 00 .. 3f, have the same form
            uint32_t kind = classes[opcode < 0x40 ? opcode & 7 : opcode];
            f[kOpcode] |= opcode;
            immediate = kind & kImmediate32 ? 4 : kind >> 1;
            if (kind == kRelative8) immediate = 1;
            relative = kind >= kRelative32 ? immediate : 0;
            if (kind & kImmediate32 && !relative && f[kOpcode] >> kPrefixShift == 0x66) immediate = 2;
            if (kind == kImmediate32 && high & 8 && b >= 0xb8) immediate = 8;
            left = 0;
            if (kind & kHasModrm && !relative) {
                phase = kModrmByte;
                return 0;
            }
            break;
        }
        case kVex:
            if (left == 2) map = b & 3;
            if (!high) high = b >> 5;
            if (!--left) {
                phase = kStart;
                left = map << kMapShift | kSeenVex;
                f[kOpcode] = (b & 7) << kPrefixShift;
            }
            return 0;
        case kModrmByte:
            f[kModrm] = b;
            f[kMode] = b & 0xc7;
            // of f6 and f7 only TEST has an immediate operand
            if ((f[kOpcode] & 0xfffe) == 0xf6 && b & 0x30) immediate = 0;
            left = b >> 6 == 1 ? 1 : b >> 6 == 2 ? 4 : 0;
            if ((b & 0xc7) == 5) {
                relative = 4;
                left = 4;
            }
            if (b < 0xc0 && (b & 7) == 4) {
                phase = kSibByte;
                return 0;
            }
            phase = kDisplacement;
            break;
        case kSibByte:
            if (f[kModrm] < 0x40 && (b & 7) == 5) left = 4;
            phase = kDisplacement;
            break;
        case kDisplacement:
        case kOperand:
        case kJump:
            if (--left) return 0;
            if (relative) found = 1 + immediate;
            relative = 0;
        }
        if (left) return found;
        if (immediate) {
            phase = relative ? kJump : kOperand;
            left = immediate;
            immediate = 0;
            return found;
        }
        // The end of the instruction
        begins = true;
        f[kFunction] += f[kOpcode] == kReturn;
        f[kWritten2] = f[kWritten1];
        f[kWritten1] = (f[kModrm] & 0x38) | (high & 4);
        f[kOpcode3] = f[kOpcode2];
        f[kOpcode2] = f[kOpcode1];
        f[kOpcode1] = f[kOpcode];
        f[kInstruction1] = f[kSoFar];
        for (int i = kOpcode; i <= kModrm; ++i) f[i] = 0;
        phase = kStart;
        high = 0;
        return found;
    }
};

} // namespace pack
