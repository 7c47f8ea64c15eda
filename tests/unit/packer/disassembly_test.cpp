#include "packer/report/disassembly.h"

#include <gtest/gtest.h>

using namespace pack;

TEST(Disassembly, KeepsNumbersThatStandInBytesOutOfForms) {
    struct {
        std::vector<uint8_t> bytes;
        const char *text, *form;
    } all[] = {
        {{0x89, 0xe5}, "mov ebp,esp", "2mov ebp,esp"},
        {{0x8b, 0x45, 0xf8}, "mov eax,DWORD PTR [rbp-0x8]", "3mov eax,DWORD PTR [rbp~s12]"},
        {{0xc7, 0x45, 0x08, 7, 0, 0, 0}, "mov DWORD PTR [rbp+0x8],0x7", "7mov DWORD PTR [rbp~s12],~q43"},
        {{0x83, 0xc8, 0xff}, "or eax,0xffffffff", "3or eax,~d12"},
        {{0x48, 0x83, 0xc8, 0xff}, "or rax,0xffffffffffffffff", "4or rax,~q13"},
        {{0xeb, 0xfe}, "jmp 1000", "2jmp ~j11"},
        {{0xe8, 0xfb, 0x0f, 0, 0}, "call 2000", "5call ~j41"},
        {{0x0f, 0xb6, 0x1d, 0x10, 0, 0, 0}, "movzx ebx,BYTE PTR [rip+0x10]", "7movzx ebx,BYTE PTR [rip~s13]"},
        {{0xc1, 0xe0, 2}, "shl eax,0x3", "3shl eax,0x3"}, // not in its bytes
        {{0xff, 0xe0}, "jmp rax", "2jmp rax"},
    };
    for (auto &i : all) EXPECT_EQ(formOf({0x1000, i.bytes, i.text}), i.form);
}

TEST(Disassembly, OfWhatIsNoProgramIsEmpty) {
    int instructions = 0;
    for (const char *path : {"/dev/null", "/none", "--help"})
        disassemble(path, [&](const Instruction &) { ++instructions; });
    EXPECT_EQ(instructions, 0);
}
