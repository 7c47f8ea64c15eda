#include "packer/read/programs.h"

#include "packer/read/elf_file.h"

namespace pack {

bool isMadeForPacking(const Bytes &file) {
    try {
        ElfProgram in(file);
        std::vector<std::string> needed = in.dynamic().needed;
        return in.header.e_type == ET_EXEC && needed.size() == 1 &&
               (needed[0] == kLinux.library || needed[0] == kWindows.library);
    } catch (const common::Refused &) {
        return false; // readProgram() throws the reason
    }
}

Program readAnyProgram(const Bytes &file) {
    constexpr uint64_t kLeastAddress = 0x10000; // vm.mmap_min_addr, as distributions set it
    ElfProgram in(file);
    const Elf64_Ehdr &header = in.header;
    Program program = in.load();
    Dynamic dynamic = in.dynamic();
    need(header.e_type == ET_EXEC || !dynamic.value.count(DT_SONAME) || dynamic[DT_FLAGS_1] & DF_1_PIE,
         "a shared library: pack programs, not libraries");
    Elf64_Phdr first = in.loads()[0];
    need(first.p_offset == 0 && first.p_vaddr == program.base && first.p_filesz >= sizeof header,
         "its first segment lacks its ELF header: link it without a linker script");
    need(header.e_type == ET_DYN || program.base >= kLeastAddress,
         "linked below 64 KiB, where Linux maps nothing: link it higher");
    program.readOnly = program.span = (uint32_t)wholePages(program.span);
    // Remove the section headers. The program headers may be in any segment: tools that add headers move them
    Elf64_Ehdr plain = header;
    plain.e_shoff = plain.e_shnum = plain.e_shstrndx = 0;
    uint64_t headersAt = in.addressOf(header.e_phoff, sizeof(Elf64_Phdr) * header.e_phnum);
    need(headersAt,
         "its program headers are in no segment, so the loader would not find them: link it again");
    plain.e_phoff = headersAt - program.base;
    std::memcpy(program.bytes.data(), &plain, sizeof plain);
    program.dropZeros();
    program.bytes.resize(std::max(program.bytes.size(), plain.e_phoff + sizeof(Elf64_Phdr) * header.e_phnum));
    if (const Elf64_Phdr *interpreter = in.firstOf(PT_INTERP)) {
        need(!in.text(interpreter->p_offset, 0).empty() &&
                 within(interpreter->p_vaddr, interpreter->p_filesz, program.base, program.span),
             "its interpreter's name is missing: link it again");
    } else
        need(dynamic.needed.empty(),
             "it needs libraries and names no interpreter: pack programs, not libraries");
    std::vector<Elf64_Phdr> loads = in.loads();
    need(std::any_of(
             loads.begin(), loads.end(),
             [&](auto &h) { return h.p_flags & PF_X && within(header.e_entry, 1, h.p_vaddr, h.p_filesz); }),
         "it has no entry point: pack programs, not libraries");
    program.entry = (uint32_t)header.e_entry;
    program.early = kNothingEarly;
    in.findCode(program);
    return program;
}

uint64_t appendedBytes(const Bytes &file) {
    ElfProgram in(file);
    uint64_t end = in.header.e_shoff + in.header.e_shnum * sizeof(Elf64_Shdr);
    for (const Elf64_Phdr &h : in.headers) end = std::max(end, h.p_offset + h.p_filesz);
    for (const Elf64_Shdr &s : in.sections())
        if (s.sh_type != SHT_NOBITS) end = std::max(end, s.sh_offset + s.sh_size);
    bool padding = std::all_of(file.begin() + (long)std::min<uint64_t>(end, file.size()), file.end(),
                               [](uint8_t byte) { return byte == 0; });
    return padding ? 0 : file.size() - end;
}

} // namespace pack
