#include "program.h"

#include "stub_bytes.h"

#include <algorithm>
#include <cstring>
#include <elf.h>

namespace pack {

namespace {

constexpr uint32_t kBelow = 0x200000; // the packed file lies so far below the program

Elf64_Phdr segment(uint32_t type, uint32_t flags, uint64_t offset, uint64_t address, uint64_t inFile,
                   uint64_t inMemory, uint64_t align) {
    return {type, flags, offset, address, address, inFile, inMemory, align};
}

// A symbol without what the loader does not read of one that is imported.
struct Import {
    uint32_t name;
    uint8_t info, other;
    uint16_t section;
};

// Everything in front of the stub, in the order of the file. Tables overlap where the loader does not look:
// of the segment GNU_STACK it reads type and flags, of an imported symbol not the value; the null symbol is
// never read (the symbol table begins before `first`), of the dynamic section's end only the tag.
struct Front {
    Elf64_Ehdr header;
    Elf64_Phdr segments[4];
    uint32_t stackType, stackFlags;
    char interpreter[sizeof kInterpreter], functions[20]; // in place of the rest of GNU_STACK
    Elf64_Dyn dynamic[6];
    uint64_t dynamicEnd;
    Import first;
    char library[16];
    Import second;
    Elf64_Rela relocations[2];
};
static_assert(sizeof(Front) == 528 && offsetof(Front, dynamic) % 8 == 0);

void fillTables(Front &f, uint64_t base, const uint32_t *slots) {
    auto at = [&](size_t offset) { return base + offset; };
    std::memcpy(f.header.e_ident, ELFMAG, SELFMAG);
    f.header.e_ident[EI_CLASS] = ELFCLASS64;
    f.header.e_ident[EI_DATA] = ELFDATA2LSB;
    f.header.e_ident[EI_VERSION] = EV_CURRENT;
    f.header.e_type = ET_EXEC;
    f.header.e_machine = EM_X86_64;
    f.header.e_version = EV_CURRENT;
    f.header.e_phoff = offsetof(Front, segments);
    f.header.e_ehsize = sizeof(Elf64_Ehdr);
    f.header.e_phentsize = sizeof(Elf64_Phdr);
    f.header.e_phnum = 5;
    f.segments[0] = segment(PT_INTERP, PF_R, offsetof(Front, interpreter), at(offsetof(Front, interpreter)),
                            sizeof kInterpreter, sizeof kInterpreter, 1);
    // 1 and 2 are the caller's
    constexpr size_t kDynamic = sizeof f.dynamic + sizeof f.dynamicEnd;
    f.segments[3] = segment(PT_DYNAMIC, PF_R, offsetof(Front, dynamic), at(offsetof(Front, dynamic)),
                            kDynamic, kDynamic, 8);
    f.stackType = PT_GNU_STACK;
    f.stackFlags = PF_R | PF_W;
    std::memcpy(f.interpreter, kInterpreter, sizeof kInterpreter);
    std::memcpy(f.functions, "dlopen\0dlsym", 13);
    std::memcpy(f.library, "libdl.so.2", 11);
    // Strings count from the first function's name on
    constexpr size_t kStrings = offsetof(Front, functions);
    f.dynamic[0] = {DT_NEEDED, {offsetof(Front, library) - kStrings}};
    f.dynamic[1] = {DT_STRTAB, {at(kStrings)}};
    f.dynamic[2] = {DT_SYMTAB, {at(offsetof(Front, first)) - sizeof(Elf64_Sym)}};
    f.dynamic[3] = {DT_RELA, {at(offsetof(Front, relocations))}};
    f.dynamic[4] = {DT_RELASZ, {sizeof f.relocations}};
    f.dynamic[5] = {DT_RELAENT, {sizeof(Elf64_Rela)}};
    f.first = {0, ELF64_ST_INFO(STB_GLOBAL, STT_FUNC), 0, 0};
    f.second = {7, ELF64_ST_INFO(STB_GLOBAL, STT_FUNC), 0, 0};
    for (uint32_t i = 0; i < 2; ++i) f.relocations[i] = {slots[i], ELF64_R_INFO(i + 1, R_X86_64_GLOB_DAT), 0};
}

} // namespace

size_t overhead(const Shape &shape) {
    return sizeof(Front) + sizeof kStub + sizeof(Parameters) + 4 * shape.hashes() + 4;
}

std::vector<uint8_t> writePacked(const Program &program, const Shape &shape,
                                 const std::vector<uint8_t> &payload) {
    uint32_t base = program.base - kBelow;
    size_t size = (overhead(shape) + payload.size() + 3) / 4 * 4;
    need(size <= kBelow, "too large to pack");
    auto at = [&](size_t offset) { return base + offset; };

    Front f = {};
    fillTables(f, base, program.slots);
    f.header.e_entry = at(sizeof(Front));
    f.segments[1] = segment(PT_LOAD, PF_R | PF_X, 0, base, size, size, kPage);
    f.segments[2] = segment(PT_LOAD, PF_R | PF_W, 0, program.base, 0, wholePages(program.span), kPage);

    Parameters p = {};
    p.file = base;
    p.words = (uint32_t)(size / 4);
    p.image = program.base;
    p.readOnly = program.readOnly;
    p.imports = std::min(program.slots[0], program.slots[1]);
    p.entry = program.entry;
    p.early = program.early;
    p.earlyEntry = program.earlyEntry;
    p.layout = program.layout();
    p.memory = stubMemory(shape, p.layout.size);
    p.contexts = (uint8_t)shape.contexts;
    p.slotShift = (uint8_t)(32 - shape.slotBits);

    std::vector<uint8_t> out;
    auto append = [&](const void *bytes, size_t count) {
        out.insert(out.end(), (const uint8_t *)bytes, (const uint8_t *)bytes + count);
    };
    append(&f, sizeof f);
    append(kStub, sizeof kStub);
    append(&p, sizeof p);
    std::vector<uint16_t> masks = packMasks(shape);
    append(masks.data(), masks.size() * sizeof(uint16_t));
    append(payload.data(), payload.size());
    out.resize(size);
    uint32_t last = -checksum(out.data(), size / 4 - 1);
    std::memcpy(out.data() + size - 4, &last, 4);
    return out;
}

std::vector<uint8_t> decodeWithStub(const std::vector<uint8_t> &packed) {
    const uint8_t *at = packed.data() + sizeof(Front) + sizeof kStub;
    Parameters p;
    std::memcpy(&p, at, sizeof p);
    // Nothing runs early here
    std::vector<uint8_t> copy(packed.begin() + sizeof(Front), packed.end());
    p.early = kNothingEarly;
    std::memcpy(copy.data() + sizeof kStub, &p, sizeof p);
    copy.resize(copy.size() + 8);
    std::vector<Float4> memory(p.memory / sizeof(Float4) + 1);
    std::vector<uint8_t> image(p.layout.size);
    stubDecode(copy.data() + sizeof kStub, image.data(), memory.data());
    return image;
}

Packed openPacked(const std::vector<uint8_t> &file) {
    constexpr char kForeign[] = "not packed by this version of pack";
    need(file.size() > sizeof(Front) + sizeof kStub + sizeof(Parameters), kForeign);
    Front f;
    std::memcpy(&f, file.data(), sizeof f);
    need(!std::memcmp(file.data() + sizeof f, kStub, sizeof kStub), kForeign);
    Parameters p;
    const uint8_t *at = file.data() + sizeof f + sizeof kStub, *end = file.data() + file.size();
    std::memcpy(&p, at, sizeof p);
    at += sizeof p;
    constexpr char kDamaged[] = "damaged: get it again";
    need((uint64_t)p.words * 4 <= file.size() && checksum(file.data(), p.words) == 0, kDamaged);

    Shape shape = {};
    shape.contexts = p.contexts;
    shape.slotBits = 32u - p.slotShift;
    need(shape.sane() && (uint64_t)(end - at) >= 4 * shape.hashes(), kDamaged);
    for (auto &masks : shape.masks) {
        std::memcpy(masks, at, 2 * shape.hashes());
        at += 2 * shape.hashes();
    }
    uint64_t span = f.segments[2].p_memsz;
    need(span <= kMostMemory && span % kPage == 0 && p.layout.size <= span && p.readOnly <= span &&
             p.layout.codeBegin <= p.layout.size && p.layout.codeSize <= p.layout.size - p.layout.codeBegin &&
             p.image % kPage == 0 && p.image > kBelow && p.image < 0x7fffffff - span &&
             p.readOnly % kPage == 0,
         kDamaged);

    Program program = {};
    program.base = p.image;
    program.readOnly = p.readOnly;
    program.span = (uint32_t)span;
    program.entry = p.entry;
    program.early = p.early;
    program.earlyEntry = p.earlyEntry;
    program.codeBegin = p.layout.codeBegin;
    program.codeSize = p.layout.codeSize;
    for (int i = 0; i < 2; ++i) {
        program.slots[i] = (uint32_t)f.relocations[i].r_offset;
        need(program.slots[i] >= p.image && program.slots[i] - p.image + 8 <= span, kDamaged);
    }
    return {program, p.layout, shape, {at, end}};
}

Program readPacked(const std::vector<uint8_t> &file) {
    Packed packed = openPacked(file);
    Workspace workspace;
    packed.program.bytes =
        decode(packed.payload.data(), packed.payload.size(), packed.layout, packed.shape, workspace);
    return packed.program;
}

std::vector<uint8_t> writePlain(const Program &program) {
    uint64_t base = program.base - kPage, size = std::max<uint64_t>(program.bytes.size(), program.readOnly);
    Front f = {};
    fillTables(f, base, program.slots);
    f.header.e_entry = program.entry;
    f.segments[1] =
        segment(PT_LOAD, PF_R | PF_X, 0, base, kPage + program.readOnly, kPage + program.readOnly, kPage);
    f.segments[2] = segment(PT_LOAD, PF_R | PF_W, kPage + program.readOnly, program.base + program.readOnly,
                            size - program.readOnly, program.span - program.readOnly, kPage);
    std::vector<uint8_t> out(kPage + size);
    std::memcpy(out.data(), &f, sizeof f);
    std::copy(program.bytes.begin(), program.bytes.end(), out.begin() + kPage);
    return out;
}

} // namespace pack
