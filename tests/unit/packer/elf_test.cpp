#include "packer/read/program.h"
#include "tests/support/packed.h"
#include "tests/support/thrown.h"

#include <elf.h>

using namespace pack;

// --- Reader ---

// A minimal valid program: a code page, and a data page that holds the dynamic section.
struct Example {
    struct Image {
        Elf64_Ehdr header;
        Elf64_Phdr segments[5]; // four, and a spare one
        char interpreter[28];
        char code[64];
    };
    struct Data {
        Elf64_Dyn dynamic[7];
        Elf64_Sym symbols[3];
        Elf64_Rela relocations[2];
        char strings[48];
        uint64_t slots[2];
    };
    Image image = {};
    Data data = {};
    static constexpr uint64_t kCode = 0x400000, kData = 0x401000;

    Example() {
        std::memcpy(image.header.e_ident, "\177ELF\2\1\1", 7);
        image.header.e_type = ET_EXEC;
        image.header.e_machine = EM_X86_64;
        image.header.e_entry = kCode + offsetof(Image, code);
        image.header.e_phoff = offsetof(Image, segments);
        image.header.e_phentsize = sizeof(Elf64_Phdr);
        image.header.e_phnum = 4;
        auto segment = [](uint32_t type, uint32_t flags, uint64_t offset, uint64_t at, uint64_t file,
                          uint64_t memory) {
            return Elf64_Phdr{type, flags, offset, at, at, file, memory, 4096};
        };
        image.segments[0] = segment(PT_INTERP, PF_R, offsetof(Image, interpreter),
                                    kCode + offsetof(Image, interpreter), 28, 28);
        image.segments[1] = segment(PT_LOAD, PF_R | PF_X, 0, kCode, sizeof image, sizeof image);
        image.segments[2] = segment(PT_LOAD, PF_R | PF_W, 4096, kData, sizeof data, sizeof data + 100);
        image.segments[3] =
            segment(PT_DYNAMIC, PF_R | PF_W, 4096, kData, sizeof data.dynamic, sizeof data.dynamic);
        std::memcpy(image.interpreter, "/lib64/ld-linux-x86-64.so.2", 28);
        std::memcpy(data.strings, "\0libdl.so.2\0dlopen\0dlsym", 25);
        data.dynamic[0] = {DT_NEEDED, {1}};
        data.dynamic[1] = {DT_STRTAB, {kData + offsetof(Data, strings)}};
        data.dynamic[2] = {DT_SYMTAB, {kData + offsetof(Data, symbols)}};
        data.dynamic[3] = {DT_RELA, {kData + offsetof(Data, relocations)}};
        data.dynamic[4] = {DT_RELASZ, {sizeof data.relocations}};
        data.dynamic[5] = {DT_STRSZ, {25}};
        data.symbols[1].st_name = 12;
        data.symbols[2].st_name = 19;
        for (uint32_t i = 0; i < 2; ++i)
            data.relocations[i] = {kData + offsetof(Data, slots) + 8 * i,
                                   ELF64_R_INFO(i + 1, R_X86_64_GLOB_DAT), 0};
    }
    Bytes file() const {
        Bytes b(4096 + sizeof data);
        std::memcpy(b.data(), &image, sizeof image);
        std::memcpy(b.data() + 4096, &data, sizeof data);
        return b;
    }
};

static std::string complaint(const Bytes &file, const System &system = kLinux) {
    return thrown<common::Refused>([&] { readProgram(file, system); });
}

using Edit = void (*)(Example &);
// Expects that the edited example is refused with this text, as a program made for packing or as any program.
static void expectRefused(const char *text, Edit edit, bool any = false) {
    Example e;
    edit(e);
    std::string why = any ? thrown<common::Refused>([&] { readAnyProgram(e.file()); }) : complaint(e.file());
    EXPECT_NE(why.find(text), std::string::npos) << text << ": " << why;
}

TEST(Reader, TakesAProgramAsWeLinkIt) {
    Program p = readProgram(Example().file());
    EXPECT_EQ(p.base, Example::kCode);
    EXPECT_EQ(p.readOnly, 4096u);
    EXPECT_EQ(p.early, kNothingEarly);
    EXPECT_EQ(p.span, 4096 + sizeof(Example::Data) + 100);
    EXPECT_EQ(p.slots[0], Example::kData + offsetof(Example::Data, slots));
    EXPECT_EQ(p.slots[1], p.slots[0] + 8);
    EXPECT_EQ(p.bytes, Bytes{0}); // it had only the loader's tables, which are zeroed
}

TEST(Reader, RefusesWhatIsUnsuitable) {
    EXPECT_EQ(complaint(Bytes{}), "not an ELF file");
    EXPECT_EQ(complaint(Bytes(5000, 'x')), "not an ELF file");
    expectRefused("32-bit", [](Example &e) { e.image.header.e_ident[EI_CLASS] = ELFCLASS32; });
    expectRefused("big-endian", [](Example &e) { e.image.header.e_ident[EI_DATA] = ELFDATA2MSB; });
    expectRefused("x86-64", [](Example &e) { e.image.header.e_machine = EM_AARCH64; });
    expectRefused("no-pie", [](Example &e) { e.image.header.e_type = ET_DYN; });
    expectRefused("link it", [](Example &e) { e.image.header.e_type = ET_REL; });
    expectRefused("overlap", [](Example &e) { e.image.segments[2].p_vaddr = Example::kCode + 64; });
    expectRefused("both writable and executable", [](Example &e) { e.image.segments[2].p_flags |= PF_X; });
    expectRefused("over 64 MiB", [](Example &e) { e.image.segments[2].p_memsz = 1ull << 40; });
    expectRefused("beyond 2 GiB", [](Example &e) {
        for (int i : {0, 1}) e.image.segments[i].p_vaddr += 0x7fc00000;
    });
    expectRefused("executable stack", [](Example &e) {
        e.image.header.e_phnum = 5;
        e.image.segments[4] = {PT_GNU_STACK, PF_R | PF_W | PF_X, 0, 0, 0, 0, 0, 16};
    });
    expectRefused("cut short", [](Example &e) { e.image.segments[2].p_offset = 1 << 20; });
    expectRefused("statically", [](Example &e) { e.image.segments[0].p_type = PT_NULL; });
    expectRefused("thread-local", [](Example &e) { e.image.segments[0].p_type = PT_TLS; });
    expectRefused("interpreter", [](Example &e) { e.image.interpreter[3] = 'x'; });
    expectRefused("entry", [](Example &e) { e.image.header.e_entry = Example::kData; });
    expectRefused("libdl.so.2", [](Example &e) { e.data.strings[3] = 'c'; });
    expectRefused("dlopen and dlsym", [](Example &e) { e.data.strings[13] = 'c'; });
    expectRefused("nothing else", [](Example &e) { e.data.dynamic[4].d_un.d_val = 72; });
    expectRefused("constructors", [](Example &e) { e.data.dynamic[6] = {DT_INIT_ARRAY, {0}}; });
    expectRefused("GLOB_DAT",
                  [](Example &e) { e.data.relocations[0].r_info = ELF64_R_INFO(1, R_X86_64_JUMP_SLOT); });
    expectRefused("slot", [](Example &e) { e.data.relocations[0].r_offset = Example::kCode; });
    expectRefused("adjacent", [](Example &e) { e.data.relocations[1].r_offset += 8; });
    expectRefused("section headers", [](Example &e) { e.image.header.e_shnum = 3; });
    expectRefused("linked below", [](Example &e) {
        e.image.segments[1].p_vaddr = 0x10000;
        e.image.segments[0].p_vaddr = 0x10000;
    });
    expectRefused("outside", [](Example &e) { e.data.dynamic[1].d_un.d_ptr = 5; });
}

TEST(Reader, TakesAProgramForWindows) {
    Example e;
    EXPECT_EQ(complaint(e.file(), kWindows), "it must need kernel32.dll and no other library");
    std::memcpy(e.data.strings, "\0kernel32.dll\0LoadLibraryA\0GetProcAddress", 42);
    e.data.symbols[1].st_name = 0;
    EXPECT_EQ(complaint(e.file(), kWindows).substr(0, 48),
              "it must import LoadLibraryA and GetProcAddress a");
    EXPECT_EQ(complaint(e.file()), "it must need libdl.so.2 and no other library");
    e.data.symbols[1].st_name = 14;
    e.data.symbols[2].st_name = 27;
    e.image.segments[0].p_type = PT_NULL; // and no interpreter
    EXPECT_EQ(complaint(e.file(), kWindows), "");
    Program p = readProgram(e.file(), kWindows);
    EXPECT_EQ(p.slots[0], Example::kData + offsetof(Example::Data, slots));
}

// --- Sections ---

// The example with three pages of code and constants and with section headers. Two pages are the early part.
struct Sectioned {
    Example example;
    Elf64_Shdr sections[4] = {};
    char names[32] = "\0.early\0.text\0.names";
    static constexpr uint64_t kText = Example::kCode + 8192;

    Sectioned() {
        example.image.segments[1].p_filesz = example.image.segments[1].p_memsz = 12288 - 100;
        example.image.segments[2].p_offset = example.image.segments[3].p_offset = 12288;
        for (int i : {2, 3}) example.image.segments[i].p_vaddr += 8192;
        for (int i : {1, 2, 3}) example.data.dynamic[i].d_un.d_ptr += 8192;
        for (auto &r : example.data.relocations) r.r_offset += 8192;
        auto section = [&](int i, uint32_t name, uint64_t address, uint64_t size) {
            sections[i].sh_name = name;
            sections[i].sh_type = SHT_PROGBITS;
            sections[i].sh_flags = SHF_ALLOC | SHF_EXECINSTR;
            sections[i].sh_addr = address;
            sections[i].sh_size = size;
        };
        section(1, 1, Example::kCode + 1000, 8192 - 1000);
        section(2, 8, kText, 2000);
        example.image.header.e_shnum = 4;
        example.image.header.e_shentsize = sizeof(Elf64_Shdr);
        example.image.header.e_shstrndx = 3;
        example.image.header.e_shoff = 12288 + sizeof(Example::Data);
        sections[3].sh_offset = example.image.header.e_shoff + sizeof sections;
    }
    Bytes file() const {
        Bytes b(12288 + sizeof example.data + sizeof sections + sizeof names);
        std::memcpy(b.data(), &example.image, sizeof example.image);
        std::memcpy(b.data() + 12288, &example.data, sizeof example.data);
        std::memcpy(b.data() + example.image.header.e_shoff, sections, sizeof sections);
        std::memcpy(b.data() + sections[3].sh_offset, names, sizeof names);
        // Code that is not all zeros
        for (size_t i = 1000; i < 8192 + 2000; ++i) b[i] = (uint8_t)(i * 7);
        return b;
    }
};

TEST(Reader, FindsCodeAndEarlyPartBySections) {
    Program p = readProgram(Sectioned().file());
    EXPECT_EQ(p.codeBegin, 1000u);
    EXPECT_EQ(p.codeSize, 8192u + 2000 - 1000);
    EXPECT_EQ(p.early, 8192u);
    EXPECT_EQ(p.earlyEntry, Example::kCode + 1000);
    EXPECT_EQ(p.readOnly, 12288u);
    // A section with another name is not early
    Sectioned other;
    other.names[1] = '_';
    EXPECT_EQ(readProgram(other.file()).early, kNothingEarly);
}

TEST(Reader, NeedsTheEarlyPartOnSeparatePages) {
    Sectioned s;
    s.sections[1].sh_size -= 100; // accepted: nothing follows in its last page
    EXPECT_EQ(readProgram(s.file()).early, 8192u);
    s.sections[2].sh_addr -= 50; // refused: other code shares the page
    EXPECT_NE(complaint(s.file()).find(".early"), std::string::npos);
}

// Found by the fuzzer: sums of addresses and sizes that wrap around.
TEST(Reader, RefusesAddressesThatWrapAround) {
    Sectioned s;
    s.sections[2].sh_addr = UINT64_MAX - 15;
    EXPECT_NE(complaint(s.file()).find("outside the segments"), std::string::npos);
    expectRefused("not in writable memory", [](Example &e) {
        e.data.relocations[0].r_offset = UINT64_MAX - 7;
        e.data.relocations[1].r_offset = UINT64_MAX - 15;
    });
    expectRefused("over 64 MiB", [](Example &e) {
        e.image.segments[1].p_vaddr = 0xfffff000;
        e.image.segments[2].p_vaddr = 0x100000000;
    });
    // A segment of size 0 is not loaded, whatever its address
    Example e;
    e.image.header.e_phnum = 5;
    e.image.segments[4] = {PT_LOAD, PF_R | PF_X, 0, 0xffffffffffff0000, 0, 4096, 0, 4096};
    EXPECT_EQ(readProgram(e.file()).codeBegin, 0u);
    EXPECT_LE(readProgram(e.file()).codeSize, 1u);
}

// --- Writer ---

TEST(Writer, WritesWhatReadsBack) {
    Program p = readProgram(Sectioned().file());
    Bytes file = expectReadBack(kElf, p);
    EXPECT_EQ(checksum(file.data(), file.size() / 4), 0u);
    Program q = readPacked(kElf, file);
    EXPECT_EQ(q.readOnly, p.readOnly);
    EXPECT_EQ(q.span, wholePages(p.span));
    // The plain file has the same program at the same address
    Program again = readProgram(kElf.writePlain(q));
    EXPECT_EQ(again.base, p.base - kPage);
    EXPECT_EQ(Bytes(again.bytes.begin() + kPage, again.bytes.end()), p.bytes);
    EXPECT_EQ(again.slots[0], p.slots[0]);
    EXPECT_EQ(again.entry, p.entry);
}

// --- Programs of any kind ---

TEST(Loader, FindsWhatWasMadeForPacking) {
    EXPECT_TRUE(isMadeForPacking(Example().file()));
    Example other;
    std::memcpy(other.data.strings, "\0libdl.so.3", 11);
    EXPECT_FALSE(isMadeForPacking(other.file()));
    Example independent;
    independent.image.header.e_type = ET_DYN;
    EXPECT_FALSE(isMadeForPacking(independent.file()));
    EXPECT_FALSE(isMadeForPacking({}));
}

static void expectAnyRefused(const char *text, Edit edit) { expectRefused(text, edit, true); }

TEST(Loader, RefusesWhatIsUnsuitable) {
    EXPECT_NO_THROW(readAnyProgram(Example().file()));
    expectAnyRefused("names no interpreter", [](Example &e) { e.image.segments[0].p_type = PT_NULL; });
    expectAnyRefused("no entry point", [](Example &e) { e.image.header.e_entry = Example::kData; });
    expectAnyRefused("both writable and executable", [](Example &e) { e.image.segments[1].p_flags |= PF_W; });
    expectAnyRefused("overlap", [](Example &e) { e.image.segments[2].p_vaddr = Example::kCode; });
    expectAnyRefused("lacks its ELF header", [](Example &e) { e.image.segments[1].p_filesz = 63; });
    expectAnyRefused("in no segment", [](Example &e) { e.image.segments[1].p_filesz = 64; });
    auto isLibrary = [](Example &e) {
        e.image.header.e_type = ET_DYN;
        e.data.dynamic[6] = {DT_SONAME, {1}};
    };
    expectAnyRefused("a shared library", isLibrary);
    Example named; // a position-independent program may have a DT_SONAME
    isLibrary(named);
    named.data.dynamic[5] = {DT_FLAGS_1, {DF_1_PIE}};
    EXPECT_NO_THROW(readAnyProgram(named.file()));
    expectAnyRefused("cut short",
                     [](Example &e) { e.image.segments[2].p_filesz = e.image.segments[2].p_memsz; });
    expectAnyRefused("more than 64 MiB", [](Example &e) { e.image.segments[2].p_vaddr = 0x10000000; });
    expectAnyRefused("below 64 KiB", [](Example &e) { e.image.segments[1].p_vaddr = 0x8000; });
}

TEST(Loader, CountsWhatIsAppended) {
    Bytes file = Example().file();
    EXPECT_EQ(appendedBytes(file), 0u);
    file.resize(file.size() + 1000);
    EXPECT_EQ(appendedBytes(file), 0u) << "padding";
    file.back() = 1;
    EXPECT_EQ(appendedBytes(file), 1000u);
}

TEST(Loader, WritesWhatReadsBack) {
    Program p = readAnyProgram(Example().file());
    Bytes file = expectReadBack(kLoader, p);
    EXPECT_FALSE(isPacked(kElf, file));
    EXPECT_EQ(checksum(file.data(), file.size() / 4), 0u);
    Program q = readPacked(kLoader, file);
    EXPECT_EQ(q.span, p.span);
    // The plain file, read again, differs only in the offsets in its headers
    Program again = readAnyProgram(kLoader.writePlain(q));
    EXPECT_EQ(again.bytes.size(), p.bytes.size());
    EXPECT_EQ(again.entry, p.entry);
}

// Programs as patchelf and postject write them.
TEST(Loader, TakesProgramsWhoseTablesWereMoved) {
    Example e; // the interpreter's name is at the end of the program
    e.image.segments[0].p_offset = 4096 + offsetof(Example::Data, slots) - 28;
    e.image.segments[0].p_vaddr = Example::kData + offsetof(Example::Data, slots) - 28;
    std::memcpy(e.data.strings + 20, kInterpreter, 28);
    Program p = readAnyProgram(e.file());
    EXPECT_EQ(p.bytes.back(), '2');
    EXPECT_EQ(readPacked(kLoader, packed(kLoader, p)).bytes, p.bytes);

    Bytes file = Example().file(); // the program headers are in a separate segment at the end
    Elf64_Phdr headers[5];
    std::memcpy(headers, &file[offsetof(Example::Image, segments)], sizeof headers);
    headers[4] = {PT_LOAD, PF_R, 8192, 0x403000, 0x403000, sizeof headers, sizeof headers, 4096};
    file.resize(8192);
    file.insert(file.end(), (uint8_t *)headers, (uint8_t *)(headers + 5));
    uint64_t at = 8192;
    std::memcpy(&file[offsetof(Elf64_Ehdr, e_phoff)], &at, sizeof at);
    file[offsetof(Elf64_Ehdr, e_phnum)] = 5;
    p = readAnyProgram(file);
    std::memcpy(&at, &p.bytes[offsetof(Elf64_Ehdr, e_phoff)], sizeof at);
    EXPECT_EQ(at, 0x3000u);
    EXPECT_EQ(std::memcmp(&p.bytes[0x3000], headers, sizeof headers), 0);
    Bytes plain = kLoader.writePlain(readPacked(kLoader, packed(kLoader, p)));
    EXPECT_EQ(readAnyProgram(plain).bytes.size(), p.bytes.size());
}

// --- Messages ---

TEST(Messages, KeepTheirLength) {
    for (std::string usual : {kMayNotRun, kLoaderMayNotRun})
        for (const char *safe : {"", "a", "odraz-safe", "fourteen.chars"}) {
            EXPECT_NO_THROW(checkSafeName(safe));
            std::string line = mayNotRun(usual, safe);
            EXPECT_EQ(line.size(), usual.size());
            EXPECT_NE(line.find(safe), line.npos) << safe;
            EXPECT_EQ(line.find('\n'), line.find_last_not_of('\0')); // one line, which zeros may follow
        }
    EXPECT_EQ(mayNotRun(kMayNotRun, "odraz-safe"), "use odraz-safe instead\n");
    for (const char *wrong : {"fifteen.letters", "a b", "a\n", "\xc3\xa9"})
        EXPECT_THROW(checkSafeName(wrong), common::Refused) << wrong;
}
