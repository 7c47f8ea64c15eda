#include "packer/model/model_parameters.h"
#include "packer/write/packed_file.h"
#include "tests/support/pe_rules.h"

#include <cstring>
#include <filesystem>
#include <gtest/gtest.h>

using namespace pack;

namespace {

// A page of code, then one of data that begins with the slots of the imports.
Program example() {
    Program p = {};
    p.base = 0x400000;
    p.readOnly = 0x1000;
    p.span = 0x1000 + 0x2345;
    p.bytes = Bytes(0x1100, 0x90);
    p.slots[0] = 0x401008;
    p.slots[1] = 0x401000;
    p.entry = 0x400010;
    return p;
}

template <class T> void put(Bytes &bytes, size_t offset, T value) {
    std::memcpy(bytes.data() + offset, &value, sizeof value);
}

constexpr size_t kOptional = 64 + 24, kSections = kOptional + 112 + 16 * 8;

} // namespace

TEST(Pe, AWindowsOfTodayTakesWhatIsWritten) {
    Program p = example();
    EXPECT_EQ(brokenPeRule(kPe.writePlain(p)), "");
    EXPECT_EQ(peImports(kPe.writePlain(p)), "kernel32.dll: GetProcAddress LoadLibraryA"); // in slot order
    std::swap(p.slots[0], p.slots[1]);
    EXPECT_EQ(peImports(kPe.writePlain(p)), "kernel32.dll: LoadLibraryA GetProcAddress");
    // The base may be any page of 31 bits; data may have no bytes except those that the loader writes
    for (uint32_t by : {0u, 0x1000u, 0xf000u, 0x10000u}) {
        Program moved = example();
        moved.base += by, moved.entry += by, moved.slots[0] += by, moved.slots[1] += by;
        moved.bytes.resize(0x800);
        EXPECT_EQ(brokenPeRule(kPe.writePlain(moved)), "") << by;
    }
    // All of the stack is committed from the start
    Bytes file = kPe.writePlain(p);
    EXPECT_EQ(std::memcmp(file.data() + kOptional + 72, file.data() + kOptional + 80, 8), 0);
    p.span = p.readOnly;
    EXPECT_THROW(kPe.writePlain(p), common::Refused);
}

TEST(Pe, WhatIsPackedIsTakenAndReadsBack) {
    Program p = example();
    p.codeSize = 0x1000;
    p.early = kNothingEarly;
    Workspace workspace;
    Encoded encoded = encode(p.bytes, p.layout(), defaultParameters(), workspace);
    Bytes file = kPe.write(p, defaultParameters(), encoded.payload, {});
    EXPECT_EQ(brokenPeRule(file), "");
    EXPECT_EQ(peImports(file),
              "kernel32.dll: GetProcAddress LoadLibraryA LoadLibraryA GetProcAddress VirtualAlloc "
              "VirtualFree VirtualProtect GetStdHandle WriteFile ExitProcess");
    EXPECT_EQ(file.size() % 512, 0u);
    EXPECT_LE(overhead(kPe, defaultParameters()), 3584u);
    EXPECT_EQ(decodeWithStub(kPe, file), p.bytes);
    Program back = readPacked(kPe, file);
    EXPECT_EQ(back.bytes, p.bytes);
    EXPECT_EQ(back.slots[0], p.slots[0]);
    EXPECT_EQ(back.slots[1], p.slots[1]);
    EXPECT_EQ(back.entry, p.entry);
    EXPECT_EQ(kPe.writePlain(back), kPe.writePlain(p));
    // Damage is found everywhere, also in bytes that only the loader reads
    for (size_t at = 0; at < file.size(); at += at < 800 ? 1 : 7) {
        Bytes damaged = file;
        damaged[at] ^= 16;
        EXPECT_THROW(readPacked(kPe, damaged), common::Refused) << at;
    }
    for (size_t size = 0; size < file.size(); size += 97)
        EXPECT_THROW(readPacked(kPe, Bytes(file.begin(), file.begin() + (long)size)), common::Refused)
            << size;
}

// The shipped program, if it has been built: it lies beside the folder of this test.
TEST(Pe, AWindowsOfTodayTakesTheFilm) {
    for (const char *name : {"odraz.exe", "odraz-safe.exe"}) {
        std::string path = std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path() / name;
        if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not built";
        Bytes file = readBytes(path);
        EXPECT_EQ(brokenPeRule(file), "") << name;
        EXPECT_EQ(peImports(file).find("kernel32.dll: "), 0u) << name;
        EXPECT_EQ(peImports(file).find(".dll", 12), std::string::npos) << name;
    }
}

// Breaks each rule once and checks that it is found.
TEST(Pe, TheRulesFindWhatIsWrong) {
    struct {
        const char *rule;
        size_t offset;
        uint32_t value;
    } faults[] = {
        {"the header overlaps the one of DOS", 0x3c, 4},
        {"not PE32+ for x86-64", 64 + 4, 0x3014c},
        {"odd alignment", kOptional + 36, 16},
        {"the size of the headers", kOptional + 60, 0x1ff},
        {"the base is not a multiple of 64 KB", kOptional + 24, 0x3f1000},
        {"it could be moved", kOptional + 68, 0x81400002},
        {"for a Windows before Vista", kOptional + 48, 5},
        {"Win32VersionValue", kOptional + 52, 1},
        {"data may be executed", kOptional + 68, 0x80000002},
        {"not for a graphical session", kOptional + 68, 0x81000003},
        {"commits more than it reserves", kOptional + 80, 0x100001},
        {"a gap before a section", kSections + 40 + 12, 0x11000},
        {"an empty section", kSections + 80 + 8, 0},
        {"a section's place in the file", kSections + 40 + 20, 0x401},
        {"a section beyond the file's end", kSections + 80 + 16, 0x2000},
        {"more bytes than memory", kSections + 80 + 8, 0x1},
        {"writable and executable", kSections + 40 + 36, 0xe0000020},
        {"the size of the image", kOptional + 56, 0x11000},
        {"the entry is not in code", kOptional + 16, 0x1000},
        {"no imports in a section's bytes", kOptional + 112 + 8, 0x100},
        {"names in the headers", 512, 0x100},
        {"slots that are empty at first are passed over", 512 + 16, 0x11010},
        {"a slot outside the directory of slots", kOptional + 112 + 12 * 8, 0x11008},
    };
    Program p = example();
    p.bytes.resize(0x2300, 1); // so that one more page of data has bytes
    Bytes sound = kPe.writePlain(p);
    ASSERT_EQ(brokenPeRule(sound), "");
    for (auto &fault : faults) {
        Bytes file = sound;
        put(file, fault.offset, fault.value);
        if (fault.rule == std::string("slots that are empty at first are passed over"))
            put(file, 0x400 + 0x1010, uint64_t(0));
        EXPECT_EQ(brokenPeRule(file), fault.rule);
    }
}
