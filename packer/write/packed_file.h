// Writes, checks, opens and unpacks packed files of all kinds.
#pragma once

#include "packer/model/encoder.h"
#include "packer/read/program.h"
#include "packer/write/messages.h"

namespace pack {

// --- The payload section: everything after the stub, on any system (format.h) ---

// The parts of a packed file: the program without its bytes, and everything to decode them.
struct Packed {
    Program program;
    Layout layout;
    ModelParameters parameters;
    Bytes payload;
    uint32_t words; // number of words that the check covers
};

// Appends the section to `out` and fills it up to `size` bytes, so that the checksum() of the bytes from
// `checkedFrom` on is 0.
void appendPayloadSection(Bytes &out, const Program &program, const ModelParameters &parameters,
                          const Bytes &payload, size_t checkedFrom, size_t size);

// Reads the section that begins at `at` in the file. Its program takes `span` bytes of memory. Throws
// common::Refused if the section is damaged. The program's slots are in order of address; the caller assigns
// them to functions.
Packed openPayloadSection(const Bytes &file, size_t at, size_t checkedFrom, uint64_t span);

// --- The whole file ---

using StubDecode = void(const uint8_t *header, uint8_t *image, void *memory); // a decoder of stub.h

// A kind of packed file.
struct PackedKind {
    size_t stubAt;          // offset in the file; the payload section follows the stub
    NamedStub (*stub)();    // the stub, whose message names no other program
    StubDecode &stubDecode; // the decoder in the stub
    // Writes a packed file. `payload`: the encoded `program.bytes`. Throws common::Refused.
    Bytes (*write)(const Program &program, const ModelParameters &parameters, const Bytes &payload,
                   const std::string &safeName);
    // Reads a packed file without decoding it. The file may come from any source. Throws common::Refused.
    Packed (*open)(const Bytes &file);
    // Writes the program as an executable that is not packed, with the same bytes in memory. Throws
    // common::Refused.
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

// Returns the bytes used of a packed file: all but the zeros that fill a file for Windows up to a multiple of
// kPeFileAlign. They are whole words.
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
// Packs a program and verifies the file. Throws common::Refused, or std::runtime_error if a decoder does not
// return the program.
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
