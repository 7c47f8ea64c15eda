#include "packer/read/programs.h"

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

} // namespace pack
