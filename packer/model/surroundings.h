// What is known at a place in the program before its byte is decoded: the fields, and how likely the targets
// of a relative operand are.
//
// The parser finds where instructions begin and which places they name; both are noted beside the bytes.
// Since jumps go forward, too, places are known that are not decoded yet.
#pragma once

#include "packer/model/x86.h"

namespace pack {

// A byte as it was coded, and the marks of its place, kNamed and kBegins.
struct Place {
    uint8_t byte, marks;
};
constexpr uint8_t kNamed = 128; // an operand that is relative to its instruction named the place
constexpr uint8_t kBegins = 48; // an instruction begins there

static_assert(kPast >= 5 && kPast >= 127 && kFuture >= kFarMark);

struct Surroundings {
    using Place = pack::Place;
    static constexpr MayUse mayUse = kMayUse;
    static constexpr uint32_t kTarget = pack::kTarget;
    static void prepare(uint8_t *opcodes) { expandOpcodes(opcodes); }

    uint32_t fields[kFields];
    Parser parser;
    Place *places; // the first of `size`, with kPast before them and kFuture after them
    uint32_t size;
    // If the byte to come ends an operand that is relative to its instruction, this byte selects one of 256
    // places; null otherwise. Place block[byte ^ flip]
    const Place *block;
    uint32_t flip;

    // Before byte i.
    void begin(uint32_t i) {
        const Place *now = places + i;
        for (uint32_t k = 0; k < 5; ++k) fields[kByte1 - k] = (now - k - 1)->byte;
        fields[kWhere] = parser.left << kPhaseBits | parser.phase;
        fields[kColumn] = i % kColumns;
        uint32_t far = 0;
        while (far < kFarMark && !(now[far].marks & kNamed)) ++far;
        fields[kToMark] = far;

        block = nullptr;
        if (!parser.relative || parser.left != 1) return;
        uint32_t first = fields[kByte3] << 24 | fields[kByte2] << 16 | fields[kByte1] << 8;
        flip = 0;
        if (parser.relative == 1) {
            flip = 128; // the byte has a sign
            block = now + 1 - 128;
        } else if (first < size)
            block = places + first;
    }

    // The odds of a one against a zero, by the marks alone, after `bits`: a leading one, then the byte's bits
    // so far.
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

    // After byte i of code, which was coded as `byte`. If it ends an operand of four bytes that is relative
    // to the next instruction's address, returns how far that address is from this byte; otherwise 0.
    uint32_t end(uint32_t i, uint8_t byte, const uint8_t *opcodes) {
        Place *now = places + i;
        now->byte = byte;
        uint32_t relative = parser.relative, behind = parser.step(fields, byte, opcodes);
        if (parser.begins) now[1].marks |= kBegins;
        if (!behind) return 0;
        uint32_t target = i + 1 + (uint32_t)(int8_t)byte;
        if (relative == 4)
            target = (uint32_t)now[-3].byte << 24 | (uint32_t)now[-2].byte << 16 |
                     (uint32_t)now[-1].byte << 8 | byte;
        fields[kTarget] = target;
        if (target < size) places[target].marks |= kNamed;
        return relative == 4 ? behind : 0;
    }
};

} // namespace pack
