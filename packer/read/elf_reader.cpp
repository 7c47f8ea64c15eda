#include "packer/read/elf_reader.h"

#include "packer/read/elf_file.h"

#include <algorithm>
#include <cstring>
#include <map>

namespace pack {

namespace {

// The program's memory, read and wiped by address.
struct Memory {
    Program &program;

    template <class T> T at(uint64_t address) const {
        need(within(address, sizeof(T), program.base, program.bytes.size()),
             "its dynamic section points outside the program");
        T value;
        std::memcpy(&value, program.bytes.data() + (address - program.base), sizeof value);
        return value;
    }
    std::string text(uint64_t address) const {
        std::string s;
        while (char c = at<char>(address++)) s += c;
        return s;
    }
    void wipe(uint64_t address, uint64_t size) {
        if (address < program.base) return;
        uint64_t start = address - program.base, all = program.bytes.size();
        if (start < all) std::fill_n(program.bytes.begin() + (long)start, std::min(size, all - start), 0);
    }
};

// Checks the segments and lays them out as they will lie in memory.
void loadSegments(const ElfFile &in, const std::vector<Elf64_Phdr> &headers, Program &program) {
    std::vector<Elf64_Phdr> loads;
    for (const Elf64_Phdr &h : headers) {
        need(h.p_type != PT_TLS, "it has thread-local storage, which is not supported");
        need(h.p_type != PT_GNU_STACK || !(h.p_flags & PF_X),
             "it needs an executable stack, which it would not get: link it with -z noexecstack");
        if (h.p_type == PT_LOAD && h.p_memsz) loads.push_back(h);
    }
    need(!loads.empty(), "nothing to load in it");
    std::sort(loads.begin(), loads.end(), [](auto &a, auto &b) { return a.p_vaddr < b.p_vaddr; });
    uint64_t end = 0, fileEnd = 0, codeEnd = 0, firstWritten = UINT64_MAX;
    for (const Elf64_Phdr &h : loads) {
        in.checkSegment(h, end);
        end = h.p_vaddr + h.p_memsz;
        fileEnd = std::max(fileEnd, h.p_vaddr + h.p_filesz);
        if (h.p_flags & PF_W)
            firstWritten = std::min(firstWritten, uint64_t(h.p_vaddr));
        else
            codeEnd = end;
    }
    uint64_t base = loads[0].p_vaddr & ~(kPage - 1), writtenPage = firstWritten & ~(kPage - 1);
    static_assert(kLeastBase == 0x210000 && kMostMemory == 64 << 20); // as in the messages
    need(base >= kLeastBase,
         "linked below 0x210000, where the packed file must go: link it higher (-Ttext-segment)");
    need(end - base <= kMostMemory, "its segments lie too far apart: over 64 MiB from first to last");
    need(codeEnd <= writtenPage, "writable data shares a page with code or lies before it: link data behind "
                                 "code, on a page of its own");
    program.base = (uint32_t)base;
    program.span = (uint32_t)(end - base);
    program.bytes.assign(fileEnd - base, 0);
    program.readOnly = (uint32_t)wholePages(codeEnd - base);
    in.copySegments(loads, base, program.bytes);
}

// The entries of the dynamic section that matter here.
struct Dynamic {
    std::vector<uint64_t> needed;      // names of libraries
    std::map<int64_t, uint64_t> value; // of other entries, by their tags
};

// Refuses what the packed program would not have: a PLT, constructors, destructors.
Dynamic readDynamic(const Elf64_Phdr &segment, const Memory &memory) {
    Dynamic dynamic;
    need(segment.p_memsz < 4096, "its dynamic section makes no sense");
    for (uint64_t a = segment.p_vaddr; a + sizeof(Elf64_Dyn) <= segment.p_vaddr + segment.p_memsz;
         a += sizeof(Elf64_Dyn)) {
        auto d = memory.at<Elf64_Dyn>(a);
        if (d.d_tag == DT_NEEDED)
            dynamic.needed.push_back(d.d_un.d_val);
        else
            dynamic.value[d.d_tag] = d.d_un.d_val;
    }
    for (int64_t tag : {DT_INIT, DT_FINI, DT_INIT_ARRAY, DT_FINI_ARRAY, DT_PREINIT_ARRAY})
        need(!dynamic.value.count(tag), "it has constructors or destructors, which would not run");
    need(!dynamic.value.count(DT_JMPREL), "it calls through a PLT: compile with -fno-plt");
    return dynamic;
}

// Finds the slots of the two imports, and refuses all others.
void findImports(Dynamic &dynamic, const Memory &memory, const System &system, Program &program) {
    std::string two = std::string(system.functions[0]) + " and " + system.functions[1],
                onlyThem = "it must import " + two + " and nothing else";
    need(dynamic.needed.size() == 1 &&
             memory.text(dynamic.value[DT_STRTAB] + dynamic.needed[0]) == system.library,
         "it must need " + std::string(system.library) + " and no other library");
    need(dynamic.value[DT_RELASZ] == 2 * sizeof(Elf64_Rela), onlyThem);
    bool found[2] = {};
    for (int i = 0; i < 2; ++i) {
        auto r = memory.at<Elf64_Rela>(dynamic.value[DT_RELA] + (uint64_t)i * sizeof(Elf64_Rela));
        auto symbol =
            memory.at<Elf64_Sym>(dynamic.value[DT_SYMTAB] + ELF64_R_SYM(r.r_info) * sizeof(Elf64_Sym));
        std::string name = memory.text(dynamic.value[DT_STRTAB] + symbol.st_name);
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
    need(found[0] && found[1], "it must import both " + two);
    need(program.slots[0] + 8 == program.slots[1] || program.slots[1] + 8 == program.slots[0],
         "the slots of its two imports do not lie side by side: link it without other GOT entries");
}

// Zeroes what only the loader reads.
void wipeDynamic(const Elf64_Phdr &segment, Dynamic &dynamic, Memory &memory) {
    memory.wipe(dynamic.value[DT_RELA], dynamic.value[DT_RELASZ]);
    memory.wipe(dynamic.value[DT_SYMTAB], 3 * sizeof(Elf64_Sym));
    memory.wipe(dynamic.value[DT_STRTAB], dynamic.value[DT_STRSZ]);
    if (uint64_t hash = dynamic.value[DT_HASH])
        memory.wipe(hash, 4 * (2 + uint64_t(memory.at<uint32_t>(hash)) + memory.at<uint32_t>(hash + 4)));
    memory.wipe(segment.p_vaddr, segment.p_memsz);
}

// Finds the instructions and the early part, by the section headers if there are any.
void readSections(const ElfFile &in, const Elf64_Ehdr &header, const std::vector<Elf64_Phdr> &headers,
                  Program &program) {
    uint64_t begin = UINT64_MAX, end = 0, afterEarly = UINT64_MAX;
    auto extend = [&](uint64_t address, uint64_t size) {
        begin = std::min(begin, address);
        end = std::max(end, address + size);
    };
    program.early = kNothingEarly;
    std::vector<Elf64_Shdr> sections = in.sections();
    Elf64_Shdr names = sections.empty() ? Elf64_Shdr{} : sections[header.e_shstrndx];
    std::erase_if(sections, [](auto &s) { return !(s.sh_flags & SHF_ALLOC); });
    for (const Elf64_Shdr &s : sections) {
        if (!s.sh_size) continue;
        need(within(s.sh_addr, s.sh_size, program.base, program.span), "a section lies outside the segments");
        if (s.sh_flags & SHF_EXECINSTR) extend(s.sh_addr, s.sh_size);
        if (in.text(names, s.sh_name) != ".early") continue;
        program.early = (uint32_t)wholePages(s.sh_addr + s.sh_size - program.base);
        program.earlyEntry = (uint32_t)s.sh_addr;
    }
    for (const Elf64_Shdr &s : sections)
        if (program.early != kNothingEarly && s.sh_addr > program.earlyEntry)
            afterEarly = std::min(afterEarly, s.sh_addr);
    need(program.early == kNothingEarly ||
             (afterEarly >= program.base + program.early && program.early <= program.readOnly),
         "its section .early does not end on a page of its own");
    if (!end)
        for (const Elf64_Phdr &h : headers)
            if (h.p_type == PT_LOAD && h.p_flags & PF_X && h.p_memsz) extend(h.p_vaddr, h.p_filesz);
    // Zeros at the end of the program are not among its bytes, even if they are code
    uint64_t all = program.bytes.size();
    program.codeBegin = (uint32_t)std::min(begin - program.base, all);
    program.codeSize = (uint32_t)std::min(end - program.base, all) - program.codeBegin;
}

} // namespace

Program readProgram(const Bytes &file, const System &system) {
    ElfFile in = {file};
    Elf64_Ehdr header;
    std::vector<Elf64_Phdr> headers = in.programHeaders(header);
    need(header.e_type == ET_EXEC, "position-independent: link it with -no-pie");
    Program program = {};
    loadSegments(in, headers, program);
    const Elf64_Phdr *dynamic = nullptr, *interpreter = nullptr;
    for (const Elf64_Phdr &h : headers) {
        if (h.p_type == PT_DYNAMIC) dynamic = &h;
        if (h.p_type == PT_INTERP) interpreter = &h;
    }
    need((interpreter || !system.interpreter) && dynamic,
         std::string("statically linked: it must import ") + system.functions[0] + " and " +
             system.functions[1] + " from " + system.library);
    Memory memory = {program};
    need(!system.interpreter || memory.text(interpreter->p_vaddr) == system.interpreter,
         "its interpreter is not /lib64/ld-linux-x86-64.so.2");
    need(header.e_entry >= program.base && header.e_entry < program.base + program.readOnly,
         "its entry point lies outside its code");
    program.entry = (uint32_t)header.e_entry;
    Dynamic tables = readDynamic(*dynamic, memory);
    findImports(tables, memory, system, program);
    wipeDynamic(*dynamic, tables, memory);
    if (interpreter) memory.wipe(interpreter->p_vaddr, interpreter->p_memsz);
    // The headers, where they are part of the image
    for (const Elf64_Phdr &h : headers)
        if (h.p_type == PT_LOAD && h.p_offset == 0) {
            memory.wipe(h.p_vaddr, sizeof(Elf64_Ehdr));
            memory.wipe(h.p_vaddr + header.e_phoff, (uint64_t)header.e_phnum * sizeof(Elf64_Phdr));
        }
    while (program.bytes.size() > 1 && !program.bytes.back()) program.bytes.pop_back();
    readSections(in, header, headers, program);
    return program;
}

} // namespace pack
