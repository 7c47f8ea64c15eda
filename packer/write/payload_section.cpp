#include "packer/write/payload_section.h"

#include "packer/stub/stub.h"

#include <algorithm>
#include <cstring>

namespace pack {

namespace {

constexpr size_t kCheckSize = 4;
size_t masksSize(const ModelParameters &parameters) { return (kCodeMask + kDataMask) * parameters.hashes(); }

} // namespace

size_t payloadSectionOverhead(const ModelParameters &parameters) {
    return sizeof(PayloadHeader) + masksSize(parameters) + kCheckSize;
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
    Bytes masks = packMasks(parameters);
    append(masks.data(), masks.size());
    append(payload.data(), payload.size());
    out.resize(size);
    uint32_t check = -checksum(out.data() + checkedFrom, p.words - 1);
    std::memcpy(out.data() + size - kCheckSize, &check, kCheckSize);
}

Packed openPayloadSection(const Bytes &file, size_t from, size_t checkedFrom, uint64_t span) {
    PayloadHeader p;
    const uint8_t *at = file.data() + from + sizeof p, *end = file.data() + file.size();
    std::memcpy(&p, file.data() + from, sizeof p);
    need((uint64_t)p.words * 4 <= file.size() - checkedFrom &&
             checksum(file.data() + checkedFrom, p.words) == 0,
         kDamaged);

    ModelParameters parameters = {};
    parameters.contexts = p.contexts;
    parameters.slotBits = 32u - p.slotShift;
    need(parameters.sane() && (size_t)(end - at) >= masksSize(parameters), kDamaged);
    for (uint32_t i = 0; i < parameters.hashes(); ++i, at += kCodeMask) {
        std::memcpy(&parameters.masks[0][i], at, kCodeMask);
        parameters.masks[0][i] <<= kCodeShift;
    }
    for (uint32_t i = 0; i < parameters.hashes(); ++i) parameters.masks[1][i] = *at++;
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
    return {program, p.layout, parameters, {at, end}, p.words};
}

Bytes decodePayloadSection(const Bytes &file, size_t at, StubDecode &decode) {
    Bytes copy = file;
    copy.resize(copy.size() + 8); // the stub may read a little beyond the end
    PayloadHeader p;
    std::memcpy(&p, copy.data() + at, sizeof p);
    p.early = kNothingEarly; // only decode, do not run the early part
    std::memcpy(copy.data() + at, &p, sizeof p);
    Workspace workspace;
    Bytes image(p.layout.size);
    decode(copy.data() + at, image.data(), workspace.zeroed(p.memory));
    return image;
}

} // namespace pack
