// What the model asks of every kind of code: x86-64 (surroundings.h), or WebAssembly
// (packer/web/surroundings.h).
//
// The model is a template of a class `Around`, which knows what surrounds a place. It has fields, numbered
// from the two below on, and says which of them contexts may use (mayUse); the places of the program, with
// kPast before them and kFuture behind; begin() and end() of a byte; and the odds of a bit. Its filter()
// makes the bytes that are coded.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace pack {

// used by every context: what the next byte is part of, `... << kPhaseBits | phase`; the address modulo
// kColumns
constexpr uint32_t kWhere = 0, kColumn = 1;
constexpr uint32_t kPhases = 7, kPhaseBits = 3, kColumns = 4;
constexpr uint32_t kMostFields = 32;

constexpr uint32_t kPast = 128;   // zeros that stand for the places before the first one
constexpr uint32_t kFuture = 256; // ... and for those after the last one

constexpr uint32_t kHash = 0x2c9277b5, kHashShift = 15;

static inline uint32_t mixIn(uint32_t hash, uint32_t value) {
    hash = (hash + value + 1) * kHash;
    return hash ^ hash >> kHashShift;
}

// The odds of a one against a zero. Equal if nothing is known.
struct Odds {
    uint32_t ones, zeros;
};

// Which fields contexts may use: in code (0) and in data (1). The bits of a mask are fields from kColumn on;
// in code those above `shift`.
struct MayUse {
    uint32_t codeShift, codeBits, dataBits;
    constexpr uint32_t operator[](int type) const {
        return type ? (1u << dataBits) - 1 : ((1u << codeBits) - 1) << codeShift;
    }
};

} // namespace pack
