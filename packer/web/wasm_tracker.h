// The tracker (packer/model/fields.h) of a page's payload: scripts, then a WebAssembly program. Its match
// model predicts the byte that followed the last occurrence of the same five bytes.
#pragma once

#include "packer/model/fields.h"

#include <initializer_list>

namespace pack::web {

enum WasmField {
    kByte5 = kColumn + 1, // the fifth-last byte
    kByte4,
    kByte3,
    kByte2,
    kByte1,        // the last byte
    kLocal1,       // in code: the last local used; elsewhere: hash of this word's letters so far
    kLocal2,       // in code: the second-last local used; elsewhere: hash of the word before
    kLocal3,       // in code: the third-last local used
    kSet,          // the local that was set last
    kUnread1,      // the most recently set local that has not been read yet
    kUnread2,      // the local set before that and not read yet
    kFollows,      // the local that followed the last use of kLocal1
    kOffset,       // offset of the last access to memory
    kOffsetOf,     // offset of the last access to memory that followed kLocal1
    kLast,         // the operand of the last instruction with the same opcode
    kDepth,        // nesting depth of blocks
    kTop1,         // opcode that made the topmost operand on the stack
    kTop2,         // opcode that made the operand below it
    kStack,        // number of operands on the stack, as far as known
    kInstruction1, // hashes of the last three instructions
    kInstruction2,
    kInstruction3,
    kOpcode1, // opcodes of the last four instructions
    kOpcode2,
    kOpcode3,
    kOpcode4,
    kOpcode, // this instruction's opcode, as far as it is known
    kSoFar,  // hash of this instruction's bytes so far
    kFields,
    kTarget = kLocal2 // the last field that contexts outside code may use
};

static_assert(kFields <= kMostFields);

// The effect of an instruction on the stack: twice the number of operands that it pops, plus 1 if it pushes
// one. A call counts as seven pops and a push. Indexed as in WasmParser::opcode().
constexpr uint8_t kUnary = 3, kBinary = 5;
struct StackEffects {
    struct Range {
        uint32_t from, to;
    };
    uint8_t of[1024] = {};
    constexpr void set(uint8_t effect, std::initializer_list<Range> ranges) {
        for (Range range : ranges)
            for (uint32_t i = range.from; i <= range.to; ++i) of[i] = effect;
    }
    constexpr StackEffects() {
        set(kBinary, {{0x46, 0xa6}, {525, 593}, {596, 599}, {613, 735}, {740, 747}, {768, 768}, {781, 790}});
        set(kUnary,
            {{0x22, 0x22}, {0x28, 0x35}, {0x40, 0x40}, {0x45, 0x45}, {0x50, 0x50}, {0x67, 0x69}, {0x79, 0x7b},
             {0x8b, 0x91}, {0x99, 0x9f}, {0xa7, 0xc4}, {256, 263},   {512, 522},   {527, 534},   {536, 537},
             {539, 539},   {541, 541},   {543, 543},   {545, 545},   {589, 589},   {595, 595},   {604, 612},
             {615, 618},   {628, 629},   {634, 634},   {636, 640},   {643, 644},   {647, 650},   {660, 660},
             {672, 672},   {675, 676},   {679, 682},   {704, 704},   {707, 708},   {711, 714},   {736, 737},
             {739, 739},   {760, 767},   {769, 772}});
        set(1, {{0x20, 0x20}, {0x23, 0x23}, {0x3f, 0x3f}, {0x41, 0x44}, {524, 524}});
        set(2, {{0x04, 0x04}, {0x0d, 0x0e}, {0x1a, 0x1a}, {0x21, 0x21}, {0x24, 0x24}});
        set(4, {{0x36, 0x3e}, {523, 523}, {600, 603}});
        set(6, {{264, 267}});
        set(7, {{0x1b, 0x1b}, {594, 594}, {773, 780}});
        set(15, {{0x10, 0x11}});
    }
};
constexpr StackEffects kEffects;

struct WasmParser {
    enum Phase : uint32_t { kHead, kOpcodeByte, kPrefixed, kNumber, kSecondNumber, kRaw, kData };
    // In kHead `count` is one of these: the size of a function, then the number of groups of its locals, then
    // the count and the type of each group
    enum Head : uint32_t { kFunctionSize, kGroups, kGroupCount, kGroupType };
    static constexpr uint32_t kTables = 1024, kUnreads = 8;

    uint32_t phase, count; // the part that the next byte belongs to, and how many of its bytes came before
    uint32_t value, numbers, raw; // the number so far; how many numbers and plain bytes are still to come
    uint32_t depth, groups;       // nesting depth of blocks; groups of locals still to come in kHead
    bool table;                   // at the first number of a br_table, which is the count of the others
    uint32_t unread[kUnreads], stack[64], height;
    uint32_t follows[kTables], offsetOf[kTables], last[kTables]; // by local; `last` by opcode

    // Adds a byte to a number (LEB128). Returns whether it is the last one.
    bool number(uint32_t byte) {
        value |= (byte & 127) << 7 * count++;
        return byte < 128;
    }
    void enter(uint32_t next) { phase = next, count = value = 0; }

    // Continues with the next operand, or ends the instruction.
    void nextOperand(uint32_t *fields) {
        if (numbers)
            enter(phase == kNumber ? kSecondNumber : kNumber);
        else if (raw)
            enter(kRaw);
        else {
            for (uint32_t k = kInstruction3; k > kInstruction1; --k) fields[k] = fields[k - 1];
            for (uint32_t k = kOpcode4; k > kOpcode1; --k) fields[k] = fields[k - 1];
            fields[kInstruction1] = fields[kSoFar];
            fields[kOpcode1] = fields[kOpcode];
            fields[kSoFar] = fields[kOpcode] = fields[kLast] = 0;
            fields[kUnread1] = unread[0], fields[kUnread2] = unread[1];
            fields[kFollows] = follows[fields[kLocal1] % kTables];
            fields[kOffsetOf] = offsetOf[fields[kLocal1] % kTables];
            fields[kDepth] = depth;
            uint32_t effect = kEffects.of[fields[kOpcode1]], taken = effect >> 1;
            height -= taken < height ? taken : height;
            if (effect & 1) stack[height & 63] = fields[kOpcode1], ++height;
            fields[kTop1] = height ? stack[(height - 1) & 63] : 0;
            fields[kTop2] = height > 1 ? stack[(height - 2) & 63] : 0;
            fields[kStack] = height;
            enter(kOpcodeByte);
            if (fields[kOpcode1] == 0x0b && !depth) { // the end of the function
                for (uint32_t k = kLocal1; k <= kOpcode4; ++k) fields[k] = 0;
                for (uint32_t &u : unread) u = 0;
                for (uint32_t &f : follows) f = 0;
                for (uint32_t &o : offsetOf) o = 0;
                height = 0;
                enter(kHead);
            }
            if (fields[kOpcode1] == 0x0b) depth -= depth > 0;
        }
    }
    // Parses an opcode: 0 .. 255, 256 + n after the prefix fc, 512 + n after fd.
    void opcode(uint32_t *fields, uint32_t op) {
        fields[kOpcode] = op;
        fields[kLast] = last[op % kTables];
        phase = kOpcodeByte;
        numbers = raw = 0;
        table = op == 0x0e;
        if (op < 256) {
            if (op >= 2 && op <= 4) ++depth, numbers = 1;
            if ((op >= 0x0c && op <= 0x10) || (op >= 0x20 && op <= 0x24) || (op >= 0x3f && op <= 0x42))
                numbers = op != 0x0f;
            if (op == 0x11 || (op >= 0x28 && op <= 0x3e)) numbers = 2;
            if (op == 0x43) raw = 4;
            if (op == 0x44) raw = 8;
        } else if (op < 512)
            numbers = op == 256 + 11 ? 1 : op >= 256 + 8 ? 2 : 0;
        else {
            op -= 512;
            if (op < 12 || (op >= 84 && op <= 93)) numbers = 2;
            if (op == 12 || op == 13) raw = 16;
            if ((op >= 21 && op <= 34) || (op >= 84 && op <= 91)) raw = 1;
        }
        nextOperand(fields);
    }
    // Ends an operand that is a number.
    void endOperand(uint32_t *fields) {
        uint32_t op = fields[kOpcode];
        if (table) numbers += value + 1;
        table = false;
        --numbers;
        if (op >= 0x20 && op <= 0x22) {
            follows[fields[kLocal1] % kTables] = value;
            fields[kLocal3] = fields[kLocal2], fields[kLocal2] = fields[kLocal1], fields[kLocal1] = value;
            uint32_t k = 0;
            while (k < kUnreads - 1 && unread[k] != value) ++k;
            if (op == 0x20)
                for (; k < kUnreads - 1; ++k) unread[k] = unread[k + 1];
            else {
                for (; k; --k) unread[k] = unread[k - 1];
                unread[0] = fields[kSet] = value;
            }
        } else if (phase == kSecondNumber)
            fields[kOffset] = offsetOf[fields[kLocal1] % kTables] = value;
        last[op % kTables] = value;
        nextOperand(fields);
    }

    void step(uint32_t *fields, uint32_t byte) {
        if (phase != kHead) fields[kSoFar] = mixIn(fields[kSoFar], byte);
        switch (phase) {
        case kHead:
            if (count == kGroups) groups = byte;
            if (count == kGroupType) --groups;
            if (count == kGroups || count == kGroupType)
                count = kGroupCount;
            else if (byte < 128)
                ++count; // the last byte of the function's size, or of a group's count
            if (count == kGroupCount && !groups) enter(kOpcodeByte);
            break;
        case kOpcodeByte:
            if (byte == 0xfc || byte == 0xfd) {
                fields[kOpcode] = byte;
                enter(kPrefixed);
            } else
                opcode(fields, byte);
            break;
        case kPrefixed:
            if (number(byte)) opcode(fields, (fields[kOpcode] == 0xfc ? 256 : 512) + value);
            break;
        case kRaw:
            ++count;
            if (!--raw) nextOperand(fields);
            break;
        default:
            if (number(byte)) endOperand(fields);
        }
    }
};

struct WasmTracker {
    struct CodedByte {
        uint8_t byte;
    };
    static constexpr MayUse mayUse = {kByte3 - kColumn, kSoFar + 1 - kByte3, web::kTarget + 1 - kColumn};
    static constexpr uint32_t kTarget = web::kTarget;
    static void prepare(uint8_t *) {} // the parser has no table

    static constexpr uint32_t kMatchBits = 16, kLeastMatch = 5, kMostMatch = 32;
    uint32_t fields[kFields];
    WasmParser parser;
    CodedByte *coded;
    uint32_t size;
    // Index of the predicted byte, and the number of equal bytes before it; 0: no match
    uint32_t match, length;
    uint32_t seen[1 << kMatchBits]; // index of the last occurrence of five bytes, by their hash
    bool code;

    void begin(uint32_t i) {
        const CodedByte *now = coded + i;
        for (uint32_t k = 0; k < 5; ++k) fields[kByte1 - k] = (now - k - 1)->byte;
        fields[kColumn] = i % kColumns;
        if (!code) {
            uint32_t c = fields[kByte1], letter = c | 32;
            if ((letter >= 'a' && letter <= 'z') || (c >= '0' && c <= '9'))
                fields[kLocal1] = mixIn(fields[kLocal1], c);
            else if (fields[kLocal1])
                fields[kLocal2] = fields[kLocal1], fields[kLocal1] = 0;
        }
        fields[kParserState] =
            code ? (parser.count < 31 ? parser.count : 31) << kPhaseBits | parser.phase : WasmParser::kData;
        code = false;

        // Continue the match, or find another one
        if (match && coded[match].byte == fields[kByte1])
            ++match, length += length < kMostMatch;
        else
            match = length = 0;
        uint32_t hash = 0;
        for (uint32_t k = 1; k <= kLeastMatch; ++k) hash = mixIn(hash, (now - k)->byte);
        uint32_t &before = seen[hash >> (32 - kMatchBits)];
        if (!match && before && i > kLeastMatch) {
            match = before;
            while (length < kMostMatch && length < match &&
                   coded[match - 1 - length].byte == (now - 1 - length)->byte)
                ++length;
            if (length < kLeastMatch) match = length = 0;
        }
        before = i;
    }

    Odds odds(uint32_t bits) const {
        if (!match) return {1, 1};
        uint32_t expected = coded[match].byte | 256u, count = 31 - (uint32_t)__builtin_clz(bits);
        if (expected >> (8 - count) != bits) return {1, 1};
        return expected >> (7 - count) & 1 ? Odds{length, 1} : Odds{1, length};
    }

    // Parses byte i of code. Returns 0: no operand of WebAssembly is relative.
    uint32_t end(uint32_t i, uint8_t byte, const uint8_t *) {
        (void)i;
        parser.step(fields, byte);
        code = true;
        return 0;
    }
};

} // namespace pack::web
