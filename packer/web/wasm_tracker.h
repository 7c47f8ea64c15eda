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
    uint8_t of[1024];
    constexpr void set(uint32_t from, uint32_t to, uint8_t effect) {
        for (uint32_t i = from; i <= to; ++i) of[i] = effect;
    }
    constexpr StackEffects() : of() {
        set(0x04, 0x04, 2), set(0x0d, 0x0e, 2), set(0x10, 0x11, 15), set(0x1a, 0x1a, 2), set(0x1b, 0x1b, 7);
        set(0x20, 0x20, 1), set(0x21, 0x21, 2), set(0x22, 0x22, kUnary), set(0x23, 0x23, 1),
            set(0x24, 0x24, 2);
        set(0x28, 0x35, kUnary), set(0x36, 0x3e, 4), set(0x3f, 0x3f, 1), set(0x40, 0x40, kUnary),
            set(0x41, 0x44, 1);
        set(0x45, 0xa6, kBinary), set(0xa7, 0xc4, kUnary), set(0x45, 0x45, kUnary), set(0x50, 0x50, kUnary);
        set(0x67, 0x69, kUnary), set(0x79, 0x7b, kUnary), set(0x8b, 0x91, kUnary), set(0x99, 0x9f, kUnary);
        set(256, 263, kUnary), set(264, 267, 6);
        set(512, 522, kUnary), set(523, 523, 4), set(524, 524, 1), set(525, 526, kBinary),
            set(527, 545, kUnary);
        set(535, 535, kBinary), set(538, 538, kBinary), set(540, 540, kBinary), set(542, 542, kBinary);
        set(544, 544, kBinary), set(546, 588, kBinary), set(589, 589, kUnary), set(590, 593, kBinary),
            set(594, 594, 7);
        set(595, 595, kUnary), set(596, 599, kBinary), set(600, 603, 4), set(604, 612, kUnary),
            set(613, 614, kBinary);
        set(615, 618, kUnary), set(619, 735, kBinary), set(736, 737, kUnary), set(739, 739, kUnary),
            set(740, 747, kBinary);
        set(760, 767, kUnary), set(768, 768, kBinary), set(769, 772, kUnary), set(773, 780, 7),
            set(781, 790, kBinary);
        for (uint32_t unary : {128, 131, 132, 135, 136, 137, 138, 160, 163, 164, 167, 168, 169, 170, 192,
                               195, 196, 199, 200, 201, 202, 116, 117, 122, 124, 125, 126, 127, 148})
            of[512 + unary] = kUnary;
    }
};
constexpr StackEffects kEffects;

struct WasmParser {
    enum Phase : uint32_t { kHead, kOpcodeByte, kPrefixed, kNumber, kSecondNumber, kRaw, kData };
    static constexpr uint32_t kTables = 1024, kUnreads = 8;

    uint32_t phase, count; // the part that the next byte belongs to, and how many of its bytes came before
    uint32_t value, numbers, raw; // the number so far; how many numbers and plain bytes are still to come
    uint32_t depth, locals;       // nesting depth of blocks; for kHead: see step()
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
                locals = height = 0;
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
        // The function's size, the number of groups of locals, the count and the type of each. `locals`: 0 in
        // the size, 1 at the number; then 2 * (groups left) + 2 in a count, and 1 less at its type
        case kHead:
            if (locals == 0) {
                if (byte < 128) locals = 1;
            } else if (locals == 1)
                locals = 2 * byte + 2;
            else if ((locals & 1) || byte < 128)
                --locals;
            count = locals < 2 ? locals : 2 | (locals & 1);
            if (locals == 2) enter(kOpcodeByte);
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
