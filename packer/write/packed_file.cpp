#include "packer/write/packed_file.h"

#include <ctime>
#include <stdexcept>

namespace pack {

bool isPe(const Bytes &file) { return file.size() > 1 && file[0] == 'M' && file[1] == 'Z'; }

static size_t sectionAt(const PackedKind &kind) { return kind.stubAt + kind.stub().size(); }

bool isPacked(const PackedKind &kind, const Bytes &file) {
    return file.size() > sectionAt(kind) + sizeof(PayloadHeader) &&
           kind.stub().same(file.data() + kind.stubAt);
}

const PackedKind &kindOf(const Bytes &file) {
    return isPe(file) ? kPe : isPacked(kLoader, file) ? kLoader : kElf;
}

size_t overhead(const PackedKind &kind, const ModelParameters &parameters) {
    return sectionAt(kind) + payloadSectionOverhead(parameters);
}

Bytes decodeWithStub(const PackedKind &kind, const Bytes &packed) {
    return decodePayloadSection(packed, sectionAt(kind), kind.stubDecode);
}

Program readPacked(const PackedKind &kind, const Bytes &file) {
    Packed packed = kind.open(file);
    Workspace workspace;
    packed.program.bytes =
        decode(packed.payload.data(), packed.payload.size(), packed.layout, packed.parameters, workspace);
    return packed.program;
}

PackedFile makePacked(const PackedKind &kind, const Program &program, const ModelParameters &parameters,
                      const std::string &safeName) {
    Workspace workspace;
    Encoded encoded = encode(program.bytes, program.layout(), parameters, workspace);
    PackedFile file = {kind.write(program, parameters, encoded.payload, safeName), overhead(kind, parameters),
                       std::move(encoded.bits), 0};
    std::clock_t began = std::clock();
    bool same = decodeWithStub(kind, file.bytes) == program.bytes;
    file.seconds = (double)(std::clock() - began) / CLOCKS_PER_SEC;
    if (!same || readPacked(kind, file.bytes).bytes != program.bytes)
        throw std::runtime_error("the packed bytes do not decode to the program: nothing was written");
    return file;
}

} // namespace pack
