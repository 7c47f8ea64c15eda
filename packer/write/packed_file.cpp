#include "packer/write/packed_file.h"

#include "tools/common/text.h"
#include "tools/common/whole_file.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <ctime>
#include <stdexcept>

namespace pack {

// --- The message of the stub ---

bool isSafeName(const std::string &name) {
    return name.size() <= 14 && std::all_of(name.begin(), name.end(), [](unsigned char c) {
               return (c < 128 && std::isalnum(c)) || (c && std::strchr("._+-", c));
           });
}

void checkSafeName(const std::string &name) {
    need(isSafeName(name), "wrong safe name: use up to 14 letters, digits and . _ + -");
}

std::string mayNotRun(const std::string &usual, const std::string &safeName) {
    if (safeName.empty()) return usual;
    bool afterName = usual[0] == ':';
    std::string line = (afterName ? ": use " : "use ") + safeName;
    if (line.size() + std::strlen(" instead\n") <= usual.size()) line += " instead";
    if (afterName)
        (line += "\n").resize(usual.size());
    else
        line.resize(usual.size() - 1, ' '), line += "\n";
    return line;
}

Bytes Stub::with(const std::string &safeName) const {
    Bytes stub(bytes, bytes + size);
    std::string line = mayNotRun(std::string(message), safeName);
    std::copy(line.begin(), line.end(),
              std::search(stub.begin(), stub.end(), message.begin(), message.end()));
    return stub;
}

bool Stub::same(const uint8_t *at) const {
    auto offset = std::search(bytes, bytes + size, message.begin(), message.end()) - bytes;
    auto after = offset + (long)message.size();
    return std::equal(bytes, bytes + offset, at) && std::equal(bytes + after, bytes + size, at + after);
}

// --- The payload section ---

static constexpr size_t kCheckSize = 4;
static size_t masksSize(const ModelParameters &parameters) {
    return (kCodeMask + kDataMask) * parameters.hashes();
}

void appendPayloadSection(Bytes &out, const Program &program, const ModelParameters &parameters,
                          const Bytes &payload, size_t checkedFrom, size_t size) {
    PayloadHeader p = {};
    p.words = (uint32_t)((size - checkedFrom) / 4);
    p.image = program.base;
    p.readOnly = program.readOnly;
    p.imports = std::min(program.slots[0], program.slots[1]);
    p.entry = program.entry;
    p.early = program.early;
    p.earlyEntry = program.earlyEntry;
    p.layout = program.layout();
    p.memory = stubMemory(parameters, p.layout.size);
    p.contexts = (uint8_t)parameters.contexts;
    p.slotShift = (uint8_t)(32 - parameters.slotBits);

    auto append = [&](const void *bytes, size_t count) {
        out.insert(out.end(), (const uint8_t *)bytes, (const uint8_t *)bytes + count);
    };
    append(&p, sizeof p);
    for (uint32_t i = 0; i < parameters.hashes(); ++i) {
        uint32_t mask = parameters.masks[0][i] >> kCodeShift;
        append(&mask, kCodeMask);
    }
    for (uint32_t i = 0; i < parameters.hashes(); ++i) append(&parameters.masks[1][i], kDataMask);
    append(payload.data(), payload.size());
    out.resize(size);
    uint32_t check = -checksum(out.data() + checkedFrom, p.words - 1);
    std::memcpy(out.data() + size - kCheckSize, &check, kCheckSize);
}

Packed openPayloadSection(const Bytes &file, size_t at, size_t checkedFrom, uint64_t span) {
    PayloadHeader p;
    const uint8_t *next = file.data() + at + sizeof p, *end = file.data() + file.size();
    std::memcpy(&p, file.data() + at, sizeof p);
    need((uint64_t)p.words * 4 <= file.size() - checkedFrom &&
             checksum(file.data() + checkedFrom, p.words) == 0,
         kDamaged);

    ModelParameters parameters = {};
    parameters.contexts = p.contexts;
    parameters.slotBits = 32u - p.slotShift;
    need(parameters.sane() && (size_t)(end - next) >= masksSize(parameters), kDamaged);
    for (uint32_t i = 0; i < parameters.hashes(); ++i, next += kCodeMask) {
        std::memcpy(&parameters.masks[0][i], next, kCodeMask);
        parameters.masks[0][i] <<= kCodeShift;
    }
    for (uint32_t i = 0; i < parameters.hashes(); ++i) parameters.masks[1][i] = *next++;
    need(span <= kMostMemory && span % kPage == 0 && p.layout.size <= span && p.readOnly <= span &&
             p.layout.codeBegin <= p.layout.size && p.layout.codeSize <= p.layout.size - p.layout.codeBegin &&
             p.image % kPage == 0 && p.image < kAddressEnd - span && p.readOnly % kPage == 0,
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
    for (uint32_t i = 0; i < 2; ++i) program.slots[i] = p.imports + 8 * i;
    return {program, p.layout, parameters, {next, end}, p.words};
}

// --- The whole file ---

static size_t sectionAt(const PackedKind &kind) { return kind.stubAt + kind.stub.size; }

bool isPacked(const PackedKind &kind, const Bytes &file) {
    return file.size() > sectionAt(kind) + sizeof(PayloadHeader) && kind.stub.same(file.data() + kind.stubAt);
}

const PackedKind &kindOf(const Bytes &file) {
    bool pe = file.size() > 1 && file[0] == 'M' && file[1] == 'Z';
    return pe ? kPe : isPacked(kLoader, file) ? kLoader : kElf;
}

size_t overhead(const PackedKind &kind, const ModelParameters &parameters) {
    return sectionAt(kind) + sizeof(PayloadHeader) + masksSize(parameters) + kCheckSize;
}

size_t usedSize(const PackedKind &kind, const ModelParameters &parameters, const Bytes &payload) {
    return (overhead(kind, parameters) + payload.size() + 3) / 4 * 4;
}

Bytes decodeWithStub(const PackedKind &kind, const Bytes &packed) {
    Bytes copy = packed;
    copy.resize(copy.size() + 8); // the stub may read a few bytes beyond the end
    uint8_t *section = copy.data() + sectionAt(kind);
    PayloadHeader p;
    std::memcpy(&p, section, sizeof p);
    p.early = kNothingEarly; // decode without running the early part
    std::memcpy(section, &p, sizeof p);
    Bytes image(p.layout.size);
    kind.stubDecode(section, image.data(), zeroedPages(p.memory).get());
    return image;
}

Program readPacked(const PackedKind &kind, const Bytes &file) {
    Packed packed = kind.open(file);
    packed.program.bytes = decode(packed.payload, packed.layout, packed.parameters);
    return packed.program;
}

PackedFile makePacked(const PackedKind &kind, const Program &program, const ModelParameters &parameters,
                      const std::string &safeName) {
    Encoded encoded = encode(program.bytes, program.layout(), parameters);
    PackedFile file = {kind.write(program, parameters, encoded.payload, safeName),
                       usedSize(kind, parameters, encoded.payload), overhead(kind, parameters),
                       std::move(encoded.bits), 0};
    std::clock_t began = std::clock();
    bool same = decodeWithStub(kind, file.bytes) == program.bytes;
    file.seconds = (double)(std::clock() - began) / CLOCKS_PER_SEC;
    if (!same || readPacked(kind, file.bytes).bytes != program.bytes)
        throw std::runtime_error("the packed bytes do not decode to the program: nothing was written");
    return file;
}

std::string sizeText(const PackedFile &file) {
    std::string text = std::to_string(file.used) + " bytes";
    return file.used == file.bytes.size() ? text : text + " used of " + std::to_string(file.bytes.size());
}

void checkBudget(const std::string &path, size_t size, long budget) {
    if (budget < 0 || size <= (size_t)budget) return;
    bool removed = common::removeWhole(path);
    std::fflush(stdout); // the report comes before this line
    throw std::runtime_error(path + ": over budget by " + common::thousands((double)size - (double)budget) +
                             " bytes (" + common::thousands((double)size) + " of " +
                             common::thousands((double)budget) + "): it is not written" +
                             (removed ? ", and the earlier one is removed" : ""));
}

void checkBudget(const std::string &path, const PackedFile &file, long budget) {
    for (size_t size : {file.used, file.bytes.size()}) checkBudget(path, size, budget);
}

} // namespace pack
