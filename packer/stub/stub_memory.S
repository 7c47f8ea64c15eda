// Part of the stubs: numbers shared with C++, and the layout of memory while decoding.

.intel_syntax noprefix

// --- Numbers shared with C++ ---
#define STUB_NUMBER(name, value, meaning) .set name, value;
#include "packer/stub/stub_numbers.h"

// --- Constants at the end of stub_rest.S, as offsets from rbx, which points to the payload header after them ---
.set MOST, -52
.set LEAST, -48
.set ONE, -44
.set SETTLED, -40 // three floats
.set EARLY_USES, -28
.set EARLY_LEARNING, -24
.set LEARNING, -20
.set FINAL_LEARNING, -16
.set STEEPNESS, -12
.set MIDDLE, -8
.set SCALE, -4

// --- The model's memory, as offsets from rbp. rbp points after the first variables, so most offsets fit in a byte ---
.set FIELDS, -128
.set PARSER_STATE, FIELDS + 4 * FIELD_PARSER_STATE
.set TARGET, FIELDS + 4 * FIELD_TARGET
.set FUNCTION, FIELDS + 4 * FIELD_FUNCTION
.set WRITTEN1, FIELDS + 4 * FIELD_WRITTEN1
.set WRITTEN2, FIELDS + 4 * FIELD_WRITTEN2
.set INSTRUCTION1, FIELDS + 4 * FIELD_INSTRUCTION1
.set OPCODE1, FIELDS + 4 * FIELD_OPCODE1
.set OPCODE2, FIELDS + 4 * FIELD_OPCODE2
.set OPCODE, FIELDS + 4 * FIELD_OPCODE
.set MODRM, FIELDS + 4 * FIELD_MODRM
.set MODE, FIELDS + 4 * FIELD_MODE
.set SO_FAR, FIELDS + 4 * FIELD_SO_FAR
// The parser's state, in the order in which it is cleared, then the decoder's state
.set PHASE, FIELDS + 4 * FIELD_COUNT
.set LEFT, PHASE + 4
.set HIGH, LEFT + 4
.set IMMEDIATE, HIGH + 4
.set RELATIVE, IMMEDIATE + 4
.set MAP, RELATIVE + 4
.set RANGE, MAP + 4
.set CODE, RANGE + 4
.set POSITION, CODE + 4
.set TYPE, POSITION + 4
.set FLIP, TYPE + 4
.set RESULTS, 0
.set STEP, RESULTS + 4 * SETS
.set AFTER, STEP + 4 // offset of the nibble's part of the counters that the last byte selects
.set ROWS, AFTER + 4 // in reverse order of the sets, like the results
.set BLOCK, ROWS + 8 * SETS
.set COUNTERS, BLOCK + 8
.set BYTE_SLOTS, COUNTERS + 8 * CONTEXT_COUNTERS * (MOST_CONTEXTS + 1) // the last entry is the correction's
.set HASHES, BYTE_SLOTS + 8 * (MOST_CONTEXTS + 1)
.set INPUTS, HASHES + 4 * (MOST_CONTEXTS + SETS)
.set OPCODES, INPUTS + ROW // aligned
.set FINAL_WEIGHTS, OPCODES + OPCODE_CLASSES
.set WEIGHTS, FINAL_WEIGHTS + 4 * SETS * PHASES
.set ROW, 16 * (1 + MOST_CONTEXTS)
.set USED, 12 // offset of the count of uses in a row
.set ALL_ROWS, SETS << SET_ROW_BITS
.set CORRECTIONS, WEIGHTS + ALL_ROWS * ROW
.set HISTORIES, CORRECTIONS + (COUNTER << (CORRECTION_ROW_BITS + CORRECTION_BITS))
.set SLOTS_FROM, HISTORIES + MOST_CONTEXTS * SHARED - FIELDS
.set WAYS_SIZE, WAYS * NIBBLE_SLOTS * SLOT
// Aligned, so that a mask finds the first slot of a nibble
.set SLOTS, SLOTS_FROM + WAYS_SIZE - 1 - (SLOTS_FROM + WAYS_SIZE - 1) % WAYS_SIZE + FIELDS
// The slots follow, then the coded bytes

.set AFTER_BITS, 14 // log2 of the size of a nibble's part of the counters that the last byte selects

// --- Assumptions of the code about these values ---
#define EQUAL(a, b) .ifne (a) - (b); .error "these are not equal"; .endif
EQUAL(FIELD_PARSER_STATE, 0) // fields up to FIELD_TO_MARK are written one after another
EQUAL(FIELD_COLUMN, 1)
EQUAL(FIELD_BYTE5, 2)
EQUAL(FIELD_TO_MARK, FIELD_BYTE1 + 1)
EQUAL(FIELD_OPCODE2, FIELD_OPCODE1 + 1) // both are copied at once
EQUAL(FIELD_OPCODE3, FIELD_OPCODE1 + 2)
EQUAL(FIELD_MODE, FIELD_OPCODE + 1) // the fields from OPCODE on are cleared together with the parser's state
EQUAL(FIELD_SO_FAR, FIELD_OPCODE + 2)
EQUAL(FIELD_MODRM, FIELD_OPCODE + 3)
EQUAL(FIELD_COUNT, FIELD_OPCODE + 4)
EQUAL(PHASE_START, 0) // phases are compared in this order
EQUAL(PHASE_VEX, 1)
EQUAL(PHASE_MODRM, 2)
EQUAL(PHASE_SIB, 3)
EQUAL(PHASE_DISPLACEMENT, 4)
EQUAL(PHASE_JUMP, PHASE_OPERAND + 1)
EQUAL(RELATIVE8, RELATIVE32 + 1)
EQUAL(CODED_BYTE, 2) // lodsw loads one
EQUAL(CODE_MASK, 2)
EQUAL(DATA_MASK, 1)
EQUAL(MARK_TARGET, 0x80) // the sign bit of a byte
EQUAL(SLOT_COUNTER, 0) // a new slot is its check, shifted up
EQUAL(SLOT_CHECK, SLOT - 2)
EQUAL(SLOT * NIBBLE_SLOTS, 128) // subtracting -128 takes an immediate byte, adding 128 would take four
EQUAL(COUNTER, 4) // its lowest byte counts the bits seen
EQUAL(SEEN_BITS, 8)
EQUAL(HISTORY_FULL, 128) // the sign bit of a byte
EQUAL(1 << AFTER_BITS, 256 * NIBBLE_SLOTS * COUNTER)
EQUAL((SLOTS - FIELDS) & (WAYS_SIZE - 1), 0)
EQUAL((INPUTS | FINAL_WEIGHTS | WEIGHTS) & 15, 0) // vectors
EQUAL(FLIP + 8, RESULTS) // the variables end before RESULTS, which is aligned; four bytes are free
