// For libFuzzer: whatever the input is, the packer's readers either return a program or throw an error. The
// first byte of the input selects the reader.
#include "packer/model/model_parameters.h"
#include "packer/read/program.h"
#include "packer/stub/pe_format.h"
#include "packer/write/packed_file.h"
#include "tests/support/pe_rules.h"

#include "stub_bytes.h"
#include "stub_windows_bytes.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

using namespace pack;

namespace {

// Appends `parts` (payload header, masks and payload) to `front`, with a correct checksum of all bytes from
// `checkedFrom` on.
Bytes packedAround(const Bytes &front, const Bytes &parts, size_t checkedFrom) {
    Bytes file = front;
    file.insert(file.end(), parts.begin(), parts.end());
    file.resize((std::max(file.size(), front.size() + sizeof(PayloadHeader)) + 3) / 4 * 4 + 4);
    uint32_t words = (uint32_t)((file.size() - checkedFrom) / 4), last;
    std::memcpy(&file[front.size() + offsetof(PayloadHeader, words)], &words, 4);
    last = -checksum(file.data() + checkedFrom, words - 1);
    std::memcpy(&file[file.size() - 4], &last, 4);
    return file;
}

// Returns a valid file, except that its payload header, masks and payload are the input.
Bytes packedElf(const Bytes &input) {
    Front front = {};
    front.segments[2].p_memsz = 0x10000;
    for (Elf64_Rela &r : front.relocations) r.r_offset = 0x400000;
    Bytes before((uint8_t *)&front, (uint8_t *)(&front + 1));
    before.insert(before.end(), kStub, kStub + sizeof kStub);
    return packedAround(before, input, 0);
}

// The same for Windows. Here headers may be wrong, too: the reader compares them last.
Bytes packedPe(const Bytes &input) {
    PeFront front = {};
    front.sections[1].memorySize = 0x10000;
    PeStart start = {};
    Bytes before((uint8_t *)&front, (uint8_t *)(&front + 1));
    before.insert(before.end(), (uint8_t *)&start, (uint8_t *)(&start + 1));
    before.insert(before.end(), kStubWindows, kStubWindows + sizeof kStubWindows);
    return packedAround(before, input, sizeof front + sizeof start.slots);
}

// The stub and the C++ decoder must give the same result for any payload.
void decodeTwice(Bytes file, const Packed &packed) {
    uint32_t memory = stubMemory(packed.parameters, packed.layout.size);
    std::memcpy(&file[sizeof(Front) + sizeof kStub + offsetof(PayloadHeader, memory)], &memory, 4);
    file.resize(file.size() + 2000 * 20 + 100); // a decoded bit takes at most 20 bits
    if (decodeWithStub(kElf, file) != decode(packed.payload, packed.layout, packed.parameters)) std::abort();
}

void filterCode(const Program &program) {
    if (program.codeBegin > program.bytes.size() ||
        program.codeSize > program.bytes.size() - program.codeBegin)
        std::abort();
    filter(program.bytes, program.layout());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (!size) return 0;
    Bytes input(data + 1, data + size);
    try {
        switch (data[0] % 8) {
        case 0:
            filterCode(readProgram(input));
            break;
        case 1:
            kElf.open(input);
            break;
        case 2: {
            Bytes file = packedElf(input);
            Packed packed = kElf.open(file);
            // Decoding is slow: do it rarely
            if (data[0] > 248 && packed.layout.size && packed.layout.size < 2000) decodeTwice(file, packed);
            break;
        }
        case 3: {
            std::string text(input.begin(), input.end());
            ModelParameters parameters = parseParameters(text);
            if (parseParameters(printParameters(parameters)) != parameters) std::abort();
            break;
        }
        case 4: // the input is a whole file, or the parts of a valid one
            readPacked(kPe, data[0] < 128 ? input : packedPe(input));
            break;
        case 5: { // an accepted file must keep the rules of Windows
            Program program = readProgram(input, kWindows);
            if (program.span < 1 << 20 && !brokenPeRule(kPe.writePlain(program)).empty()) std::abort();
            break;
        }
        case 6: { // a program of any kind
            isMadeForPacking(input);
            Program program = readAnyProgram(input);
            if (appendedBytes(input) > input.size()) std::abort();
            filterCode(program);
            kLoader.writePlain(program);
            break;
        }
        case 7:
            readPacked(kLoader, input);
        }
    } catch (const common::Refused &) {
    }
    return 0;
}
