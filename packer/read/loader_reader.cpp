#include "packer/read/loader_reader.h"

#include "packer/read/elf_file.h"

#include <optional>

namespace pack {

namespace {

using Headers = std::vector<Elf64_Phdr>;

constexpr uint64_t kLeastAddress = 0x10000; // vm.mmap_min_addr, as distributions set it

std::optional<Elf64_Phdr> find(const Headers &headers, uint32_t type) {
    for (const Elf64_Phdr &h : headers)
        if (h.p_type == type) return h;
    return {};
}

// The libraries that a program names; empty for a static one.
std::vector<std::string> libraries(const ElfFile &in, const Headers &headers) {
    constexpr char kOutside[] = "its dynamic section points outside the file";
    std::vector<std::string> names;
    std::vector<uint64_t> needed;
    uint64_t strings = 0;
    std::optional<Elf64_Phdr> dynamic = find(headers, PT_DYNAMIC);
    if (!dynamic) return names;
    for (uint64_t at = 0; at + sizeof(Elf64_Dyn) <= dynamic->p_filesz; at += sizeof(Elf64_Dyn)) {
        need(within(dynamic->p_offset, at + sizeof(Elf64_Dyn), 0, in.bytes.size()), kOutside);
        auto d = in.at<Elf64_Dyn>(dynamic->p_offset + at, kOutside);
        if (d.d_tag == DT_NULL) break;
        if (d.d_tag == DT_NEEDED) needed.push_back(d.d_un.d_val);
        if (d.d_tag == DT_STRTAB) strings = d.d_un.d_ptr;
    }
    for (const Elf64_Phdr &h : headers)
        if (h.p_type == PT_LOAD && within(strings, 1, h.p_vaddr, h.p_filesz)) {
            for (uint64_t name : needed) names.push_back(in.text(h.p_offset + (strings - h.p_vaddr), name));
            break;
        }
    return names;
}

// Lays the segments out as they will lie in memory.
void loadSegments(const ElfFile &in, const Elf64_Ehdr &header, const Headers &headers, Program &program) {
    Headers loads = headers;
    std::erase_if(loads, [](auto &h) { return h.p_type != PT_LOAD || !h.p_memsz; });
    need(!loads.empty(), "nothing to load in it: it is no program");
    uint64_t end = 0, fileEnd = 0;
    for (const Elf64_Phdr &h : loads) {
        in.checkSegment(h, end);
        end = h.p_vaddr + h.p_memsz;
        fileEnd = std::max(fileEnd, h.p_vaddr + h.p_filesz);
    }
    const Elf64_Phdr &first = loads[0];
    uint64_t base = first.p_vaddr & ~(kPage - 1);
    need(first.p_offset == 0 && first.p_vaddr == base && first.p_filesz >= sizeof header &&
             within(header.e_phoff, sizeof(Elf64_Phdr) * header.e_phnum, 0, first.p_filesz),
         "its first segment lacks its headers: link it without a script that leaves them out");
    need(header.e_type == ET_DYN || base >= kLeastAddress,
         "it lies below 64 KiB, where Linux maps nothing: link it higher");
    need(end - base <= kMostMemory, "it takes more than 64 MiB of memory: it cannot be packed");
    program.base = (uint32_t)base;
    program.readOnly = program.span = (uint32_t)wholePages(end - base);
    program.bytes.assign(fileEnd - base, 0);
    in.copySegments(loads, base, program.bytes);
    // The section headers are not kept
    Elf64_Ehdr without = header;
    without.e_shoff = without.e_shnum = without.e_shstrndx = 0;
    std::memcpy(program.bytes.data(), &without, sizeof without);
    while (!program.bytes.back()) program.bytes.pop_back();
}

// Finds the stretch from the first instruction to the last: by section headers, or else whole segments.
void findCode(const ElfFile &in, const Headers &headers, Program &program) {
    uint64_t begin = UINT64_MAX, end = 0, all = program.bytes.size();
    auto extend = [&](uint64_t address, uint64_t size) {
        if (!within(address, size, program.base, program.span) || !size) return;
        begin = std::min(begin, address - program.base);
        end = std::max(end, address - program.base + size);
    };
    for (const Elf64_Shdr &s : in.sections())
        if (s.sh_flags & SHF_ALLOC && s.sh_flags & SHF_EXECINSTR) extend(s.sh_addr, s.sh_size);
    if (!end)
        for (const Elf64_Phdr &h : headers)
            if (h.p_type == PT_LOAD && h.p_flags & PF_X) extend(h.p_vaddr, h.p_filesz);
    program.codeBegin = (uint32_t)std::min(begin, all);
    program.codeSize = (uint32_t)std::min(end, all) - std::min(program.codeBegin, (uint32_t)end);
}

} // namespace

bool isMadeForPacking(const Bytes &file) {
    try {
        ElfFile in = {file};
        Elf64_Ehdr header;
        std::vector<std::string> names = libraries(in, in.programHeaders(header));
        return header.e_type == ET_EXEC && names.size() == 1 &&
               (names[0] == kLinux.library || names[0] == kWindows.library);
    } catch (const common::Refused &) {
        return false; // reading it gives the reason
    }
}

Program readAnyProgram(const Bytes &file) {
    ElfFile in = {file};
    Elf64_Ehdr header;
    Headers headers = in.programHeaders(header);
    Program program = {};
    loadSegments(in, header, headers, program);
    if (std::optional<Elf64_Phdr> interpreter = find(headers, PT_INTERP)) {
        need(!in.text(interpreter->p_offset, 0).empty() &&
                 within(interpreter->p_vaddr, interpreter->p_filesz, program.base, program.bytes.size()),
             "its interpreter's name is missing: link it afresh");
    } else
        need(libraries(in, headers).empty(),
             "it needs libraries and names no interpreter: pack programs, not libraries");
    bool starts = false;
    for (const Elf64_Phdr &h : headers)
        starts |= h.p_type == PT_LOAD && h.p_flags & PF_X && within(header.e_entry, 1, h.p_vaddr, h.p_filesz);
    need(starts, "it has no entry point: pack programs, not libraries");
    program.entry = (uint32_t)header.e_entry;
    program.early = kNothingEarly;
    findCode(in, headers, program);
    return program;
}

uint64_t appendedBytes(const Bytes &file) {
    ElfFile in = {file};
    Elf64_Ehdr header;
    uint64_t end = 0;
    for (const Elf64_Phdr &h : in.programHeaders(header)) end = std::max(end, h.p_offset + h.p_filesz);
    end = std::max(end, header.e_shoff + header.e_shnum * sizeof(Elf64_Shdr));
    for (const Elf64_Shdr &s : in.sections())
        if (s.sh_type != SHT_NOBITS) end = std::max(end, s.sh_offset + s.sh_size);
    bool padding = std::all_of(file.begin() + (long)std::min<uint64_t>(end, file.size()), file.end(),
                               [](uint8_t byte) { return byte == 0; });
    return padding ? 0 : file.size() - end;
}

} // namespace pack
