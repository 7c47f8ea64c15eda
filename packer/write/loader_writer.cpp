#include "packer/read/elf_file.h"
#include "packer/stub/stub.h"
#include "packer/write/elf_header.h"
#include "packer/write/packed_file.h"
#include "stub_loader_bytes.h"

#include <cstring>

namespace pack {

namespace {

constexpr size_t kStubAt = sizeof(LoaderFront), kPayloadSectionAt = kStubAt + sizeof kStubLoader;

NamedStub namedStub() {
    return {kStubLoader, sizeof kStubLoader, kLoaderMessages, (size_t)(stubLoaderName - stubLoaderStart)};
}

LoaderFront makeFront(const Program &program, size_t size) {
    // Alignment and stack are those of the program's own headers, which are part of it
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
    f.header = elfHeader(header.e_type, fileAt + kStubAt, offsetof(LoaderFront, program), 3);
    f.program = {PT_LOAD, PF_R | PF_W, 0, base, base, 1, program.span, alignment};
    f.file = {PT_LOAD, PF_R | PF_X, 0, fileAt, fileAt, size, size, kPage};
    f.stackType = PT_GNU_STACK;
    f.stackFlags = stack;
    return f;
}

Bytes write(const Program &program, const ModelParameters &parameters, const Bytes &payload,
            const Names &names) {
    size_t size = (overhead(kLoader, parameters) + payload.size() + 3) / 4 * 4;
    LoaderFront f = makeFront(program, size);
    Bytes out = beginFile(f, namedStub().with(names));
    appendPayloadSection(out, program, parameters, payload, 0, size);
    return out;
}

Packed open(const Bytes &file) {
    need(isPacked(kLoader, file), kForeign);
    LoaderFront f;
    std::memcpy(&f, file.data(), sizeof f);
    return openPayloadSection(file, kPayloadSectionAt, 0, f.program.p_memsz);
}

Bytes writePlain(const Program &program) {
    Bytes out = program.bytes;
    ElfProgram own(program.bytes);
    // The file is laid out like memory
    for (Elf64_Phdr &h : own.headers)
        if (h.p_filesz) h.p_offset = h.p_vaddr - program.base;
    std::memcpy(out.data() + own.header.e_phoff, own.headers.data(), own.headers.size() * sizeof(Elf64_Phdr));
    out.resize(program.span);
    return out;
}

} // namespace

const PackedKind kLoader = {kStubAt, namedStub, stubDecodeLoader, write, open, writePlain};

} // namespace pack
