#include "packer/write/loader_writer.h"

#include "packer/read/elf_file.h"
#include "packer/stub/stub.h"
#include "stub_loader_bytes.h"

#include <cstring>

namespace pack {

namespace {

constexpr size_t kStubAt = sizeof(LoaderFront), kPayloadSectionAt = kStubAt + sizeof kStubLoader;

NamedStub namedStub() {
    return {kStubLoader, sizeof kStubLoader, kLoaderTexts, (size_t)(stubLoaderName - stubLoaderStart)};
}

LoaderFront makeFront(const Program &program, size_t size) {
    // What the program asks for, by its own headers, which are part of it
    ElfFile own = {program.bytes};
    Elf64_Ehdr header;
    uint64_t alignment = kPage;
    uint32_t stack = PF_R | PF_W;
    for (const Elf64_Phdr &h : own.programHeaders(header)) {
        if (h.p_type == PT_LOAD && header.e_type == ET_DYN) alignment = std::max(alignment, h.p_align);
        if (h.p_type == PT_GNU_STACK) stack |= h.p_flags & PF_X;
    }

    uint64_t base = program.base, fileAt = base + program.span;
    LoaderFront f = {};
    std::memcpy(f.header.e_ident, ELFMAG, SELFMAG);
    f.header.e_ident[EI_CLASS] = ELFCLASS64;
    f.header.e_ident[EI_DATA] = ELFDATA2LSB;
    f.header.e_ident[EI_VERSION] = EV_CURRENT;
    f.header.e_type = header.e_type;
    f.header.e_machine = EM_X86_64;
    f.header.e_version = EV_CURRENT;
    f.header.e_entry = fileAt + kStubAt;
    f.header.e_phoff = offsetof(LoaderFront, program);
    f.header.e_ehsize = sizeof(Elf64_Ehdr);
    f.header.e_phentsize = sizeof(Elf64_Phdr);
    f.header.e_phnum = 3;
    f.program = {PT_LOAD, PF_R | PF_W, 0, base, base, 1, program.span, alignment};
    f.file = {PT_LOAD, PF_R | PF_X, 0, fileAt, fileAt, size, size, kPage};
    f.stackType = PT_GNU_STACK;
    f.stackFlags = stack;
    return f;
}

} // namespace

size_t overheadLoader(const ModelParameters &parameters) {
    return kPayloadSectionAt + payloadSectionOverhead(parameters);
}

std::vector<uint8_t> writePackedLoader(const Program &program, const ModelParameters &parameters,
                                       const std::vector<uint8_t> &payload, const Names &names) {
    size_t size = (overheadLoader(parameters) + payload.size() + 3) / 4 * 4;
    LoaderFront f = makeFront(program, size);
    std::vector<uint8_t> out(kPayloadSectionAt);
    std::memcpy(out.data(), &f, sizeof f);
    std::vector<uint8_t> stub = namedStub().with(names);
    std::copy(stub.begin(), stub.end(), out.begin() + kStubAt);
    appendPayloadSection(out, program, parameters, payload, 0, size);
    return out;
}

std::vector<uint8_t> decodeWithStubLoader(const std::vector<uint8_t> &packed) {
    return decodePayloadSection(packed, kPayloadSectionAt, stubDecodeLoader);
}

bool isPackedLoader(const std::vector<uint8_t> &file) {
    return file.size() > kPayloadSectionAt + sizeof(PayloadHeader) && namedStub().same(file.data() + kStubAt);
}

Program readPackedLoader(const std::vector<uint8_t> &file) {
    need(isPackedLoader(file), "not packed by this version of pack, or damaged at its beginning");
    LoaderFront f;
    std::memcpy(&f, file.data(), sizeof f);
    Packed packed = openPayloadSection(file, kPayloadSectionAt, 0, f.program.p_memsz);
    Workspace workspace;
    packed.program.bytes =
        decode(packed.payload.data(), packed.payload.size(), packed.layout, packed.parameters, workspace);
    return packed.program;
}

std::vector<uint8_t> writePlainLoader(const Program &program) {
    std::vector<uint8_t> out = program.bytes;
    ElfFile own = {program.bytes};
    Elf64_Ehdr header;
    std::vector<Elf64_Phdr> headers = own.programHeaders(header);
    // In this file all lies as in memory
    for (Elf64_Phdr &h : headers)
        if (h.p_filesz) h.p_offset = h.p_vaddr - program.base;
    std::memcpy(out.data() + header.e_phoff, headers.data(), headers.size() * sizeof headers[0]);
    out.resize(program.span);
    return out;
}

} // namespace pack
