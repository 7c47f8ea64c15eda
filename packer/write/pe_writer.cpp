#include "packer/stub/pe_format.h"
#include "packer/write/packed_file.h"
#include "stub_windows_bytes.h"

#include <cstring>
#include <iterator>

namespace pack {

namespace {

constexpr uint32_t fileWhole(uint64_t bytes) {
    return (uint32_t)(bytes + kPeFileAlign - 1) & ~(kPeFileAlign - 1);
}

// Address of the first section, relative to the image's base. The headers take the page before it
constexpr uint32_t kFirst = kPage;

// Size of the stack of the main thread, and of other threads by default. All of it is committed: a stack
// grows by its guard page, and code that was not compiled for Windows may skip that page.
constexpr uint64_t kPeStack = 1 << 20;

// Makes a header, except for the fields that depend on the program.
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
    h.dllFlags = 0x8100; // no data is executed; aware of terminal servers
    h.stackReserve = h.stackCommit = kPeStack;
    h.heapReserve = 1 << 20;
    h.heapCommit = kPage;
    h.directoryCount = kPeDirectories;
    return h;
}

// The imports of a plain file. A hint of two bytes, which may be wrong, precedes each name.
struct Imports {
    PeImports library, end;
    uint64_t names[3];
    struct {
        uint16_t hint;
        char name[18];
    } functions[2];
    char libraryName[16];
};

// `first`: index of the function whose slot comes first.
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

// Offsets in a packed file
constexpr size_t kStartAt = kPeFileAlign, kStubAt = kStartAt + sizeof(PeStart),
                 kPayloadSectionAt = kStubAt + sizeof kStubWindows,
                 kCheckedFrom = kStartAt + sizeof(PeStart::slots);

// Makes the imports of a packed file: the program's, in the order of its slots, then the stub's.
PeStart makeStart(const Program &program) {
    uint32_t first = program.slots[1] < program.slots[0];
    const char *functions[] = {
        [kPeProgram1] = kWindows.functions[first],
        [kPeProgram2] = kWindows.functions[1 - first],
        [kPeLoadLibrary] = "LoadLibraryA",
        [kPeGetProcAddress] = "GetProcAddress",
        [kPeVirtualAlloc] = "VirtualAlloc",
        [kPeVirtualFree] = "VirtualFree",
        [kPeVirtualProtect] = "VirtualProtect",
        [kPeGetStdHandle] = "GetStdHandle",
        [kPeWriteFile] = "WriteFile",
        [kPeExitProcess] = "ExitProcess",
    };
    static_assert(std::size(functions) == kPeImportCount);
    PeStart s = {};
    auto at = [](size_t offset) { return kFirst + (uint32_t)offset; };
    size_t end = 0;
    for (int i = 0; i < kPeImportCount; ++i) {
        for (int k = 0; k < i; ++k)
            if (!std::strcmp(functions[k], functions[i])) s.slots[i] = s.slots[k];
        if (s.slots[i]) continue;
        s.slots[i] = at(offsetof(PeStart, names) + end);
        std::strcpy(s.names + end + 2, functions[i]); // after a hint of two bytes, which may be wrong
        end += 2 + std::strlen(functions[i]) + 1;
    }
    std::strcpy(s.libraryName, kWindows.library);
    s.library = {0, 0, 0, at(offsetof(PeStart, libraryName)), at(0)};
    return s;
}

PeMessages makeMessages(const std::string &safeName) {
    PeMessages t = {{}, "damaged: copy it again\n", "not enough free memory\n", "user32", "MessageBoxA"};
    std::strcpy(t.mayNotRun, mayNotRun(kMayNotRun, safeName).c_str());
    return t;
}

// Returns the safe name in the messages. If they are damaged, it may be wrong.
std::string safeNameIn(const PeMessages &messages) {
    std::string line(messages.mayNotRun, sizeof messages.mayNotRun);
    std::string name = line.starts_with("use ") ? line.substr(4, line.find(' ', 4) - 4) : "";
    return isSafeName(name) ? name : "";
}

// Makes the headers of a packed file of `size` bytes.
PeFront makeFront(const Program &program, uint32_t size, const std::string &safeName) {
    uint32_t base = (program.base - kFirst - (uint32_t)wholePages(size)) & ~(kPeBaseAlign - 1),
             programAt = program.base - base;
    PeFront f = {makeHeader(base, 2),
                 {{".text", programAt - kFirst, kFirst, size - kPeFileAlign, kPeFileAlign, {}, kPeCode},
                  {".data", (uint32_t)wholePages(program.span), programAt, 0, 0, {}, kPeZeros}},
                 makeMessages(safeName)};
    f.header.entry = kFirst + (uint32_t)(kStubAt - kStartAt);
    f.header.imageSize = programAt + f.sections[1].memorySize;
    f.header.directories[kPeImports] = {kFirst + (uint32_t)offsetof(PeStart, library), 2 * sizeof(PeImports)};
    f.header.directories[kPeImportSlots] = {kFirst, sizeof(PeStart::slots)};
    return f;
}

Bytes write(const Program &program, const ModelParameters &parameters, const Bytes &payload,
            const std::string &safeName) {
    uint32_t size = fileWhole(usedSize(kPe, parameters, payload));
    need(size <= kBelow - 2 * kPeBaseAlign, "too large: packed, it would be nearly 2 MiB");
    PeFront f = makeFront(program, size, safeName);
    PeStart start = makeStart(program);
    Bytes out(kPayloadSectionAt);
    std::memcpy(out.data(), &f, sizeof f);
    std::memcpy(out.data() + kStartAt, &start, sizeof start);
    std::memcpy(out.data() + kStubAt, kStubWindows, sizeof kStubWindows);
    appendPayloadSection(out, program, parameters, payload, kCheckedFrom, size);
    return out;
}

Packed open(const Bytes &file) {
    need(isPacked(kPe, file), kForeign);
    PeFront f;
    PeStart start;
    std::memcpy(&f, file.data(), sizeof f);
    std::memcpy(&start, file.data() + kStartAt, sizeof start);
    Packed packed = openPayloadSection(file, kPayloadSectionAt, kCheckedFrom, f.sections[1].memorySize);
    Program &program = packed.program;
    need(program.base > kBelow, kDamaged);
    need(program.slots[0] >= program.base && program.slots[0] - program.base + 16 <= program.span, kDamaged);
    if (start.slots[kPeProgram1] != start.slots[kPeLoadLibrary])
        std::swap(program.slots[0], program.slots[1]);
    // The check does not cover headers and slots, so compare them with new ones
    PeFront front = makeFront(program, (uint32_t)(kCheckedFrom + 4 * packed.words), safeNameIn(f.messages));
    PeStart slots = makeStart(program);
    need(!std::memcmp(&f, &front, sizeof f) && !std::memcmp(&start, &slots, sizeof start), kDamaged);
    return packed;
}

Bytes writePlain(const Program &program) {
    // The section of the imports fills the memory between the header and the program
    uint32_t base = (program.base - kFirst - (uint32_t)kPage) & ~(kPeBaseAlign - 1),
             codeAt = program.base - base, dataAt = codeAt + program.readOnly,
             end = codeAt + (uint32_t)wholePages(program.span);
    need(dataAt < end, "it has no writable data: a program for Windows needs some");
    Bytes image = program.bytes;
    if (image.size() < program.readOnly) image.resize(program.readOnly);
    uint32_t first = program.slots[1] < program.slots[0], slots = program.slots[first] - program.base;
    if (image.size() < slots + 16) image.resize(slots + 16);

    PeHeader h = makeHeader(base, 3);
    h.entry = program.entry - base;
    h.imageSize = end;
    h.directories[kPeImports] = {kFirst, sizeof(PeImports) * 2};
    h.directories[kPeImportSlots] = {codeAt + slots, 16};
    Imports imports = makeImports(kFirst, codeAt + slots, first);
    std::memcpy(image.data() + slots, imports.names, 16); // loaders expect a copy of the table of names
    uint32_t codeFile = kPeFileAlign + fileWhole(sizeof imports), dataFile = codeFile + program.readOnly;
    PeSection sections[3] = {
        {".idata", codeAt - kFirst, kFirst, fileWhole(sizeof imports), kPeFileAlign, {}, kPeConst},
        {".text", program.readOnly, codeAt, program.readOnly, codeFile, {}, kPeCode},
        {".data", end - dataAt, dataAt, fileWhole(image.size() - program.readOnly), dataFile, {}, kPeData}};
    static_assert(sizeof h + sizeof sections <= kPeFileAlign && sizeof imports <= kPeFileAlign);

    Bytes out(dataFile + sections[2].fileSize);
    std::memcpy(out.data(), &h, sizeof h);
    std::memcpy(out.data() + sizeof h, sections, sizeof sections);
    std::memcpy(out.data() + kPeFileAlign, &imports, sizeof imports);
    std::copy(image.begin(), image.end(), out.begin() + codeFile);
    return out;
}

} // namespace

const PackedKind kPe = {kStubAt,   {kStubWindows, sizeof kStubWindows}, stubDecodeWindows, write, open,
                        writePlain};

} // namespace pack
