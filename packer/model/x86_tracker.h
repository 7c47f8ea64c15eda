// The tracker (fields.h) of x86-64 code.
//
// The parser finds where instructions begin and which bytes are targets of relative operands. The tracker
// marks these bytes. A forward jump marks its target before the target is decoded. The marks predict the last
// byte of an operand, because it is likely to point to a marked byte.
#pragma once

#include "packer/model/x86.h"

namespace pack {

// A byte as it was coded, and its marks: kMarkTarget, kMarkBegin.
struct CodedByte {
    uint8_t byte, marks;
};
constexpr uint8_t kMarkTarget = 128; // the byte is the target of a relative operand
constexpr uint8_t kMarkBegin = 48;   // an instruction begins at the byte

static_assert(kPast >= 5 && kPast >= 127 && kFuture >= kFarMark);

struct X86Tracker {
    using CodedByte = pack::CodedByte;
    static constexpr MayUse mayUse = kMayUse;
    static constexpr uint32_t kTarget = pack::kTarget;
    static void prepare(uint8_t *opcodes) { expandOpcodes(opcodes); }

    uint32_t fields[kFields];
    X86Parser parser;
    CodedByte *coded; // the first of `size` bytes; kPast bytes precede them, kFuture bytes follow
    uint32_t size;
    // If the next byte is the last one of a relative operand, its value selects one of 256 possible targets:
    // block[byte ^ flip]. Otherwise `block` is null
    const CodedByte *block;
    uint32_t flip;

    // Computes the fields of byte i, before it is coded.
    void begin(uint32_t i) {
        const CodedByte *now = coded + i;
        for (uint32_t k = 0; k < 5; ++k) fields[kByte1 - k] = (now - k - 1)->byte;
        fields[kParserState] = parser.left << kPhaseBits | parser.phase;
        fields[kColumn] = i % kColumns;
        uint32_t distance = 0;
        while (distance < kFarMark && !(now[distance].marks & kMarkTarget)) ++distance;
        fields[kToMark] = distance;

        block = nullptr;
        if (!parser.relative || parser.left != 1) return;
        uint32_t first = fields[kByte3] << 24 | fields[kByte2] << 16 | fields[kByte1] << 8;
        flip = 0;
        if (parser.relative == 1) {
            flip = 128; // the byte is signed
            block = now + 1 - 128;
        } else if (first < size)
            block = coded + first;
    }

    // Returns the odds of a one by the marks alone. `bits`: a leading one, then the byte's bits so far.
    Odds odds(uint32_t bits) const {
        if (!block) return {1, 1};
        uint32_t half = 128u >> (31 - __builtin_clz(bits)), from = bits * half * 2;
        auto sum = [&](uint32_t byte) {
            uint32_t all = half;
            for (uint32_t k = 0; k < half; ++k) all += block[((byte + k) & 255) ^ flip].marks;
            return all;
        };
        return {sum(from + half), sum(from)};
    }

    // Parses byte i of code, which was coded as `byte`. If it ends a four-byte operand that is relative to
    // the next instruction, returns the distance from this byte to that instruction; otherwise 0.
    uint32_t end(uint32_t i, uint8_t byte, const uint8_t *opcodes) {
        CodedByte *now = coded + i;
        now->byte = byte;
        uint32_t relative = parser.relative, toNext = parser.step(fields, byte, opcodes);
        if (parser.begins) now[1].marks |= kMarkBegin;
        if (!toNext) return 0;
        uint32_t target = i + 1 + (uint32_t)(int8_t)byte;
        if (relative == 4)
            target = (uint32_t)now[-3].byte << 24 | (uint32_t)now[-2].byte << 16 |
                     (uint32_t)now[-1].byte << 8 | byte;
        fields[kTarget] = target;
        if (target < size) coded[target].marks |= kMarkTarget;
        return relative == 4 ? toNext : 0;
    }
};

} // namespace pack
