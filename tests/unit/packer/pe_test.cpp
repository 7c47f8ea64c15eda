#include "tests/support/packed.h"
#include "tests/support/pe_rules.h"

using namespace pack;

// A page of code, then a page of data that begins with the slots of the imports.
static Program example() {
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

constexpr size_t kOptional = 64 + 24;

TEST(Pe, WritesFilesThatModernWindowsAccepts) {
    Program p = example();
    EXPECT_EQ(brokenPeRule(kPe.writePlain(p)), "");
    EXPECT_EQ(peImports(kPe.writePlain(p)), "kernel32.dll: GetProcAddress LoadLibraryA"); // in slot order
    std::swap(p.slots[0], p.slots[1]);
    EXPECT_EQ(peImports(kPe.writePlain(p)), "kernel32.dll: LoadLibraryA GetProcAddress");
    // The base may be any page. The slots may be the only bytes of the data that are in the file
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

TEST(Pe, PacksFilesThatWindowsAcceptsAndThatReadBack) {
    Program p = example();
    p.codeSize = 0x1000;
    p.early = kNothingEarly;
    Bytes file = expectReadBack(kPe, p);
    EXPECT_EQ(brokenPeRule(file), "");
    EXPECT_EQ(peImports(file),
              "kernel32.dll: GetProcAddress LoadLibraryA LoadLibraryA GetProcAddress VirtualAlloc "
              "VirtualFree VirtualProtect GetStdHandle WriteFile ExitProcess");
    EXPECT_EQ(file.size() % 512, 0u);
    // All bytes are used but the zeros before the check at the end
    size_t used = makePacked(kPe, p, defaultParameters(), "").used;
    EXPECT_LT(file.size() - used, 512u);
    EXPECT_EQ(Bytes(file.begin() + (long)used - 4, file.end() - 4), Bytes(file.size() - used, 0));
    EXPECT_LE(overhead(kPe, defaultParameters()), 3584u);
    EXPECT_EQ(kPe.writePlain(readPacked(kPe, file)), kPe.writePlain(p));
}

// The shipped program, if it has been built: it is next to the folder of this test.
TEST(Pe, ModernWindowsAcceptsTheFilm) {
    for (const char *name : {"odraz.exe", "odraz-safe.exe"}) {
        std::string path = std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path() / name;
        if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not built";
        Bytes file = readBytes(path);
        EXPECT_EQ(brokenPeRule(file), "") << name;
        EXPECT_EQ(peImports(file).find("kernel32.dll: "), 0u) << name;
        EXPECT_EQ(peImports(file).find(".dll", 12), std::string::npos) << name;
    }
}
