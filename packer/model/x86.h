// An incremental parser of x86-64 code. After each byte it computes which part of an instruction comes next;
// the model uses this as context. It also finds the operands that are relative to their instruction.
//
// It parses the instructions that compilers write for user programs, up to AVX2. After an unknown instruction
// or data it may misread some bytes, as the stub does, and soon recovers. That costs only bytes.
#pragma once

#include "packer/model/fields.h"

namespace pack {

// --- The fields at each byte of the program. Each context uses some of them ---

enum X86Field {
    kByte5 = kColumn + 1, // the fifth-last byte
    kByte4,
    kByte3,
    kByte2,
    kByte1,        // the last byte
    kToMark,       // distance to the next byte that is marked as a target, at most kFarMark
    kTarget,       // target of the last relative operand: an offset in the program
    kFunction,     // number of return instructions so far
    kWritten1,     // the register that the last instruction may have written
    kWritten2,     // the register that the second-last instruction may have written
    kInstruction1, // hash of the last instruction
    kOpcode1,      // opcode of the last instruction
    kOpcode2,      // opcode of the second-last instruction
    kOpcode3,      // opcode of the third-last instruction
    kOpcode,       // this instruction's opcode, as far as it is known, with map and prefixes
    kMode,         // this instruction's ModRM byte without the register operand, or 0
    kSoFar,        // hash of this instruction's bytes so far
    kModrm,        // this instruction's ModRM byte, or 0; not for contexts
    kFields
};

// The fields of a context are the bits of a mask; bit 0 is kColumn. Code may use 16 fields, data eight.
constexpr uint32_t kChoices = kSoFar + 1 - kColumn, kCodeBits = 16, kDataBits = 8;
constexpr uint32_t kCodeShift = kByte4 - kColumn; // code does not use kColumn and kByte5
constexpr MayUse kMayUse = {kCodeShift, kCodeBits, kDataBits};
static_assert(kCodeShift + kCodeBits == kChoices && kColumn + kDataBits == kTarget + 1);
constexpr uint32_t kFarMark = 16;

// --- The parser ---

// The bytes that follow an opcode. Bit 0: a ModRM byte. Bits 1, 2: the immediate operand.
enum OpcodeClass : uint8_t {
    kHasModrm = 1,
    kImmediate8 = 2,  // one byte
    kImmediate32 = 4, // four bytes; two with prefix 66, eight for a move to a 64-bit register
    kRelative32 = 6,  // four bytes, relative to the next instruction
    kRelative8 = 7,   // one byte, relative to the next instruction; there is no ModRM byte
};
constexpr uint32_t kClassBits = 3, kOpcodes = 4 << 8; // four maps
struct OpcodeRun {
    uint32_t count, kind;
};
constexpr OpcodeRun kOpcodeRuns[] = {
#define OPCODE_RUN(count, kind) {count, kind},
#include "packer/model/opcodes.h"
};

// Expands the runs of opcodes.h to a table: the class of an opcode is at map << 8 | opcode. In the stub a run
// is one byte, the count above the class. The stub counts down to 0 in eight bits, so a count of 0 means 256.
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

struct X86Parser {
    enum Phase : uint32_t { kStart, kVex, kModrmByte, kSibByte, kDisplacement, kOperand, kJump };
    static_assert(kJump + 1 == kPhases && kPhases <= 1 << kPhaseBits);
    // In kStart, `left` has flags of the prefixes seen; above them the map: 1 for 0f, 2 for 0f38, 3 for 0f3a
    static constexpr uint32_t kSeenRex = 1, kSeenVex = 2, kMapShift = 2, kSeenMap = 1 << kMapShift;
    static constexpr uint32_t kPrefixShift = 16; // position of the prefix in kOpcode, above map and opcode
    static constexpr uint32_t kReturn = 0xc3;

    Phase phase;   // the part of an instruction that the next byte belongs to
    uint32_t left; // number of bytes of that part still to come
    uint32_t map, immediate;
    uint32_t high;     // bits of REX or VEX: 8 is W; 4 is R, which VEX inverts
    uint32_t relative; // size in bytes of the relative operand that comes now or next; 0: none
    bool begins;       // an instruction begins at the next byte

    // Parses the next byte. If it ends an operand that is relative to the next instruction, returns the
    // distance from this byte to that instruction; otherwise 0.
    uint32_t step(uint32_t *f, uint32_t b, const uint8_t *classes) {
        uint32_t toNext = 0;
        f[kSoFar] = mixIn(f[kSoFar], b);
        begins = false;
        switch (phase) {
        case kStart:
            if (prefix(f, b)) return 0;
            opcode(f, b, classes);
            if (phase == kModrmByte) return 0;
            break;
        case kVex:
            if (left == 2) map = b & 3;
            if (!high) high = b >> 5;
            if (--left) return 0;
            phase = kStart;
            left = map << kMapShift | kSeenVex;
            f[kOpcode] = (b & 7) << kPrefixShift;
            return 0;
        case kModrmByte:
            modrm(f, b);
            if (phase == kSibByte) return 0;
            break;
        case kSibByte:
            if (f[kModrm] < 0x40 && (b & 7) == 5) left = 4;
            phase = kDisplacement;
            break;
        case kDisplacement:
        case kOperand:
        case kJump:
            if (--left) return 0;
            if (relative) toNext = 1 + immediate;
            relative = 0;
        }
        if (left) return toNext;
        if (immediate) {
            phase = relative ? kJump : kOperand;
            left = immediate;
            immediate = 0;
        } else
            finish(f);
        return toNext;
    }

private:
    // Returns whether the byte is a prefix, and parses it.
    bool prefix(uint32_t *f, uint32_t b) {
        if (left >= kSeenMap) {
            bool second = left < kSeenMap + kSeenVex && (b & 0xfd) == 0x38;
            if (second) left += kSeenMap + (b - 0x38) * 2; // 0f 38, 0f 3a
            return second;
        }
        if ((b & 0xf0) == 0x40) {
            high = b & 15;
            left |= kSeenRex;
        } else if (b == 0x66 || (b & 0xfe) == 0xf2)
            f[kOpcode] |= b << kPrefixShift;
        else if (b == 0x0f)
            left |= kSeenMap;
        else if ((b & 0xfe) == 0xc4) {
            phase = kVex;
            left = 2 - (b & 1);
            map = 1;
        } else
            return false;
        return true;
    }

    void opcode(uint32_t *f, uint32_t b, const uint8_t *classes) {
        uint32_t number = left >> kMapShift << 8 | b;
        // The eight arithmetic operations, 00 .. 3f, have the same form
        uint32_t kind = classes[number < 0x40 ? number & 7 : number];
        f[kOpcode] |= number;
        immediate = kind & kImmediate32 ? 4 : kind >> 1;
        if (kind == kRelative8) immediate = 1;
        relative = kind >= kRelative32 ? immediate : 0;
        if (kind & kImmediate32 && !relative && f[kOpcode] >> kPrefixShift == 0x66) immediate = 2;
        if (kind == kImmediate32 && high & 8 && b >= 0xb8) immediate = 8;
        left = 0;
        if (kind & kHasModrm && !relative) phase = kModrmByte;
    }

    void modrm(uint32_t *f, uint32_t b) {
        f[kModrm] = b;
        f[kMode] = b & 0xc7;
        // f6 and f7: only TEST has an immediate operand
        if ((f[kOpcode] & 0xfffe) == 0xf6 && b & 0x30) immediate = 0;
        left = b >> 6 == 1 ? 1 : b >> 6 == 2 ? 4 : 0;
        if ((b & 0xc7) == 5) {
            relative = 4;
            left = 4;
        }
        phase = b < 0xc0 && (b & 7) == 4 ? kSibByte : kDisplacement;
    }

    // Ends the instruction.
    void finish(uint32_t *f) {
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
    }
};

} // namespace pack
