#include "packer/link/objects.h"

#include "packer/read/elf_file.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>

namespace pack::linking {

namespace {

constexpr char kCut[] = "an object file is cut short: compile it again";
constexpr std::string_view kArchive = "!<arch>\n", kThin = "!<thin>\n", kBitcode = "BC\xC0\xDE";
constexpr size_t kMemberHeader = 60;

// One object's tables.
struct Reader {
    ElfFile in;
    Object &object;
    std::vector<Elf64_Shdr> sections = in.sections();

    std::string nameOf(const Elf64_Shdr &s) const { return in.nameOf(sections, s); }
    std::string nameOf(const Elf64_Shdr &table, const Elf64_Sym &symbol) const {
        need(table.sh_link < sections.size(), kCut);
        return in.text(sections[table.sh_link], symbol.st_name);
    }

    void readSection(const Elf64_Shdr &s) {
        std::string name = nameOf(s);
        if (name.rfind(".gnu.lto_", 0) == 0) object.code = Code::kGcc;
        if (!(s.sh_flags & SHF_ALLOC) || !s.sh_size) return;
        object.threadLocal |= (s.sh_flags & SHF_TLS) != 0;
        object.constructors |= s.sh_type == SHT_INIT_ARRAY || s.sh_type == SHT_PREINIT_ARRAY;
        object.destructors |= s.sh_type == SHT_FINI_ARRAY;
        object.oldConstructors |= name.rfind(".ctors", 0) == 0 || name.rfind(".dtors", 0) == 0 ||
                                  name == ".init" || name == ".fini";
        object.exceptions |= name.rfind(".gcc_except_table", 0) == 0;
    }
    void readSymbols(const Elf64_Shdr &table) {
        std::vector<Elf64_Sym> all = in.table<Elf64_Sym>(table, kCut);
        for (size_t i = table.sh_info; i < all.size(); ++i) { // local ones come first
            if (all[i].st_shndx != SHN_UNDEF) object.defines.insert(nameOf(table, all[i]));
            object.indirect |= ELF64_ST_TYPE(all[i].st_info) == STT_GNU_IFUNC;
        }
    }
    void readRelocations(const Elf64_Shdr &table) {
        need(table.sh_info < sections.size() && table.sh_link < sections.size(), kCut);
        const Elf64_Shdr &target = sections[table.sh_info], &symbols = sections[table.sh_link];
        if (!(target.sh_flags & SHF_ALLOC) || nameOf(target) == ".eh_frame") return;
        std::vector<Elf64_Sym> all = in.table<Elf64_Sym>(symbols, kCut);
        size_t place = table.sh_offset;
        for (const Elf64_Rela &r : in.table<Elf64_Rela>(table, kCut)) {
            need(ELF64_R_SYM(r.r_info) < all.size(), kCut);
            const Elf64_Sym &s = all[ELF64_R_SYM(r.r_info)];
            if (s.st_shndx == SHN_UNDEF && s.st_name)
                object.references.push_back({nameOf(symbols, s), (uint32_t)ELF64_R_TYPE(r.r_info), place});
            place += sizeof r;
        }
    }
    void read() {
        for (const Elf64_Shdr &s : sections) {
            readSection(s);
            if (s.sh_type == SHT_SYMTAB) readSymbols(s);
            if (s.sh_type == SHT_RELA) readRelocations(s);
        }
    }
};

bool begins(const Bytes &bytes, std::string_view magic) {
    return bytes.size() >= magic.size() && !std::memcmp(bytes.data(), magic.data(), magic.size());
}
bool isElf(const Bytes &bytes) { return bytes.size() >= sizeof(Elf64_Ehdr) && begins(bytes, ELFMAG); }

Object readObject(const std::string &path, const std::string &member, size_t offset, Bytes bytes) {
    Object object = {};
    object.path = path;
    object.member = member;
    object.offset = offset;
    object.bytes = std::move(bytes);
    if (!isElf(object.bytes)) { // an archive may have other files in it
        object.code = begins(object.bytes, kBitcode) ? Code::kClang : Code::kNone;
        return object;
    }
    Elf64_Ehdr header = ElfFile{object.bytes}.at<Elf64_Ehdr>(0, kCut);
    need(header.e_ident[EI_CLASS] == ELFCLASS64 && header.e_machine == EM_X86_64,
         "not for x86-64: only that is packed");
    Reader{{object.bytes}, object}.read();
    return object;
}

std::vector<Object> readArchive(const std::string &path, const Bytes &all) {
    std::vector<Object> objects;
    std::string longNames;
    for (size_t at = kArchive.size(); at + kMemberHeader <= all.size();) {
        std::string header(all.begin() + (long)at, all.begin() + (long)(at + kMemberHeader));
        size_t size = std::strtoull(header.substr(48, 10).c_str(), nullptr, 10);
        at += kMemberHeader;
        need(within(at, size, 0, all.size()), "an archive is cut short: make it again");
        Bytes bytes(all.begin() + (long)at, all.begin() + (long)(at + size));
        std::string name = header.substr(0, 16);
        name.erase(name.find_last_not_of(' ') + 1);
        if (name == "//")
            longNames.assign(bytes.begin(), bytes.end());
        else if (name != "/" && name != "/SYM64/") {
            if (name[0] == '/') {
                size_t from = std::strtoull(name.c_str() + 1, nullptr, 10);
                need(from < longNames.size(), "an archive's names are damaged: make it again");
                name = longNames.substr(from, longNames.find('\n', from) - from);
            }
            if (!name.empty() && name.back() == '/') name.pop_back();
            objects.push_back(readObject(path, name, at, std::move(bytes)));
        }
        at += size + (size & 1);
    }
    return objects;
}

} // namespace

FileKind kindOf(const std::string &path) {
    if (!std::filesystem::is_regular_file(path)) return FileKind::kMissing;
    Bytes bytes = readBytes(path);
    if (begins(bytes, kArchive)) return FileKind::kArchive;
    if (begins(bytes, kThin)) return FileKind::kThinArchive;
    if (begins(bytes, kBitcode)) return FileKind::kBitcode;
    if (!isElf(bytes)) return FileKind::kOther;
    uint16_t type = ElfFile{bytes}.at<Elf64_Ehdr>(0, kCut).e_type;
    if (type == ET_REL) return FileKind::kObject;
    bool library = type == ET_DYN && !(ElfProgram(bytes).dynamic()[DT_FLAGS_1] & DF_1_PIE);
    return library ? FileKind::kLibrary : FileKind::kProgram;
}

std::vector<Object> readObjects(const std::string &path) {
    Bytes bytes = readBytes(path);
    return common::inFile(path, [&] {
        need(!begins(bytes, kThin), "a thin archive: make it with ar rcs, without T");
        if (begins(bytes, kArchive)) return readArchive(path, bytes);
        std::vector<Object> one;
        one.push_back(readObject(path, "", 0, std::move(bytes)));
        return one;
    });
}

Taken readLinkerMap(const std::string &map) {
    // "archive.a(member.o)   because.o (symbol)", where the second half may stand on the next line
    static const std::regex kLoad("LOAD (.*)"), kMember(R"((\S.*?)\(([^()]+)\)(\s.*)?)");
    Taken taken;
    std::istringstream lines(map);
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_match(line, match, kMember)) taken.members.emplace(match[1], match[2]);
        if (!std::regex_match(line, match, kLoad)) continue;
        if (std::find(taken.files.begin(), taken.files.end(), match[1]) == taken.files.end())
            taken.files.push_back(match[1]);
    }
    return taken;
}

bool makeSlots(Object &object, const std::set<std::string> &symbols) {
    bool any = false;
    for (const Reference &r : object.references) {
        if (!symbols.count(r.symbol) ||
            (r.type != R_X86_64_GOTPCREL && r.type != R_X86_64_GOTPCRELX && r.type != R_X86_64_REX_GOTPCRELX))
            continue;
        uint32_t type = R_X86_64_PC32;
        std::memcpy(object.bytes.data() + r.place + offsetof(Elf64_Rela, r_info), &type, sizeof type);
        any = true;
    }
    return any;
}

} // namespace pack::linking
