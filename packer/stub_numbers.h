// The numbers that the stub shares with C++: STUB_NUMBER(name in the stub, value, what it is in C++). The
// assembler takes names and values from here (stub.S), and C++ compiles only where each value is what the
// last column says (stub.h). A value may use the names above it. What is not here is the stub's own: how it
// lays out its memory, the kernel's calls, x86 opcodes, which are Intel's.
// clang-format off

STUB_NUMBER(FRONT, 528, sizeof(Front))
// Parameters, in front of masks and payload
STUB_NUMBER(WORDS, 0, offsetof(Parameters, words))
STUB_NUMBER(IMAGE, 4, offsetof(Parameters, image))
STUB_NUMBER(READ_ONLY, 8, offsetof(Parameters, readOnly))
STUB_NUMBER(IMPORTS, 12, offsetof(Parameters, imports))
STUB_NUMBER(ENTRY, 16, offsetof(Parameters, entry))
STUB_NUMBER(EARLY, 20, offsetof(Parameters, early))
STUB_NUMBER(EARLY_ENTRY, 24, offsetof(Parameters, earlyEntry))
STUB_NUMBER(SIZE, 28, offsetof(Parameters, layout) + offsetof(Layout, size))
STUB_NUMBER(CODE_BEGIN, 32, offsetof(Parameters, layout) + offsetof(Layout, codeBegin))
STUB_NUMBER(CODE_SIZE, 36, offsetof(Parameters, layout) + offsetof(Layout, codeSize))
STUB_NUMBER(MEMORY, 40, offsetof(Parameters, memory))
STUB_NUMBER(CONTEXTS, 44, offsetof(Parameters, contexts))
STUB_NUMBER(SLOT_SHIFT, 45, offsetof(Parameters, slotShift))
STUB_NUMBER(MASKS, 46, sizeof(Parameters))
STUB_NUMBER(MASK, 2, sizeof(Shape::masks[0][0]))
STUB_NUMBER(PAGE, 4096, kPage)
STUB_NUMBER(EARLY_STEP, 2048, kEarlyStep)

// On Windows
STUB_NUMBER(PE_START, 264, sizeof(PeStart))
STUB_NUMBER(PE_SLOTS, 88, sizeof(PeStart::slots))
STUB_NUMBER(PE_FILE_SIZE, 344, offsetof(PeFront, sections[0].fileSize))

// Hashes
STUB_NUMBER(HASH, 0x2c9277b5, kHash)
STUB_NUMBER(HASH_SHIFT, 15, kHashShift)
STUB_NUMBER(HASH_BITS, 32, 8 * sizeof(kHash))

// Fields, by number
STUB_NUMBER(FIELD_WHERE, 0, kWhere)
STUB_NUMBER(FIELD_BYTE1, 1, kByte1)
STUB_NUMBER(FIELD_BYTE5, 5, kByte5)
STUB_NUMBER(FIELD_COLUMN, 6, kColumn)
STUB_NUMBER(FIELD_TARGET, 7, kTarget)
STUB_NUMBER(FIELD_INSTRUCTION1, 8, kInstruction1)
STUB_NUMBER(FIELD_OPCODE1, 9, kOpcode1)
STUB_NUMBER(FIELD_OPCODE2, 10, kOpcode2)
STUB_NUMBER(FIELD_OPCODE3, 11, kOpcode3)
STUB_NUMBER(FIELD_MODRM1, 12, kModrm1)
STUB_NUMBER(FIELD_OPCODE, 13, kOpcode)
STUB_NUMBER(FIELD_MODRM, 14, kModrm)
STUB_NUMBER(FIELD_MODE, 15, kMode)
STUB_NUMBER(FIELD_SO_FAR, 16, kSoFar)
STUB_NUMBER(FIELD_COUNT, 17, kFields)
STUB_NUMBER(PHASE_BITS, 3, kPhaseBits)
STUB_NUMBER(PHASES, 6, kPhases)
STUB_NUMBER(COLUMNS, 4, kColumns)

// The parser
STUB_NUMBER(PHASE_START, 0, Parser::kStart)
STUB_NUMBER(PHASE_VEX, 1, Parser::kVex)
STUB_NUMBER(PHASE_MODRM, 2, Parser::kModrmByte)
STUB_NUMBER(PHASE_SIB, 3, Parser::kSibByte)
STUB_NUMBER(PHASE_DISPLACEMENT, 4, Parser::kDisplacement)
STUB_NUMBER(PHASE_OPERAND, 5, Parser::kOperand)
STUB_NUMBER(SEEN_REX, 1, Parser::kSeenRex)
STUB_NUMBER(SEEN_VEX, 2, Parser::kSeenVex)
STUB_NUMBER(SEEN_MAP, 4, Parser::kSeenMap)
STUB_NUMBER(MAP_SHIFT, 2, Parser::kMapShift)
STUB_NUMBER(PREFIX_SHIFT, 16, Parser::kPrefixShift)
STUB_NUMBER(OPCODE_CLASSES, 1024, kOpcodes)
STUB_NUMBER(CLASS_BITS, 3, kClassBits)
STUB_NUMBER(HAS_MODRM, 1, kHasModrm)
STUB_NUMBER(IMMEDIATE32, 4, kImmediate32)
STUB_NUMBER(RELATIVE32, 6, kRelative32)

// Slots and counters
STUB_NUMBER(COUNTER, 4, sizeof(Counter))
STUB_NUMBER(SEEN_BITS, 8, kSeenBits)
STUB_NUMBER(PROBABILITY_BITS, 24, kProbabilityBits)
STUB_NUMBER(HALF, 0x800000, kHalf)
STUB_NUMBER(CERTAIN, 0x7fffff, kCertain)
STUB_NUMBER(FIRST_TRUST, 10, kFirstTrust)
STUB_NUMBER(SLOT, 8, sizeof(Slot))
STUB_NUMBER(SLOT_COUNTER, 0, offsetof(Slot, counter))
STUB_NUMBER(SLOT_HISTORY, 4, offsetof(Slot, history))
STUB_NUMBER(SLOT_LAST_BYTE, 5, offsetof(Slot, lastByte))
STUB_NUMBER(SLOT_CHECK, 6, offsetof(Slot, check))
STUB_NUMBER(HISTORY_FULL, 128, kHistoryFull)
STUB_NUMBER(NIBBLE_SLOTS, 16, kNibbleSlots)

// The model
STUB_NUMBER(MOST_CONTEXTS, 24, kMostContexts)
STUB_NUMBER(SETS, 8, kSets)
STUB_NUMBER(SET_ROW_BITS, 12, kRowBits)
STUB_NUMBER(CONTEXT_INPUTS, 3, kContextInputs)
STUB_NUMBER(MOST_INPUTS, 72, kMostInputs)
STUB_NUMBER(AFTER_LAST, 4 * 256, sizeof(Context::shared[0].histories))
STUB_NUMBER(SHARED, AFTER_LAST + 4 * 256 * 256, sizeof(Context::shared[0]))
STUB_NUMBER(CORRECTION_ROW_BITS, 16, kCorrectionRowBits)
STUB_NUMBER(CORRECTION_BITS, 5, kCorrectionBits)
STUB_NUMBER(RANGE_BITS, 24, kRangeBits)
STUB_NUMBER(SHARE_BITS, 20, kShareBits)

// Floats, as their bits
STUB_NUMBER(ONE_BITS, 0x3f800000, bits(1))
STUB_NUMBER(MOST_BITS, 0x4cfdea11, bits(kMostSum))
STUB_NUMBER(SETTLED0_BITS, 0x3f866666, bits(kSettled[0]))
STUB_NUMBER(SETTLED1_BITS, 0x3f866666, bits(kSettled[1]))
STUB_NUMBER(SETTLED2_BITS, 0x3fa66666, bits(kSettled[2]))
STUB_NUMBER(FIRST_WEIGHT_BITS, 0x3d4ccccd, bits(kFirstWeight))
STUB_NUMBER(LEARNING_BITS, 0x300df4e0, bits(kLearning))
STUB_NUMBER(FINAL_LEARNING_BITS, 0x2eb17218, bits(kFinalLearning))
STUB_NUMBER(STEEPNESS_BITS, 0x33ddce9e, bits(kSteepness))
STUB_NUMBER(MIDDLE_BITS, 0x41800000, bits(kMiddle))
STUB_NUMBER(SCALE_BITS, 0x4b800000, bits(1 << kProbabilityBits))
// clang-format on
#undef STUB_NUMBER
