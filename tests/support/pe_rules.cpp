#include "tests/support/pe_rules.h"

namespace {

// Reads fields by their offsets from the specification's tables; it shares no code with the writer.
struct File {
    const std::vector<uint8_t> &bytes;
    uint64_t at(uint64_t offset, int size) const {
        uint64_t value = 0;
        for (int i = 0; i < size; ++i)
            value |= (uint64_t)(offset + (uint64_t)i < bytes.size() ? bytes[offset + (uint64_t)i] : 0)
                     << 8 * i;
        return value;
    }
    std::string text(uint64_t offset) const {
        std::string s;
        while (char c = (char)at(offset++, 1)) s += c;
        return s;
    }
    uint64_t header() const { return at(0x3c, 4); }
    uint64_t optional() const { return header() + 24; }
    uint64_t sections() const { return optional() + at(header() + 20, 2); }
    int sectionCount() const { return (int)at(header() + 6, 2); }
    struct Section {
        uint64_t memorySize, address, fileSize, fileAt, flags;
    };
    Section section(int i) const {
        uint64_t s = sections() + 40 * (uint64_t)i;
        return {at(s + 8, 4), at(s + 12, 4), at(s + 16, 4), at(s + 20, 4), at(s + 36, 4)};
    }
    uint64_t directory(int i, int field) const {
        return at(optional() + 112 + 8 * (uint64_t)i + 4 * (uint64_t)field, 4);
    }
    // Returns the offset in the file of an address of the image; 0 if the file does not have it
    uint64_t inFile(uint64_t address) const {
        for (int i = 0; i < sectionCount(); ++i) {
            Section s = section(i);
            if (address >= s.address && address < s.address + s.fileSize)
                return address - s.address + s.fileAt;
        }
        return 0;
    }
};

constexpr uint64_t kExecute = 0x20000000, kRead = 0x40000000, kWrite = 0x80000000;

} // namespace

std::string brokenPeRule(const std::vector<uint8_t> &bytes) {
    File f = {bytes};
    uint64_t o = f.optional(), page = f.at(o + 32, 4), fileAlign = f.at(o + 36, 4), headers = f.at(o + 60, 4),
             base = f.at(o + 24, 8), image = f.at(o + 56, 4), entry = f.at(o + 16, 4);
    if (f.at(0, 2) != 0x5a4d) return "no MZ";
    if (f.header() % 4 || f.header() < 0x40) return "the header overlaps the DOS header";
    if (f.at(f.header(), 4) != 0x4550 || f.at(f.header() + 4, 2) != 0x8664 || f.at(o, 2) != 0x20b)
        return "not PE32+ for x86-64";
    if (!(f.at(f.header() + 22, 2) & 2)) return "not marked as executable";
    if (f.at(f.header() + 20, 2) < 112 + 8 * f.at(o + 108, 4) || f.at(o + 108, 4) > 16)
        return "the directories do not fit into the optional header";
    if (page != 4096 || fileAlign < 512 || fileAlign & (fileAlign - 1)) return "odd alignment";
    if (headers % fileAlign || headers < f.sections() + 40 * (uint64_t)f.sectionCount() ||
        headers > bytes.size())
        return "wrong size of the headers";
    if (base % 0x10000) return "the base is not a multiple of 64 KB";
    if (!(f.at(f.header() + 22, 2) & 1) || f.at(o + 70, 2) & 0x40) return "it can be relocated";
    if (f.at(o + 40, 2) < 5 || f.at(o + 48, 2) < 6) return "for a Windows before Vista";
    if (f.at(o + 52, 4)) return "Win32VersionValue";
    if (!(f.at(o + 70, 2) & 0x100)) return "data may be executed";
    if (f.at(o + 68, 2) != 2) return "not for a graphical session";
    if (f.at(o + 80, 8) > f.at(o + 72, 8) || f.at(o + 96, 8) > f.at(o + 88, 8))
        return "commits more than it reserves";

    int count = f.sectionCount();
    if (count < 1) return "no sections";
    uint64_t next = page;
    bool entered = false;
    for (int i = 0; i < count; ++i) {
        File::Section s = f.section(i);
        if (s.address != next) return "a gap before a section";
        if (!s.memorySize) return "an empty section";
        next = (s.address + s.memorySize + page - 1) / page * page;
        if (s.fileSize % fileAlign || s.fileAt % fileAlign)
            return "a section's offset or size in the file is not aligned";
        if (s.fileSize && (s.fileAt < headers || s.fileAt + s.fileSize > bytes.size()))
            return "a section beyond the file's end";
        if (s.fileSize > (s.memorySize + page - 1) / page * page)
            return "a section with more bytes than memory";
        if ((s.flags & kWrite) && (s.flags & kExecute)) return "writable and executable";
        if (!(s.flags & kRead)) return "a section that cannot be read";
        entered |= entry >= s.address && entry < s.address + s.fileSize && (s.flags & kExecute) != 0;
    }
    if (image != next) return "wrong size of the image";
    if (!entered) return "the entry is not in code";

    // ntdll makes the import slots writable while it fills them: the directory of slots if the file has one,
    // else the whole section of the imports. It finds that section by the table of names, if this lies after
    // the headers, else by the slots
    uint64_t imports = f.inFile(f.directory(1, 0));
    if (!imports) return "no imports in a section's bytes";
    for (uint64_t i = imports; f.at(i + 12, 4) && f.at(i + 16, 4); i += 20) {
        uint64_t names = f.at(i, 4), slots = f.at(i + 16, 4);
        if (names && names < headers) return "names in the headers";
        if (!f.inFile(f.at(i + 12, 4))) return "a library without a name";
        if (!f.inFile(slots) || !f.at(f.inFile(slots), 8)) return "ntdll skips slots that are empty at first";
        uint64_t from = f.directory(12, 0), to = from + f.directory(12, 1);
        for (uint64_t n = f.inFile(names ? names : slots), slot = slots; f.at(n, 8); n += 8, slot += 8) {
            if (!f.inFile(f.at(n, 4) + 2)) return "a function without a name";
            if (from && (slot < from || slot + 8 > to)) return "a slot outside the directory of slots";
        }
    }
    return "";
}

std::string peImports(const std::vector<uint8_t> &bytes) {
    File f = {bytes};
    std::string all;
    for (uint64_t i = f.inFile(f.directory(1, 0)); i && f.at(i + 12, 4); i += 20) {
        all += (all.empty() ? "" : " ") + f.text(f.inFile(f.at(i + 12, 4))) + ":";
        for (uint64_t n = f.inFile(f.at(i, 4) ? f.at(i, 4) : f.at(i + 16, 4)); n && f.at(n, 8); n += 8)
            all += " " + f.text(f.inFile(f.at(n, 4)) + 2);
    }
    return all;
}
