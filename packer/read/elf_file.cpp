#include "packer/read/elf_file.h"

namespace pack {

ElfProgram::ElfProgram(const Bytes &bytes) : ElfFile{bytes} {
    need(bytes.size() >= 4 && !std::memcmp(bytes.data(), ELFMAG, SELFMAG), "not an ELF file");
    need(bytes.size() > EI_DATA && bytes[EI_CLASS] == ELFCLASS64,
         "a 32-bit ELF file: only x86-64 can be packed");
    need(bytes[EI_DATA] == ELFDATA2LSB, "a big-endian ELF file: only x86-64 can be packed");
    header = at<Elf64_Ehdr>(0, "cut short: its ELF header is incomplete");
    need(header.e_machine == EM_X86_64, "not for x86-64: programs for other processors cannot be packed");
    need(header.e_type == ET_EXEC || header.e_type == ET_DYN, "not an executable: link it first");
    need(header.e_phentsize == sizeof(Elf64_Phdr) && header.e_phnum > 0 && header.e_phnum < 64,
         "its program headers are invalid: link it again");
    headers = table<Elf64_Phdr>(header.e_phoff, header.e_phnum, "cut short: program headers are missing");
}

const Elf64_Phdr *ElfProgram::firstOf(uint32_t type) const {
    auto found = std::find_if(headers.begin(), headers.end(), [&](auto &h) { return h.p_type == type; });
    return found == headers.end() ? nullptr : &*found;
}

std::vector<Elf64_Phdr> ElfProgram::loads() const {
    std::vector<Elf64_Phdr> loads = headers;
    std::erase_if(loads, [](auto &h) { return h.p_type != PT_LOAD || !h.p_memsz; });
    return loads;
}

uint64_t ElfProgram::offsetOf(uint64_t address, uint64_t size) const {
    for (const Elf64_Phdr &h : loads())
        if (within(address, size, h.p_vaddr, h.p_filesz)) return h.p_offset + (address - h.p_vaddr);
    throw common::Refused("its dynamic section points outside the file");
}

uint64_t ElfProgram::addressOf(uint64_t offset, uint64_t size) const {
    for (const Elf64_Phdr &h : loads())
        if (within(offset, size, h.p_offset, h.p_filesz)) return h.p_vaddr + (offset - h.p_offset);
    return 0;
}

Dynamic ElfProgram::dynamic() const {
    Dynamic dynamic;
    const Elf64_Phdr *segment = firstOf(PT_DYNAMIC);
    if (!segment) return dynamic;
    std::vector<uint64_t> needed;
    for (uint64_t at = 0; at + sizeof(Elf64_Dyn) <= segment->p_filesz; at += sizeof(Elf64_Dyn)) {
        auto entry = inMemory<Elf64_Dyn>(segment->p_vaddr + at);
        if (entry.d_tag == DT_NULL) break;
        if (entry.d_tag == DT_NEEDED)
            needed.push_back(entry.d_un.d_val);
        else
            dynamic.value[entry.d_tag] = entry.d_un.d_val;
    }
    for (uint64_t name : needed) dynamic.needed.push_back(textInMemory(dynamic[DT_STRTAB] + name));
    return dynamic;
}

Program ElfProgram::load() const {
    std::vector<Elf64_Phdr> all = loads();
    need(!all.empty(), "it has nothing to load: it is not a program");
    uint64_t base = all[0].p_vaddr & ~(kPage - 1), end = 0, fileEnd = 0;
    for (const Elf64_Phdr &h : all) {
        need(h.p_memsz <= kMostMemory && within(h.p_vaddr, h.p_memsz, 0, kAddressEnd - kPage) &&
                 h.p_filesz <= h.p_memsz,
             "a segment is over 64 MiB, or beyond 2 GiB: it cannot be packed");
        need(within(h.p_offset, h.p_filesz, 0, bytes.size()),
             "cut short: a segment's bytes are missing: get it again");
        need((h.p_flags & (PF_W | PF_X)) != (PF_W | PF_X),
             "a segment is both writable and executable: link it without -N or -z rwx");
        need(h.p_vaddr >= end, "its segments overlap or are out of order: link it again");
        end = h.p_vaddr + h.p_memsz;
        fileEnd = std::max(fileEnd, h.p_vaddr + h.p_filesz);
    }
    need(end - base <= kMostMemory, "it takes more than 64 MiB of memory: it cannot be packed");
    Program program = {};
    program.base = (uint32_t)base;
    program.span = (uint32_t)(end - base);
    program.bytes.assign(fileEnd - base, 0);
    for (const Elf64_Phdr &h : all)
        std::copy_n(bytes.begin() + (long)h.p_offset, h.p_filesz,
                    program.bytes.begin() + (long)(h.p_vaddr - base));
    return program;
}

void ElfProgram::findCode(Program &program) const {
    uint64_t begin = UINT64_MAX, end = 0;
    auto extend = [&](uint64_t address, uint64_t size) {
        if (!size || !within(address, size, program.base, program.span)) return;
        begin = std::min(begin, address - program.base);
        end = std::max(end, address - program.base + size);
    };
    for (const Elf64_Shdr &s : sections())
        if (s.sh_flags & SHF_ALLOC && s.sh_flags & SHF_EXECINSTR) extend(s.sh_addr, s.sh_size);
    if (!end)
        for (const Elf64_Phdr &h : loads())
            if (h.p_flags & PF_X) extend(h.p_vaddr, h.p_filesz);
    // The program's bytes do not include zeros at the end, even if they are code
    uint64_t all = program.bytes.size();
    program.codeBegin = (uint32_t)std::min({begin, end, all});
    program.codeSize = (uint32_t)std::min(end, all) - program.codeBegin;
}

} // namespace pack
