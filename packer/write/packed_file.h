// Writes, checks, opens and unpacks packed files of all kinds.
#pragma once

#include "packer/read/program.h"

namespace pack {

// --- The message that a packed program prints if the system does not let it run. It has a fixed size, in the
// stub or, for Windows, in the headers. So it costs no bytes to name another program to use ---

// The usual messages. The first one is for stub.S and for Windows. The second one is for stub_loader.S: it
// follows the name by which the program was called, and ends with a 0.
inline constexpr char kMayNotRun[] = "it may not run packed.\n",
                      kLoaderMayNotRun[] = ": may not run packed\n";

// Whether this is a valid name of another program to use, which is not packed. An empty name means none.
bool isSafeName(const std::string &name);
void checkSafeName(const std::string &name); // throws common::Refused if it is not valid

// Returns the usual message or, if there is a safe name, a message of the same size that names it.
std::string mayNotRun(const std::string &usual, const std::string &safeName);

// A stub whose message can be replaced.
struct Stub {
    const uint8_t *bytes;
    size_t size;
    std::string_view message = {}; // the usual one that it has; empty: none

    Bytes with(const std::string &safeName) const;
    // Whether the bytes at `at` are this stub, with any message.
    bool same(const uint8_t *at) const;
};

// --- The payload section: everything after the stub, on any system (format.h) ---

// The parts of a packed file: the program without its bytes, and everything to decode them.
struct Packed {
    Program program;
    Layout layout;
    ModelParameters parameters;
    Bytes payload;
    uint32_t words; // number of words that the check covers
};

// Appends the section and fills `out` up to `size` bytes. The checksum() from `checkedFrom` on is then 0.
void appendPayloadSection(Bytes &out, const Program &program, const ModelParameters &parameters,
                          const Bytes &payload, size_t checkedFrom, size_t size);

// Reads the section that begins at `at` in the file. Its program takes `span` bytes of memory. Throws
// common::Refused if it is damaged. The program's slots are in order of address, not yet of functions.
Packed openPayloadSection(const Bytes &file, size_t at, size_t checkedFrom, uint64_t span);

// --- The whole file ---

// The decoders of stub.S, stub_windows.S and stub_loader.S. They do the same as codeImage() in decoder.h.
// `header`: the PayloadHeader in a file, with everything that follows it. `image`: Layout::size bytes.
// `memory`: stubMemory() bytes of zeros, page-aligned.
using StubDecode = void(const uint8_t *header, uint8_t *image, void *memory);
extern "C" StubDecode stubDecode, stubDecodeWindows, stubDecodeLoader;

extern "C" const uint32_t kStubMemory; // bytes of the model before the slots
inline uint32_t stubMemory(const ModelParameters &parameters, uint32_t size) {
    return kStubMemory + (uint32_t)memoryAfterModel(parameters, size);
}

// A kind of packed file.
struct PackedKind {
    size_t stubAt;          // offset in the file; the payload section follows the stub
    Stub stub;              // its message names no other program
    StubDecode &stubDecode; // the decoder in the stub
    // Writes a packed file. `payload`: the encoded `program.bytes`. Throws common::Refused.
    Bytes (*write)(const Program &program, const ModelParameters &parameters, const Bytes &payload,
                   const std::string &safeName);
    // Reads a packed file without decoding it. The file may come from any source. Throws common::Refused.
    Packed (*open)(const Bytes &file);
    // Writes the program, not packed, with the same bytes in memory. Throws common::Refused.
    Bytes (*writePlain)(const Program &program);
};

extern const PackedKind kElf;    // programs made for packing (stub/format.h)
extern const PackedKind kLoader; // any program for Linux (stub/loader_format.h)
extern const PackedKind kPe;     // programs made for packing, for Windows (stub/pe_format.h)

// Whether a file is a packed file of this kind, with a whole stub. The rest may be damaged.
bool isPacked(const PackedKind &kind, const Bytes &file);

// Returns the kind of a packed file; kElf for other files.
const PackedKind &kindOf(const Bytes &file);

// Returns the bytes of a packed file that are not payload.
size_t overhead(const PackedKind &kind, const ModelParameters &parameters);

// Returns the bytes used of a packed file, in whole words: all but the zeros at the end of one for Windows.
size_t usedSize(const PackedKind &kind, const ModelParameters &parameters, const Bytes &payload);

// Decodes a packed file with the stub's own code, in memory. Only for files that kind.write() has made.
Bytes decodeWithStub(const PackedKind &kind, const Bytes &packed);

// Opens and decodes a packed file. Never reads beyond the payload. Throws common::Refused.
Program readPacked(const PackedKind &kind, const Bytes &file);

// A packed file that was verified: the stub and the C++ decoder both return the program.
struct PackedFile {
    Bytes bytes;
    size_t used;             // usedSize()
    size_t overhead;         // bytes that are not payload
    std::vector<float> bits; // cost of each byte of the program
    double seconds;          // processor time for decoding with the stub
};
// Packs and verifies. Throws common::Refused, or std::runtime_error if a decoder does not return the program.
PackedFile makePacked(const PackedKind &kind, const Program &program, const ModelParameters &parameters,
                      const std::string &safeName);

// Returns the file's size as text: "9 bytes" or, if not all are used, "9 bytes used of 512".
std::string sizeText(const PackedFile &file);

// Throws std::runtime_error if `size` is over the budget. A negative budget means no limit. Before it throws,
// it removes an earlier file at `path`, so that nobody takes that file for this program.
void checkBudget(const std::string &path, size_t size, long budget);
// The same for the bytes used of a file, then for the whole file, whose zeros may exceed a budget, too.
void checkBudget(const std::string &path, const PackedFile &file, long budget);

} // namespace pack
