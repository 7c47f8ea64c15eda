// Part of the stubs: numbers shared with C++, and the layout of memory while decoding.

.intel_syntax noprefix

// --- Numbers shared with C++: names of C++, sizeof_TYPE, and MEMBER's offset as header_MEMBER, slot_MEMBER .. ---
#include "stub_numbers.s"

// Sets a 64-bit register to a number from -128 to 127, in three bytes.
#define SET_SMALL(register, value) push value; pop register

// Defines a name as the offset `next`, which then counts the name's size in bytes.
.macro place size, names:vararg
    .irp name, \names
        .set \name, next
        .set next, next + \size
    .endr
.endm

// --- Constants at the end of stub_rest.S, as offsets from rbx, which points to the payload header after them ---
.set next, -52
place 4, MOST, LEAST, ONE, SETTLED, SETTLED2, SETTLED3, EARLY_USES, EARLY_LEARNING, LEARNING, FINAL_LEARNING
place 4, STEEPNESS, MIDDLE, SCALE

// --- The model's memory, as offsets from rbp. rbp points after the first variables, so most offsets fit in a byte ---
.set FIELDS, -128
#define FIELD(number) FIELDS + 4 * (number)
// The parser's state, in the order in which it is cleared, then the decoder's state
.set next, FIELD(kFields)
place 4, PHASE, LEFT, HIGH, IMMEDIATE, RELATIVE, MAP, RANGE, CODE, POSITION, TYPE, FLIP
.set RESULTS, 0
.set STEP, RESULTS + 4 * kSets
.set AFTER, STEP + 4 // offset of the nibble's part of the counters that the last byte selects
.set ROWS, AFTER + 4 // in reverse order of the sets, like the results
.set BLOCK, ROWS + 8 * kSets
.set COUNTERS, BLOCK + 8
.set BYTE_SLOTS, COUNTERS + 8 * kContextCounters * (kMostContexts + 1) // the last entry is the correction's
.set HASHES, BYTE_SLOTS + 8 * (kMostContexts + 1)
.set INPUTS, HASHES + 4 * (kMostContexts + kSets)
.set OPCODES, INPUTS + ROW // aligned
.set FINAL_WEIGHTS, OPCODES + kOpcodes
.set WEIGHTS, FINAL_WEIGHTS + 4 * kSets * kPhases
.set ROW, 16 * (1 + kMostContexts)
.set USED, 12 // offset of the count of uses in a row
.set ALL_ROWS, kSets << kRowBits
.set CORRECTIONS, WEIGHTS + ALL_ROWS * ROW
.set HISTORIES, CORRECTIONS + (sizeof_Counter << (kCorrectionRowBits + kCorrectionBits))
.set SLOTS_FROM, HISTORIES + kMostContexts * kSharedCounters * sizeof_Counter - FIELDS
.set WAYS_SIZE, kWays * kNibbleSlots * sizeof_Slot
// Aligned, so that a mask finds the first slot of a nibble
.set SLOTS, SLOTS_FROM + WAYS_SIZE - 1 - (SLOTS_FROM + WAYS_SIZE - 1) % WAYS_SIZE + FIELDS
// The slots follow, then the coded bytes

.set AFTER_BITS, 14 // log2 of the size of a nibble's part of the counters that the last byte selects

// --- Assumptions of the code about these values ---
#define EQUAL(a, b) .ifne (a) - (b); .error "these are not equal"; .endif
.macro ascending first, names:vararg
    .set next, \first
    .irp name, \names
        EQUAL(\name, next)
        .set next, next + 1
    .endr
.endm
ascending 0, kParserState, kColumn, kByte5 // fields up to kToMark are written one after another
EQUAL(kToMark, kByte1 + 1)
ascending kOpcode1, kOpcode1, kOpcode2, kOpcode3 // both are copied at once
// The fields from kOpcode on are cleared together with the parser's state
ascending kOpcode, kOpcode, kMode, kSoFar, kModrm, kFields
ascending 0, kStart, kVex, kModrmByte, kSibByte, kDisplacement // phases are compared in this order
EQUAL(kJump, kOperand + 1)
EQUAL(kRelative8, kRelative32 + 1)
EQUAL(sizeof_CodedByte, 2) // lodsw loads one
EQUAL(kCodeMask, 2)
EQUAL(kDataMask, 1)
EQUAL(kMarkTarget, 0x80) // the sign bit of a byte
EQUAL(slot_counter, 0) // a new slot is its check, shifted up
EQUAL(slot_check, sizeof_Slot - 2)
EQUAL(sizeof_Slot * kNibbleSlots, 128) // subtracting -128 takes an immediate byte, adding 128 would take four
EQUAL(sizeof_Counter, 4) // its lowest byte counts the bits seen
EQUAL(kSeenBits, 8)
EQUAL(kHistoryFull, 128) // the sign bit of a byte
EQUAL(1 << AFTER_BITS, 256 * kNibbleSlots * sizeof_Counter)
EQUAL((SLOTS - FIELDS) & (WAYS_SIZE - 1), 0)
EQUAL((INPUTS | FINAL_WEIGHTS | WEIGHTS) & 15, 0) // vectors
EQUAL(FLIP + 8, RESULTS) // the variables end before RESULTS, which is aligned; four bytes are free
