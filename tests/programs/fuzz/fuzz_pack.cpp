// For libFuzzer: whatever comes in, the packer's readers answer with a program or a line, and nothing else.
// The first byte of the input chooses the reader.
#include "elf_reader.h"
#include "elf_writer.h"
#include "shape.h"
#include "stub.h"

#include "stub_bytes.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

using namespace pack;

namespace {

// The input as parameters, masks and payload of a file that is otherwise as it should be, its checksum too.
std::vector<uint8_t> packedAround(const uint8_t *data, size_t size) {
    std::vector<uint8_t> file(sizeof(Front));
    file.insert(file.end(), kStub, kStub + sizeof kStub);
    size_t at = file.size();
    file.insert(file.end(), data, data + size);
    file.resize((std::max(file.size(), at + sizeof(Parameters)) + 3) / 4 * 4 + 4);
    Front front = {};
    front.segments[2].p_memsz = 0x10000;
    for (Elf64_Rela &r : front.relocations) r.r_offset = 0x400000;
    std::memcpy(file.data(), &front, sizeof front);
    uint32_t words = (uint32_t)(file.size() / 4), last;
    std::memcpy(&file[at + offsetof(Parameters, words)], &words, 4);
    last = -checksum(file.data(), words - 1);
    std::memcpy(&file[file.size() - 4], &last, 4);
    return file;
}

// Whatever the payload, the stub and C++ as this compiler sees it must decode the same.
void decodeTwice(std::vector<uint8_t> file, const Packed &packed) {
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
    std::vector<uint8_t> input(data + 1, data + size);
    try {
        switch (data[0] % 4) {
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
            std::vector<uint8_t> file = packedAround(input.data(), input.size());
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
        }
        }
    } catch (const Unsuitable &) {
    }
    return 0;
}
