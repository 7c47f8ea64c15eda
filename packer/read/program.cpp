#include "packer/read/program.h"

#include "packer/read/elf_file.h"

namespace pack {

namespace {

void wipe(Program &program, uint64_t address, uint64_t size) {
    if (address < program.base) return;
    uint64_t start = address - program.base, all = program.bytes.size();
    if (start < all) std::fill_n(program.bytes.begin() + (long)start, std::min(size, all - start), 0);
}

// Checks the segments and loads them.
Program loadSegments(const ElfProgram &in) {
    need(!in.firstOf(PT_TLS), "it has thread-local storage, which is not supported");
    const Elf64_Phdr *stack = in.firstOf(PT_GNU_STACK);
    need(!stack || !(stack->p_flags & PF_X),
         "it needs an executable stack, which it would not get: link it with -z noexecstack");
    Program program = in.load();
    uint64_t codeEnd = 0, firstWritten = UINT64_MAX;
    for (const Elf64_Phdr &h : in.loads())
        if (h.p_flags & PF_W)
            firstWritten = std::min(firstWritten, uint64_t(h.p_vaddr));
        else
            codeEnd = h.p_vaddr + h.p_memsz;
    static_assert(kLeastBase == 0x210000); // the number in the message
    need(program.base >= kLeastBase,
         "linked below 0x210000, in the space of the packed file: link it higher (-Ttext-segment)");
    need(codeEnd <= (firstWritten & ~(kPage - 1)),
         "writable data is before the code or shares a page with it: "
         "link the data after the code, on separate pages");
    program.readOnly = (uint32_t)wholePages(codeEnd - program.base);
    return program;
}

// Finds the slots of the two imports. Refuses other imports, a PLT, constructors and destructors.
void findImports(const ElfProgram &in, const Dynamic &dynamic, const System &system, Program &program) {
    for (int64_t tag : {DT_INIT, DT_FINI, DT_INIT_ARRAY, DT_FINI_ARRAY, DT_PREINIT_ARRAY})
        need(!dynamic.value.count(tag), "it has constructors or destructors, which would not run");
    need(!dynamic[DT_JMPREL], "it calls through a PLT: compile with -fno-plt");
    std::string both = std::string(system.functions[0]) + " and " + system.functions[1],
                onlyThem = "it must import " + both + " and nothing else";
    need(dynamic.needed == std::vector<std::string>{system.library},
         "it must need " + std::string(system.library) + " and no other library");
    need(dynamic[DT_RELASZ] == 2 * sizeof(Elf64_Rela), onlyThem);
    bool found[2] = {};
    for (uint64_t i = 0; i < 2; ++i) {
        auto r = in.inMemory<Elf64_Rela>(dynamic[DT_RELA] + i * sizeof(Elf64_Rela));
        auto symbol = in.inMemory<Elf64_Sym>(dynamic[DT_SYMTAB] + ELF64_R_SYM(r.r_info) * sizeof(Elf64_Sym));
        std::string name = in.textInMemory(dynamic[DT_STRTAB] + symbol.st_name);
        bool second = name == system.functions[1];
        need(second || name == system.functions[0], onlyThem);
        need(ELF64_R_TYPE(r.r_info) == R_X86_64_GLOB_DAT && r.r_addend == 0,
             "an import is not of type GLOB_DAT");
        need(program.readOnly < program.span &&
                 within(r.r_offset, 8, program.base + program.readOnly, program.span - program.readOnly),
             "an import's slot is not in writable memory");
        program.slots[second] = (uint32_t)r.r_offset;
        found[second] = true;
    }
    need(found[0] && found[1], "it must import both " + both);
    need(program.slots[0] + 8 == program.slots[1] || program.slots[1] + 8 == program.slots[0],
         "the slots of its two imports are not adjacent: link it without other GOT entries");
}

// Zeroes the tables that only the loader reads.
void wipeTables(const ElfProgram &in, const Dynamic &dynamic, Program &program) {
    wipe(program, dynamic[DT_RELA], dynamic[DT_RELASZ]);
    wipe(program, dynamic[DT_SYMTAB], 3 * sizeof(Elf64_Sym));
    wipe(program, dynamic[DT_STRTAB], dynamic[DT_STRSZ]);
    if (uint64_t hash = dynamic[DT_HASH])
        wipe(program, hash,
             4 * (2 + uint64_t(in.inMemory<uint32_t>(hash)) + in.inMemory<uint32_t>(hash + 4)));
    for (const Elf64_Phdr &h : in.headers) {
        if (h.p_type == PT_DYNAMIC || h.p_type == PT_INTERP) wipe(program, h.p_vaddr, h.p_memsz);
        if (h.p_type != PT_LOAD || h.p_offset) continue;
        // The headers are part of the image
        wipe(program, h.p_vaddr, sizeof(Elf64_Ehdr));
        wipe(program, h.p_vaddr + in.header.e_phoff, in.headers.size() * sizeof(Elf64_Phdr));
    }
    program.dropZeros();
}

// Finds the early part and its function.
void findEarly(const ElfProgram &in, Program &program) {
    uint64_t after = UINT64_MAX;
    program.early = kNothingEarly;
    std::vector<Elf64_Shdr> all = in.sections();
    auto isLoaded = [](const Elf64_Shdr &s) { return s.sh_flags & SHF_ALLOC; };
    for (const Elf64_Shdr &s : all) {
        if (!isLoaded(s) || !s.sh_size) continue;
        need(within(s.sh_addr, s.sh_size, program.base, program.span), "a section is outside the segments");
        if (in.nameOf(all, s) != ".early") continue;
        program.early = (uint32_t)wholePages(s.sh_addr + s.sh_size - program.base);
        program.earlyEntry = (uint32_t)s.sh_addr;
    }
    if (program.early == kNothingEarly) return;
    for (const Elf64_Shdr &s : all)
        if (isLoaded(s) && s.sh_addr > program.earlyEntry) after = std::min(after, s.sh_addr);
    need(after >= program.base + program.early && program.early <= program.readOnly,
         "other sections follow .early in its last page: align its end to a page");
}

} // namespace

Program readProgram(const Bytes &file, const System &system) {
    ElfProgram in(file);
    need(in.header.e_type == ET_EXEC, "position-independent: link it with -no-pie");
    Program program = loadSegments(in);
    const Elf64_Phdr *interpreter = in.firstOf(PT_INTERP);
    need((interpreter || !system.interpreter) && in.firstOf(PT_DYNAMIC),
         std::string("statically linked: it must import ") + system.functions[0] + " and " +
             system.functions[1] + " from " + system.library);
    need(!system.interpreter || in.textInMemory(interpreter->p_vaddr) == system.interpreter,
         "its interpreter is not /lib64/ld-linux-x86-64.so.2");
    need(within(in.header.e_entry, 1, program.base, program.readOnly), "its entry point is outside its code");
    program.entry = (uint32_t)in.header.e_entry;
    Dynamic dynamic = in.dynamic();
    findImports(in, dynamic, system, program);
    wipeTables(in, dynamic, program);
    findEarly(in, program);
    in.findCode(program);
    return program;
}

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
