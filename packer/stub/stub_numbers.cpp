// The numbers that the stubs share with C++. The compiler writes each as a line of assembler, ".set NAME,
// VALUE", which stub_memory.S includes.
#include "packer/stub/loader_format.h"
#include "packer/stub/pe_format.h"

#include <bit>

namespace pack {

// clang-format off
#define SET(name, value) asm volatile(".set " #name ", %c0" ::"i"((int64_t)(value)));
#define NUMBER(name) SET(name, name)
#define FLOAT(name, value) SET(name, std::bit_cast<uint32_t>((float)(value)))
#define SIZE(type) SET(sizeof_##type, sizeof(type))
#define HEADER(member) SET(header_##member, offsetof(PayloadHeader, member))
#define LAYOUT(member) SET(header_##member, offsetof(PayloadHeader, layout) + offsetof(Layout, member))
#define SLOT(member) SET(slot_##member, offsetof(Slot, member))
#define MESSAGE(member) SET(message_##member, offsetof(PeMessages, member))
#define EHDR(member) SET(member, offsetof(Elf64_Ehdr, member))
#define PHDR(member) SET(member, offsetof(Elf64_Phdr, member))
#define PARSER(name) SET(name, X86Parser::name)

[[gnu::used]] static void stubNumbers() {
    // The packed file
    SIZE(Front) SIZE(LoaderFront) SIZE(PayloadHeader) NUMBER(kPage) NUMBER(kEarlyStep)
    HEADER(words) HEADER(image) HEADER(readOnly) HEADER(imports) HEADER(entry) HEADER(early) HEADER(earlyEntry)
    LAYOUT(size) LAYOUT(codeBegin) LAYOUT(codeSize) HEADER(memory) HEADER(contexts) HEADER(slotShift)
    NUMBER(kCodeMask) NUMBER(kDataMask) NUMBER(kCodeShift)

    // ELF, for stub_loader.S
    EHDR(e_entry) EHDR(e_phoff) EHDR(e_phnum) SIZE(Elf64_Phdr)
    PHDR(p_type) PHDR(p_flags) PHDR(p_offset) PHDR(p_vaddr) PHDR(p_filesz) PHDR(p_memsz)
    SET(PT_LOAD, PT_LOAD) SET(PT_INTERP, PT_INTERP)
    SET(AT_PHDR, AT_PHDR) SET(AT_PHNUM, AT_PHNUM) SET(AT_BASE, AT_BASE) SET(AT_ENTRY, AT_ENTRY)

    // On Windows
    SIZE(PeStart) SET(sizeof_slots, sizeof(PeStart::slots)) SET(front_messages, offsetof(PeFront, messages))
    SET(front_fileSize, offsetof(PeFront, sections[0].fileSize)) SET(kMessage, sizeof(PeMessages::damaged) - 1)
    MESSAGE(mayNotRun) MESSAGE(damaged) MESSAGE(noMemory) MESSAGE(user32) MESSAGE(messageBox)
    NUMBER(kPeProgram1) NUMBER(kPeLoadLibrary) NUMBER(kPeGetProcAddress) NUMBER(kPeVirtualAlloc) NUMBER(kPeVirtualFree)
    NUMBER(kPeVirtualProtect) NUMBER(kPeGetStdHandle) NUMBER(kPeWriteFile) NUMBER(kPeExitProcess)

    // Fields and coded bytes
    NUMBER(kParserState) NUMBER(kColumn) NUMBER(kByte5) NUMBER(kByte1) NUMBER(kToMark) NUMBER(kTarget) NUMBER(kFunction)
    NUMBER(kWritten1) NUMBER(kWritten2) NUMBER(kInstruction1) NUMBER(kOpcode1) NUMBER(kOpcode2) NUMBER(kOpcode3)
    NUMBER(kOpcode) NUMBER(kMode) NUMBER(kSoFar) NUMBER(kModrm) NUMBER(kFields)
    NUMBER(kPhaseBits) NUMBER(kPhases) NUMBER(kColumns) NUMBER(kHash) NUMBER(kHashShift)
    NUMBER(kFarMark) NUMBER(kMarkTarget) NUMBER(kMarkBegin) NUMBER(kFuture)
    SIZE(CodedByte) SET(coded_marks, offsetof(CodedByte, marks))

    // The parser
    PARSER(kStart) PARSER(kVex) PARSER(kModrmByte) PARSER(kSibByte) PARSER(kDisplacement) PARSER(kOperand) PARSER(kJump)
    PARSER(kReturn) PARSER(kSeenRex) PARSER(kSeenVex) PARSER(kSeenMap) PARSER(kMapShift) PARSER(kPrefixShift)
    NUMBER(kOpcodes) NUMBER(kClassBits) NUMBER(kHasModrm) NUMBER(kImmediate32) NUMBER(kRelative32) NUMBER(kRelative8)

    // Slots and counters
    SIZE(Slot) SLOT(counter) SLOT(history) SLOT(lastByte) SLOT(check) SIZE(Counter)
    NUMBER(kSeenBits) NUMBER(kProbabilityBits) NUMBER(kHalf) NUMBER(kCertain) NUMBER(kFirstTrust) NUMBER(kHistoryFull)
    NUMBER(kNibbleSlots) NUMBER(kWays) NUMBER(kHistories) NUMBER(kPhaseCounters) NUMBER(kSharedCounters)

    // The model
    NUMBER(kMostContexts) NUMBER(kSets) NUMBER(kRowBits) NUMBER(kContextCounters) NUMBER(kLinearShift) NUMBER(kOddsShift)
    NUMBER(kCorrectionRowBits) NUMBER(kCorrectionBits) NUMBER(kRangeBits) NUMBER(kShareBits)
    FLOAT(kOne, 1) FLOAT(kMostSum, kMostSum) FLOAT(kSettled0, kSettled[0]) FLOAT(kSettled1, kSettled[1])
    FLOAT(kSettled2, kSettled[2]) FLOAT(kConstant, kConstant) FLOAT(kFirstWeight, kFirstWeight)
    FLOAT(kEarlyUses, kEarlyUses) FLOAT(kEarlyLearning, kEarlyLearning) FLOAT(kLearning, kLearning)
    FLOAT(kFinalLearning, kFinalLearning) FLOAT(kSteepness, kSteepness) FLOAT(kMiddle, kMiddle)
    FLOAT(kScale, 1 << kProbabilityBits)
}

} // namespace pack
