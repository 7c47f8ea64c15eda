#include "program.h"

#include <cstring>
#include <elf.h>
#include <gtest/gtest.h>
#include <random>

using namespace pack;
using Bytes = std::vector<uint8_t>;

// --- Reader ---

namespace {

// A minimal program as the reader wants it: code page, data page, and the dynamic section in the latter.
struct Example {
    struct Image {
        Elf64_Ehdr header;
        Elf64_Phdr segments[4];
        char interpreter[28];
        char code[64];
    };
    struct Data {
        Elf64_Dyn dynamic[7];
        Elf64_Sym symbols[3];
        Elf64_Rela relocations[2];
        char strings[32];
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

std::string complaint(const Bytes &file) {
    try {
        readProgram(file);
    } catch (const Unsuitable &e) {
        return e.what();
    }
    return "";
}

template <class Change> std::string complaintAfter(Change change) {
    Example e;
    change(e);
    return complaint(e.file());
}

} // namespace

TEST(Reader, TakesAProgramAsWeLinkIt) {
    Program p = readProgram(Example().file());
    EXPECT_EQ(p.base, Example::kCode);
    EXPECT_EQ(p.readOnly, 4096u);
    EXPECT_EQ(p.early, kNothingEarly);
    EXPECT_EQ(p.span, 4096 + sizeof(Example::Data) + 100);
    EXPECT_EQ(p.slots[0], Example::kData + offsetof(Example::Data, slots));
    EXPECT_EQ(p.slots[1], p.slots[0] + 8);
    EXPECT_EQ(p.bytes, Bytes{0}); // all of it was for the loader
}

TEST(Reader, SaysWhatIsUnsuitable) {
    EXPECT_EQ(complaint({}), "not an ELF file");
    EXPECT_EQ(complaint(Bytes(5000, 'x')), "not an ELF file");
    EXPECT_NE(
        complaintAfter([](Example &e) { e.image.header.e_ident[EI_CLASS] = ELFCLASS32; }).find("32-bit"),
        std::string::npos);
    EXPECT_NE(
        complaintAfter([](Example &e) { e.image.header.e_ident[EI_DATA] = ELFDATA2MSB; }).find("big-endian"),
        std::string::npos);
    EXPECT_NE(complaintAfter([](Example &e) { e.image.header.e_machine = EM_AARCH64; }).find("x86-64"),
              std::string::npos);
    EXPECT_NE(complaintAfter([](Example &e) { e.image.header.e_type = ET_DYN; }).find("no-pie"),
              std::string::npos);
    EXPECT_NE(complaintAfter([](Example &e) { e.image.header.e_type = ET_REL; }).find("link it"),
              std::string::npos);
    EXPECT_NE(
        complaintAfter([](Example &e) { e.image.segments[2].p_vaddr = Example::kCode + 64; }).find("overlap"),
        std::string::npos);
    EXPECT_NE(complaintAfter([](Example &e) {
                  e.image.segments[2].p_flags |= PF_X;
              }).find("both writable and executable"),
              std::string::npos);
    EXPECT_NE(complaintAfter([](Example &e) { e.image.segments[2].p_memsz = 1ull << 40; }).find("absurd"),
              std::string::npos);
    EXPECT_NE(complaintAfter([](Example &e) { e.image.segments[2].p_offset = 1 << 20; }).find("cut short"),
              std::string::npos);
    EXPECT_NE(complaintAfter([](Example &e) { e.image.segments[0].p_type = PT_NULL; }).find("statically"),
              std::string::npos);
    EXPECT_NE(complaintAfter([](Example &e) { e.image.segments[0].p_type = PT_TLS; }).find("thread-local"),
              std::string::npos);
    EXPECT_NE(complaintAfter([](Example &e) { e.image.interpreter[3] = 'x'; }).find("interpreter"),
              std::string::npos);
    EXPECT_NE(complaintAfter([](Example &e) { e.image.header.e_entry = Example::kData; }).find("entry"),
              std::string::npos);
    EXPECT_NE(complaintAfter([](Example &e) { e.data.strings[3] = 'c'; }).find("libdl.so.2"),
              std::string::npos);
    EXPECT_NE(complaintAfter([](Example &e) { e.data.strings[13] = 'c'; }).find("dlopen and dlsym"),
              std::string::npos);
    EXPECT_NE(complaintAfter([](Example &e) { e.data.dynamic[4].d_un.d_val = 72; }).find("nothing else"),
              std::string::npos);
    EXPECT_NE(complaintAfter([](Example &e) {
                  e.data.dynamic[6] = {DT_INIT_ARRAY, {0}};
              }).find("constructors"),
              std::string::npos);
    EXPECT_NE(complaintAfter([](Example &e) {
                  e.data.relocations[0].r_info = ELF64_R_INFO(1, R_X86_64_JUMP_SLOT);
              }).find("GLOB_DAT"),
              std::string::npos);
    EXPECT_NE(
        complaintAfter([](Example &e) { e.data.relocations[0].r_offset = Example::kCode; }).find("slot"),
        std::string::npos);
    EXPECT_NE(complaintAfter([](Example &e) { e.data.dynamic[1].d_un.d_ptr = 5; }).find("outside"),
              std::string::npos);
}

// Every file cut short and every byte damaged: a complaint or a program, never a crash (run it under ASan).
TEST(Reader, SurvivesDamage) {
    Bytes whole = Example().file();
    for (size_t size = 0; size < whole.size(); ++size)
        complaint(Bytes(whole.begin(), whole.begin() + (long)size));
    for (size_t i = 0; i < whole.size(); ++i)
        for (uint8_t flip : {0x01, 0x80, 0xff}) {
            if (i >= sizeof(Example::Image) && i < 4096) continue;
            Bytes broken = whole;
            broken[i] ^= flip;
            complaint(broken);
        }
}
