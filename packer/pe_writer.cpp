#include "pe_writer.h"

#include "pe_file.h"

#include <cstring>

namespace pack {

namespace {

constexpr uint32_t fileWhole(uint64_t bytes) {
    return (uint32_t)(bytes + kPeFileAlign - 1) & ~(kPeFileAlign - 1);
}

// Where the first section lies; the header has the page before
constexpr uint32_t kFirst = kPage;

// All of a header but for what depends on the program.
PeHeader makeHeader(uint32_t base, uint32_t sections) {
    PeHeader h = {};
    h.dosMagic = 0x5a4d;
    h.headerAt = offsetof(PeHeader, signature);
    h.signature = 0x4550;
    h.machine = 0x8664;
    h.sections = (uint16_t)sections;
    h.optionalSize = sizeof h - offsetof(PeHeader, magic);
    h.flags = 0x23; // relocations stripped, executable, may use addresses above 2 GiB
    h.magic = 0x20b;
    h.base = base;
    h.sectionAlign = kPage;
    h.fileAlign = kPeFileAlign;
    h.system[0] = h.subsystemVersion[0] = 6; // Windows Vista and later
    h.headerSize = kPeFileAlign;
    h.subsystem = 2;     // graphical: a double-click opens no console
    h.dllFlags = 0x8100; // no data is executed; knows of terminal servers
    h.stackReserve = h.stackCommit = kPeStack;
    h.heapReserve = 1 << 20;
    h.heapCommit = kPage;
    h.directoryCount = kPeDirectories;
    return h;
}

// What a plain file imports. Names are preceded by a hint of two bytes, which may be wrong.
struct Imports {
    PeImports library, end;
    uint64_t names[3];
    struct {
        uint16_t hint;
        char name[18];
    } functions[2];
    char libraryName[16];
};

// `first`: the function whose slot comes first.
Imports makeImports(uint32_t at, uint32_t slots, uint32_t first) {
    Imports i = {};
    i.library = {at + (uint32_t)offsetof(Imports, names), 0, 0, at + (uint32_t)offsetof(Imports, libraryName),
                 slots};
    for (uint32_t k = 0; k < 2; ++k) {
        i.names[k] = at + offsetof(Imports, functions) + k * sizeof i.functions[0];
        std::strcpy(i.functions[k].name, kWindows.functions[k ^ first]);
    }
    std::strcpy(i.libraryName, kWindows.library);
    return i;
}

} // namespace

std::vector<uint8_t> writePlainPe(const Program &program) {
    // The section of the imports fills what is left between the header and the program
    uint32_t base = (program.base - kFirst - (uint32_t)kPage) & ~(kPeBaseAlign - 1),
             codeAt = program.base - base, dataAt = codeAt + program.readOnly,
             end = codeAt + (uint32_t)wholePages(program.span);
    need(dataAt < end, "it has no data");
    std::vector<uint8_t> image = program.bytes;
    if (image.size() < program.readOnly) image.resize(program.readOnly);
    uint32_t first = program.slots[1] < program.slots[0], slots = program.slots[first] - program.base;
    if (image.size() < slots + 16) image.resize(slots + 16);

    PeHeader h = makeHeader(base, 3);
    h.entry = program.entry - base;
    h.imageSize = end;
    h.directories[kPeImports] = {kFirst, sizeof(PeImports) * 2};
    h.directories[kPeImportSlots] = {codeAt + slots, 16};
    Imports imports = makeImports(kFirst, codeAt + slots, first);
    std::memcpy(image.data() + slots, imports.names, 16); // as loaders expect it
    uint32_t codeFile = kPeFileAlign + fileWhole(sizeof imports), dataFile = codeFile + program.readOnly;
    PeSection sections[3] = {
        {".idata", codeAt - kFirst, kFirst, fileWhole(sizeof imports), kPeFileAlign, {}, kPeConst},
        {".text", program.readOnly, codeAt, program.readOnly, codeFile, {}, kPeCode},
        {".data", end - dataAt, dataAt, fileWhole(image.size() - program.readOnly), dataFile, {}, kPeData}};
    static_assert(sizeof h + sizeof sections <= kPeFileAlign && sizeof imports <= kPeFileAlign);

    std::vector<uint8_t> out(dataFile + sections[2].fileSize);
    std::memcpy(out.data(), &h, sizeof h);
    std::memcpy(out.data() + sizeof h, sections, sizeof sections);
    std::memcpy(out.data() + kPeFileAlign, &imports, sizeof imports);
    std::copy(image.begin(), image.end(), out.begin() + codeFile);
    return out;
}

} // namespace pack
