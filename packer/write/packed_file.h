// Packed files of all kinds: writes, checks, opens and unpacks them.
#pragma once

#include "packer/model/encoder.h"
#include "packer/read/program.h"
#include "packer/write/messages.h"

namespace pack {

// --- The payload section: all that follows the stub, on any system (format.h) ---

// A packed file taken apart: the program without its bytes, and how to decode them.
struct Packed {
    Program program;
    Layout layout;
    ModelParameters parameters;
    Bytes payload;
    uint32_t words; // of the file that the check covers
};

// Bytes of the section that are not payload.
size_t payloadSectionOverhead(const ModelParameters &parameters);

// Appends the section to what comes before, so that `out` has `size` bytes, and checksum() of those from
// `checkedFrom` on is 0.
void appendPayloadSection(Bytes &out, const Program &program, const ModelParameters &parameters,
                          const Bytes &payload, size_t checkedFrom, size_t size);

// Takes apart the section that begins at `from` in the file; its program takes `span` bytes of memory. Throws
// common::Refused if the section is damaged. The program's slots are in order of address; the caller
// assigns them to functions.
Packed openPayloadSection(const Bytes &file, size_t at, size_t checkedFrom, uint64_t span);

// Decodes the section at `at` with a stub's own code: stubDecode or stubDecodeWindows of stub.h.
using StubDecode = void(const uint8_t *header, uint8_t *image, void *memory);
Bytes decodePayloadSection(const Bytes &file, size_t at, StubDecode &decode);

// --- The whole file ---

// A kind of packed file.
struct PackedKind {
    size_t stubAt;          // in the file; the payload section follows the stub
    NamedStub (*stub)();    // with its usual message
    StubDecode &stubDecode; // the decoder in it
    // `payload` encodes `program.bytes`. Throws common::Refused.
    Bytes (*write)(const Program &program, const ModelParameters &parameters, const Bytes &payload,
                   const std::string &safeName);
    // Takes a packed file apart, but does not decode it. The file may come from any source. Throws
    // common::Refused.
    Packed (*open)(const Bytes &file);
    // An executable that lies in memory exactly like `program`, not packed. Throws common::Refused.
    Bytes (*writePlain)(const Program &program);
};

extern const PackedKind kElf;    // made for packing (stub/format.h)
extern const PackedKind kLoader; // of any program for Linux (stub/loader_format.h)
extern const PackedKind kPe;     // made for packing, for Windows (stub/pe_format.h)

bool isPe(const Bytes &file); // packed or not

// Whether a file is packed, of this kind. It may be damaged, but its stub is whole.
bool isPacked(const PackedKind &kind, const Bytes &file);

// The kind of a packed file; kElf if it is none.
const PackedKind &kindOf(const Bytes &file);

// Bytes of a packed file that are not payload.
size_t overhead(const PackedKind &kind, const ModelParameters &parameters);

// Runs the stub's own code on a packed file in memory, which kind.write() must have made. Returns the decoded
// bytes.
Bytes decodeWithStub(const PackedKind &kind, const Bytes &packed);

// Opens a packed file and decodes it, without reading beyond the payload. Throws common::Refused.
Program readPacked(const PackedKind &kind, const Bytes &file);

// A packed program that was checked: the stub and the C++ decoder both decode it.
struct PackedFile {
    Bytes bytes;
    size_t overhead;         // bytes that are not payload
    std::vector<float> bits; // cost of each byte of the program
    double seconds;          // of processor time that the stub takes
};
// Throws common::Refused, and std::runtime_error if a decoder fails.
PackedFile makePacked(const PackedKind &kind, const Program &program, const ModelParameters &parameters,
                      const std::string &safeName);

// Throws std::runtime_error if `size` is over the budget (if there is one: >= 0). Then it removes the earlier
// file at `path`: it must not pass for this program, packed.
void checkBudget(const std::string &path, size_t size, long budget);

} // namespace pack
