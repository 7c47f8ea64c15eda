// A program's instructions, as objdump (binutils) prints them, and a short form of them for pages.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pack {

struct Instruction {
    uint64_t address;
    std::vector<uint8_t> bytes;
    std::string text; // as Intel writes it, without comments
};

// Calls `visit` for each instruction, in the order of sections. Not called if objdump is not
// installed or finds no instructions.
void disassemble(const char *path, const std::function<void(const Instruction &)> &visit);

// The form of an instruction is its text without the numbers that are in its bytes, so that many instructions
// share it. A form begins with the number of bytes, a hexadecimal digit; in its text, ~ and
// three letters are a number: s for a displacement with its sign, j for a jump's or a call's target, b w d q
// for an unsigned number of 1, 2, 4, 8 bytes, to which it is extended; the number of bytes that it has; and
// where they begin, a hexadecimal digit.
std::string formOf(const Instruction &instruction);

} // namespace pack
