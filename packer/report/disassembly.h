// A program's instructions, as objdump (binutils) prints them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pack {

struct Instruction {
    uint64_t address;
    std::vector<uint8_t> bytes;
    std::string text; // as Intel writes it; behind " # " the address that rip leads to
};

// In the order of sections. Empty if objdump is not installed or finds no instructions.
std::vector<Instruction> disassemble(const std::string &path);

} // namespace pack
