// Writes and opens packed ELF files: kElf for programs made for packing, kLoader for any program.
#include "packer/read/elf_file.h"
#include "packer/stub/loader_format.h"
#include "packer/write/packed_file.h"
#include "stub_bytes.h"
#include "stub_loader_bytes.h"

#include <algorithm>
#include <cstring>

namespace pack {

namespace {

// Makes the ELF header of an executable with `segments` program headers from the offset `segmentsAt` on.
Elf64_Ehdr elfHeader(uint16_t type, uint64_t entry, uint64_t segmentsAt, uint16_t segments) {
    Elf64_Ehdr h = {};
    std::memcpy(h.e_ident, ELFMAG, SELFMAG);
    h.e_ident[EI_CLASS] = ELFCLASS64;
    h.e_ident[EI_DATA] = ELFDATA2LSB;
    h.e_ident[EI_VERSION] = EV_CURRENT;
    h.e_type = type;
    h.e_machine = EM_X86_64;
    h.e_version = EV_CURRENT;
    h.e_entry = entry;
    h.e_phoff = segmentsAt;
    h.e_ehsize = sizeof h;
    h.e_phentsize = sizeof(Elf64_Phdr);
    h.e_phnum = segments;
    return h;
}

Elf64_Phdr segment(uint32_t type, uint32_t flags, uint64_t offset, uint64_t address, uint64_t inFile,
                   uint64_t inMemory, uint64_t align) {
    return {type, flags, offset, address, address, inFile, inMemory, align};
}

// Joins headers, stub and payload section to a file of `size` bytes.
template <class Front>
Bytes assemble(const Front &front, const Bytes &stub, const Program &program,
               const ModelParameters &parameters, const Bytes &payload, size_t size) {
    Bytes file(sizeof front);
    std::memcpy(file.data(), &front, sizeof front);
    file.insert(file.end(), stub.begin(), stub.end());
    appendPayloadSection(file, program, parameters, payload, 0, size);
    return file;
}

// Reads the headers of a packed file.
template <class Front> Front frontOf(const PackedKind &kind, const Bytes &file) {
    need(isPacked(kind, file), kForeign);
    Front front;
    std::memcpy(&front, file.data(), sizeof front);
    return front;
}

// --- Programs made for packing ---

// Makes all headers except segments 1 and 2, which are loaded.
Front makeFront(uint64_t base, uint64_t entry, const uint32_t *slots) {
    Front f = {};
    f.header = elfHeader(ET_EXEC, entry, offsetof(Front, segments), 5);
    auto at = [&](size_t offset) { return base + offset; };
    f.segments[0] = segment(PT_INTERP, PF_R, offsetof(Front, interpreter), at(offsetof(Front, interpreter)),
                            sizeof kInterpreter, sizeof kInterpreter, 1);
    constexpr size_t kDynamic = sizeof f.dynamic + sizeof f.dynamicEnd;
    f.segments[3] = segment(PT_DYNAMIC, PF_R, offsetof(Front, dynamic), at(offsetof(Front, dynamic)),
                            kDynamic, kDynamic, 8);
    f.stackType = PT_GNU_STACK;
    f.stackFlags = PF_R | PF_W;
    std::memcpy(f.interpreter, kInterpreter, sizeof kInterpreter);
    std::memcpy(f.functions, "dlopen\0dlsym", 13);
    std::memcpy(f.library, "libdl.so.2", 11);
    // The table of strings begins with the first function's name
    constexpr size_t kStrings = offsetof(Front, functions);
    f.dynamic[0] = {DT_NEEDED, {offsetof(Front, library) - kStrings}};
    f.dynamic[1] = {DT_STRTAB, {at(kStrings)}};
    f.dynamic[2] = {DT_SYMTAB, {at(offsetof(Front, first)) - sizeof(Elf64_Sym)}};
    f.dynamic[3] = {DT_RELA, {at(offsetof(Front, relocations))}};
    f.dynamic[4] = {DT_RELASZ, {sizeof f.relocations}};
    f.dynamic[5] = {DT_RELAENT, {sizeof(Elf64_Rela)}};
    f.first = {0, ELF64_ST_INFO(STB_GLOBAL, STT_FUNC), 0, 0};
    f.second = {7, ELF64_ST_INFO(STB_GLOBAL, STT_FUNC), 0, 0};
    for (uint32_t i = 0; i < 2; ++i) f.relocations[i] = {slots[i], ELF64_R_INFO(i + 1, R_X86_64_GLOB_DAT), 0};
    return f;
}

Bytes writeElf(const Program &program, const ModelParameters &parameters, const Bytes &payload,
               const std::string &safeName) {
    uint32_t base = program.base - kBelow;
    size_t size = usedSize(kElf, parameters, payload);
    need(size <= kBelow, "too large: packed, it would be over 2 MiB");
    Front f = makeFront(base, base + sizeof f, program.slots);
    f.segments[1] = segment(PT_LOAD, PF_R | PF_X, 0, base, size, size, kPage);
    f.segments[2] = segment(PT_LOAD, PF_R | PF_W, 0, program.base, 0, wholePages(program.span), kPage);
    return assemble(f, kElf.stub.with(safeName), program, parameters, payload, size);
}

Packed openElf(const Bytes &file) {
    auto f = frontOf<Front>(kElf, file);
    uint64_t span = f.segments[2].p_memsz;
    Packed packed = openPayloadSection(file, sizeof f + sizeof kStub, 0, span);
    Program &program = packed.program;
    need(program.base > kBelow, kDamaged);
    for (int i = 0; i < 2; ++i) {
        program.slots[i] = (uint32_t)f.relocations[i].r_offset;
        need(program.slots[i] >= program.base && program.slots[i] - program.base + 8 <= span, kDamaged);
    }
    return packed;
}

Bytes writePlainElf(const Program &program) {
    uint64_t base = program.base - kPage, size = std::max<uint64_t>(program.bytes.size(), program.readOnly);
    Front f = makeFront(base, program.entry, program.slots);
    f.segments[1] =
        segment(PT_LOAD, PF_R | PF_X, 0, base, kPage + program.readOnly, kPage + program.readOnly, kPage);
    f.segments[2] = segment(PT_LOAD, PF_R | PF_W, kPage + program.readOnly, program.base + program.readOnly,
                            size - program.readOnly, program.span - program.readOnly, kPage);
    Bytes out(kPage + size);
    std::memcpy(out.data(), &f, sizeof f);
    std::copy(program.bytes.begin(), program.bytes.end(), out.begin() + kPage);
    return out;
}

// --- Programs of any kind ---

LoaderFront makeLoaderFront(const Program &program, size_t size) {
    // Take alignment and stack from the program's own headers, which are part of its bytes
    ElfProgram own(program.bytes);
    const Elf64_Ehdr &header = own.header;
    uint64_t alignment = kPage;
    uint32_t stack = PF_R | PF_W;
    for (const Elf64_Phdr &h : own.headers) {
        if (h.p_type == PT_LOAD && header.e_type == ET_DYN) alignment = std::max(alignment, h.p_align);
        if (h.p_type == PT_GNU_STACK) stack |= h.p_flags & PF_X;
    }

    uint64_t base = program.base, fileAt = base + program.span;
    LoaderFront f = {};
    f.header = elfHeader(header.e_type, fileAt + sizeof f, offsetof(LoaderFront, program), 3);
    f.program = segment(PT_LOAD, PF_R | PF_W, 0, base, 1, program.span, alignment);
    f.file = segment(PT_LOAD, PF_R | PF_X, 0, fileAt, size, size, kPage);
    f.stackType = PT_GNU_STACK;
    f.stackFlags = stack;
    return f;
}

Bytes writeLoader(const Program &program, const ModelParameters &parameters, const Bytes &payload,
                  const std::string &safeName) {
    size_t size = usedSize(kLoader, parameters, payload);
    return assemble(makeLoaderFront(program, size), kLoader.stub.with(safeName), program, parameters, payload,
                    size);
}

Packed openLoader(const Bytes &file) {
    auto f = frontOf<LoaderFront>(kLoader, file);
    return openPayloadSection(file, sizeof f + sizeof kStubLoader, 0, f.program.p_memsz);
}

Bytes writePlainLoader(const Program &program) {
    Bytes out = program.bytes;
    ElfProgram own(program.bytes);
    // The file has the same layout as the memory
    for (Elf64_Phdr &h : own.headers)
        if (h.p_filesz) h.p_offset = h.p_vaddr - program.base;
    std::memcpy(out.data() + own.header.e_phoff, own.headers.data(), own.headers.size() * sizeof(Elf64_Phdr));
    out.resize(program.span);
    return out;
}

} // namespace

const PackedKind kElf = {sizeof(Front), {kStub, sizeof kStub, kMayNotRun}, stubDecode, writeElf, openElf,
                         writePlainElf};
const PackedKind kLoader = {sizeof(LoaderFront), {kStubLoader, sizeof kStubLoader, kLoaderMayNotRun},
                            stubDecodeLoader,    writeLoader,
                            openLoader,          writePlainLoader};

} // namespace pack
