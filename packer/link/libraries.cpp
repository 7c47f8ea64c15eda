#include "packer/link/libraries.h"

#include "packer/read/elf_file.h"

namespace pack::linking {

namespace {

constexpr char kCut[] = "a library is cut short: install it again";

bool isConstant(const ElfProgram &in, uint64_t address) {
    bool written = false, relro = false;
    for (const Elf64_Phdr &h : in.headers) {
        if (!within(address, 1, h.p_vaddr, h.p_memsz)) continue;
        written |= h.p_type == PT_LOAD && h.p_flags & PF_W;
        relro |= h.p_type == PT_GNU_RELRO;
    }
    return !written || relro;
}

void readSymbols(const ElfProgram &in, DynamicFile &file) {
    std::vector<Elf64_Shdr> sections = in.sections();
    std::vector<uint16_t> versions;
    for (const Elf64_Shdr &s : sections)
        if (s.sh_type == SHT_GNU_versym) versions = in.table<uint16_t>(s, kCut);
    for (const Elf64_Shdr &table : sections) {
        if (table.sh_type != SHT_DYNSYM) continue;
        need(table.sh_link < sections.size(), kCut);
        std::vector<Elf64_Sym> all = in.table<Elf64_Sym>(table, kCut);
        for (size_t i = 1; i < all.size(); ++i) {
            const Elf64_Sym &s = all[i];
            bool defined = s.st_shndx != SHN_UNDEF, old = i < versions.size() && versions[i] & 0x8000;
            if (defined && old) continue;
            int type = ELF64_ST_TYPE(s.st_info);
            file.symbols[in.text(sections[table.sh_link], s.st_name)] = {
                defined, type == STT_FUNC || type == STT_GNU_IFUNC || type == STT_NOTYPE, type == STT_TLS,
                defined && isConstant(in, s.st_value), s.st_size};
        }
    }
}

} // namespace

DynamicFile readDynamic(const std::string &path) {
    Bytes bytes = readBytes(path);
    ElfProgram in(bytes);
    Dynamic dynamic = in.dynamic();
    DynamicFile file = {};
    file.path = path;
    file.soname = dynamic.value.count(DT_SONAME) ? in.textInMemory(dynamic[DT_STRTAB] + dynamic[DT_SONAME])
                                                 : path.substr(path.rfind('/') + 1);
    file.needed = dynamic.needed;
    file.ownFolders = dynamic.value.count(DT_RPATH) || dynamic.value.count(DT_RUNPATH);
    file.destructors = dynamic[DT_FINI_ARRAYSZ] > sizeof(uint64_t); // the compiler adds one to every library
    readSymbols(in, file);
    return file;
}

} // namespace pack::linking
