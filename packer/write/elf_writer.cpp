#include "packer/stub/stub.h"
#include "packer/write/elf_header.h"
#include "packer/write/packed_file.h"
#include "stub_bytes.h"

#include <algorithm>
#include <cstring>

namespace pack {

namespace {

// Where things lie in a packed file
constexpr size_t kStubAt = sizeof(Front), kPayloadSectionAt = kStubAt + sizeof kStub;

NamedStub namedStub() { return {kStub, sizeof kStub, kMessages, 0}; }

Elf64_Phdr segment(uint32_t type, uint32_t flags, uint64_t offset, uint64_t address, uint64_t inFile,
                   uint64_t inMemory, uint64_t align) {
    return {type, flags, offset, address, address, inFile, inMemory, align};
}

// All but the two segments that are loaded, 1 and 2.
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

Bytes write(const Program &program, const ModelParameters &parameters, const Bytes &payload,
            const Names &names) {
    uint32_t base = program.base - kBelow;
    size_t size = (overhead(kElf, parameters) + payload.size() + 3) / 4 * 4;
    need(size <= kBelow, "too large: it would be more than 2 MiB, packed");
    Front f = makeFront(base, base + kStubAt, program.slots);
    f.segments[1] = segment(PT_LOAD, PF_R | PF_X, 0, base, size, size, kPage);
    f.segments[2] = segment(PT_LOAD, PF_R | PF_W, 0, program.base, 0, wholePages(program.span), kPage);
    Bytes out = beginFile(f, namedStub().with(names));
    appendPayloadSection(out, program, parameters, payload, 0, size);
    return out;
}

Packed open(const Bytes &file) {
    need(isPacked(kElf, file), kForeign);
    Front f;
    std::memcpy(&f, file.data(), sizeof f);
    uint64_t span = f.segments[2].p_memsz;
    Packed packed = openPayloadSection(file, kPayloadSectionAt, 0, span);
    Program &program = packed.program;
    need(program.base > kBelow, kDamaged);
    for (int i = 0; i < 2; ++i) {
        program.slots[i] = (uint32_t)f.relocations[i].r_offset;
        need(program.slots[i] >= program.base && program.slots[i] - program.base + 8 <= span, kDamaged);
    }
    return packed;
}

Bytes writePlain(const Program &program) {
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

} // namespace

const PackedKind kElf = {kStubAt, namedStub, stubDecode, write, open, writePlain};

} // namespace pack
