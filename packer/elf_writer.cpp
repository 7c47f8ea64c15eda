#include "program.h"

#include "model.h"
#include "stub_bytes.h"

#include <cstring>
#include <elf.h>

namespace pack {

namespace {

constexpr uint32_t kBelow = 0x200000; // the packed file lies so far below the program
constexpr char kStrings[] = "\0libdl.so.2\0dlopen\0dlsym";

// Everything in front of the stub, in the order of the file.
struct Front {
    Elf64_Ehdr header;
    Elf64_Phdr segments[5];
    Elf64_Dyn dynamic[8];
    Elf64_Sym symbols[3];
    Elf64_Rela relocations[2];
    char strings[sizeof kStrings];
    char interpreter[sizeof kInterpreter];
};

} // namespace

size_t overhead() { return sizeof(Front) + sizeof kStub; }

std::vector<uint8_t> writePacked(const Program &program, const std::vector<uint8_t> &payload) {
    uint32_t base = program.base - kBelow, size = (uint32_t)(overhead() + payload.size());
    if (size > kBelow) throw Unsuitable("too large to pack");
    uint32_t model = program.base + (uint32_t)wholePages(program.span);
    auto address = [&](size_t offset) { return base + offset; };

    Front f = {};
    std::memcpy(f.header.e_ident, ELFMAG, SELFMAG);
    f.header.e_ident[EI_CLASS] = ELFCLASS64;
    f.header.e_ident[EI_DATA] = ELFDATA2LSB;
    f.header.e_ident[EI_VERSION] = EV_CURRENT;
    f.header.e_type = ET_EXEC;
    f.header.e_machine = EM_X86_64;
    f.header.e_version = EV_CURRENT;
    f.header.e_entry = address(sizeof(Front));
    f.header.e_phoff = offsetof(Front, segments);
    f.header.e_ehsize = sizeof(Elf64_Ehdr);
    f.header.e_phentsize = sizeof(Elf64_Phdr);
    f.header.e_phnum = 5;

    auto segment = [&](uint32_t type, uint32_t flags, uint64_t offset, uint64_t at, uint64_t inFile,
                       uint64_t inMemory, uint64_t align) {
        return Elf64_Phdr{type, flags, offset, at, at, inFile, inMemory, align};
    };
    f.segments[0] =
        segment(PT_INTERP, PF_R, offsetof(Front, interpreter), address(offsetof(Front, interpreter)),
                sizeof kInterpreter, sizeof kInterpreter, 1);
    f.segments[1] = segment(PT_LOAD, PF_R | PF_X, 0, base, size, size, kPage);
    f.segments[2] =
        segment(PT_LOAD, PF_R | PF_W, 0, program.base, 0, model - program.base + sizeof(Model), kPage);
    f.segments[3] = segment(PT_DYNAMIC, PF_R, offsetof(Front, dynamic), address(offsetof(Front, dynamic)),
                            sizeof f.dynamic, sizeof f.dynamic, 8);
    f.segments[4] = segment(PT_GNU_STACK, PF_R | PF_W, 0, 0, 0, 0, 16);

    // glibc needs no hash table to run a program, but it does need a symbol table
    f.dynamic[0] = {DT_NEEDED, {1}};
    f.dynamic[1] = {DT_STRTAB, {address(offsetof(Front, strings))}};
    f.dynamic[2] = {DT_SYMTAB, {address(offsetof(Front, symbols))}};
    f.dynamic[3] = {DT_RELA, {address(offsetof(Front, relocations))}};
    f.dynamic[4] = {DT_RELASZ, {sizeof f.relocations}};
    f.dynamic[5] = {DT_RELAENT, {sizeof(Elf64_Rela)}};
    f.dynamic[6] = {DT_STRSZ, {sizeof kStrings}}; // for ldd and readelf
    f.dynamic[7] = {DT_NULL, {0}};
    for (uint32_t i = 0; i < 2; ++i) {
        f.symbols[i + 1].st_name = i ? 19 : 12; // "dlsym", "dlopen" in kStrings
        f.symbols[i + 1].st_info = ELF64_ST_INFO(STB_GLOBAL, STT_FUNC);
        f.relocations[i] = {program.slots[i], ELF64_R_INFO(i + 1, R_X86_64_GLOB_DAT), 0};
    }
    std::memcpy(f.strings, kStrings, sizeof kStrings);
    std::memcpy(f.interpreter, kInterpreter, sizeof kInterpreter);

    Parameters p = {(uint32_t)address(overhead()),
                    program.base,
                    (uint32_t)program.bytes.size(),
                    program.codeSize,
                    program.span,
                    model,
                    {program.slots[0], program.slots[1]},
                    program.entry};
    std::vector<uint8_t> out(size);
    std::memcpy(out.data(), &f, sizeof f);
    std::memcpy(out.data() + sizeof f, kStub, sizeof kStub);
    std::memcpy(out.data() + overhead() - sizeof p, &p, sizeof p);
    std::memcpy(out.data() + overhead(), payload.data(), payload.size());
    return out;
}

} // namespace pack
