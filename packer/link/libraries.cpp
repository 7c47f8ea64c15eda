#include "packer/link/libraries.h"

#include "packer/read/elf_file.h"

namespace pack::linking {

namespace {

constexpr char kCut[] = "a library is cut short: install it again";

struct Reader {
    ElfFile in;
    DynamicFile &file;
    std::vector<Elf64_Shdr> sections = in.sections();
    std::vector<Elf64_Phdr> headers = {};

    const Elf64_Shdr &linked(const Elf64_Shdr &s) const {
        need(s.sh_link < sections.size(), kCut);
        return sections[s.sh_link];
    }
    bool isConstant(uint64_t address) const {
        bool written = false, relro = false;
        for (const Elf64_Phdr &h : headers) {
            if (!within(address, 1, h.p_vaddr, h.p_memsz)) continue;
            written |= h.p_type == PT_LOAD && h.p_flags & PF_W;
            relro |= h.p_type == PT_GNU_RELRO;
        }
        return !written || relro;
    }
    void readDynamicSection(const Elf64_Shdr &s) {
        for (const Elf64_Dyn &d : in.table<Elf64_Dyn>(s, kCut)) {
            if (d.d_tag == DT_NEEDED) file.needed.push_back(in.text(linked(s), d.d_un.d_val));
            if (d.d_tag == DT_SONAME) file.soname = in.text(linked(s), d.d_un.d_val);
            file.ownFolders |= d.d_tag == DT_RPATH || d.d_tag == DT_RUNPATH;
            // The compiler adds one destructor to every library
            if (d.d_tag == DT_FINI_ARRAYSZ) file.destructors = d.d_un.d_val > sizeof(uint64_t);
        }
    }
    void readSymbols(const Elf64_Shdr &table) {
        std::vector<uint16_t> versions;
        for (const Elf64_Shdr &s : sections)
            if (s.sh_type == SHT_GNU_versym) versions = in.table<uint16_t>(s, kCut);
        std::vector<Elf64_Sym> all = in.table<Elf64_Sym>(table, kCut);
        for (size_t i = 1; i < all.size(); ++i) {
            const Elf64_Sym &s = all[i];
            bool defined = s.st_shndx != SHN_UNDEF, old = i < versions.size() && versions[i] & 0x8000;
            if (defined && old) continue;
            int type = ELF64_ST_TYPE(s.st_info);
            file.symbols[in.text(linked(table), s.st_name)] = {
                defined, type == STT_FUNC || type == STT_GNU_IFUNC || type == STT_NOTYPE, type == STT_TLS,
                defined && isConstant(s.st_value), s.st_size};
        }
    }
};

} // namespace

DynamicFile readDynamic(const std::string &path) {
    Bytes bytes = readBytes(path);
    DynamicFile file = {};
    file.path = path;
    Elf64_Ehdr header;
    Reader reader = {{bytes}, file};
    reader.headers = reader.in.programHeaders(header);
    for (const Elf64_Shdr &s : reader.sections) {
        if (s.sh_type == SHT_DYNAMIC) reader.readDynamicSection(s);
        if (s.sh_type == SHT_DYNSYM) reader.readSymbols(s);
    }
    if (file.soname.empty()) file.soname = path.substr(path.rfind('/') + 1);
    return file;
}

} // namespace pack::linking
