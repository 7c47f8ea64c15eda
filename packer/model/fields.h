// What the model needs from every kind of code: x86-64 (x86_tracker.h) or WebAssembly
// (packer/web/wasm_tracker.h).
//
// The model is a template of a class `Tracker`, which follows the program byte by byte. A tracker has
// - fields, numbered from the two below on, and mayUse, the fields that contexts may use;
// - the coded bytes, with kPast zero bytes before the first and kFuture after the last;
// - begin(), which computes the fields of a byte, end(), which parses that byte, and odds() of its next bit.
// The specialisation filter<Tracker>() returns the bytes that are coded.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace pack {

// The two fields of every kind of code. kParserState is part of every context: the parser's count of bytes
// and its phase, count << kPhaseBits | phase. kColumn is the offset modulo kColumns
constexpr uint32_t kParserState = 0, kColumn = 1;
constexpr uint32_t kPhases = 7, kPhaseBits = 3, kColumns = 4;
constexpr uint32_t kMostFields = 32;

constexpr uint32_t kPast = 128;   // zero bytes before the first coded byte
constexpr uint32_t kFuture = 256; // zero bytes after the last one

constexpr uint32_t kHash = 0x2c9277b5, kHashShift = 15;

static inline uint32_t mixIn(uint32_t hash, uint32_t value) {
    hash = (hash + value + 1) * kHash;
    return hash ^ hash >> kHashShift;
}

// The odds of a one against a zero. Both are equal if nothing is known.
struct Odds {
    uint32_t ones, zeros;
};

// Masks of the fields that contexts may use, [0] in code and [1] in data. Bit 0 stands for kColumn.
struct MayUse {
    uint32_t codeShift, codeBits, dataBits;
    constexpr uint32_t operator[](int type) const {
        return type ? (1u << dataBits) - 1 : ((1u << codeBits) - 1) << codeShift;
    }
};

} // namespace pack
