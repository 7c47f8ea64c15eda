// For libFuzzer: whatever comes in, the packer's readers answer with a program or a line, and nothing else.
// The first byte of the input chooses the reader.
#include "elf_reader.h"
#include "elf_writer.h"
#include "pe_format.h"
#include "pe_writer.h"
#include "shape.h"
#include "stub.h"
#include "tests/support/pe_rules.h"

#include "stub_bytes.h"
#include "stub_windows_bytes.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

using namespace pack;

namespace {

using Bytes = std::vector<uint8_t>;

// Parameters, masks and payload behind what stands in front, whose checksum from an offset on is as it should
// be.
Bytes packedAround(const Bytes &front, const Bytes &parts, size_t checkedFrom) {
    Bytes file = front;
    file.insert(file.end(), parts.begin(), parts.end());
    file.resize((std::max(file.size(), front.size() + sizeof(Parameters)) + 3) / 4 * 4 + 4);
    uint32_t words = (uint32_t)((file.size() - checkedFrom) / 4), last;
    std::memcpy(&file[front.size() + offsetof(Parameters, words)], &words, 4);
    last = -checksum(file.data() + checkedFrom, words - 1);
    std::memcpy(&file[file.size() - 4], &last, 4);
    return file;
}

// The input as parameters, masks and payload of a file that is otherwise as it should be.
Bytes packedElf(const Bytes &input) {
    Front front = {};
    front.segments[2].p_memsz = 0x10000;
    for (Elf64_Rela &r : front.relocations) r.r_offset = 0x400000;
    Bytes before((uint8_t *)&front, (uint8_t *)(&front + 1));
    before.insert(before.end(), kStub, kStub + sizeof kStub);
    return packedAround(before, input, 0);
}

// ... for Windows, but for the headers: these are compared when all else has been read.
Bytes packedPe(const Bytes &input) {
    PeFront front = {};
    front.sections[1].memorySize = 0x10000;
    PeStart start = {};
    Bytes before((uint8_t *)&front, (uint8_t *)(&front + 1));
    before.insert(before.end(), (uint8_t *)&start, (uint8_t *)(&start + 1));
    before.insert(before.end(), kStubWindows, kStubWindows + sizeof kStubWindows);
    return packedAround(before, input, sizeof front + sizeof start.slots);
}

// Whatever the payload, the stub and C++ as this compiler sees it must decode the same.
void decodeTwice(Bytes file, const Packed &packed) {
    uint32_t memory = stubMemory(packed.shape, packed.layout.size);
    std::memcpy(&file[sizeof(Front) + sizeof kStub + offsetof(Parameters, memory)], &memory, 4);
    file.resize(file.size() + 2000 * 20 + 100); // no bit takes more than 20
    Workspace workspace;
    if (decodeWithStub(file) !=
        decode(packed.payload.data(), packed.payload.size(), packed.layout, packed.shape, workspace))
        std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (!size) return 0;
    Bytes input(data + 1, data + size);
    try {
        switch (data[0] % 6) {
        case 0: {
            Program program = readProgram(input);
            if (program.codeBegin > program.bytes.size() ||
                program.codeSize > program.bytes.size() - program.codeBegin)
                std::abort();
            filter(program.bytes, program.layout());
            break;
        }
        case 1:
            openPacked(input);
            break;
        case 2: {
            Bytes file = packedElf(input);
            Packed packed = openPacked(file);
            // Decoding takes a while: not too often
            if (data[0] > 250 && packed.layout.size && packed.layout.size < 2000) decodeTwice(file, packed);
            break;
        }
        case 3: {
            Shape shape, again;
            std::string text(input.begin(), input.end());
            if (parseShape(text, shape).empty() &&
                (!parseShape(printShape(shape), again).empty() || printShape(again) != printShape(shape)))
                std::abort();
            break;
        }
        case 4: // as it is, or its parts alone
            readPackedPe(data[0] < 128 ? input : packedPe(input));
            break;
        case 5: { // what is taken keeps the rules of Windows's loaders
            Program program = readProgram(input, kWindows);
            if (program.span < 1 << 20 && !brokenPeRule(writePlainPe(program)).empty()) std::abort();
        }
        }
    } catch (const Unsuitable &) {
    }
    return 0;
}
