// Packed files of all kinds: writes, checks, opens and unpacks them.
#pragma once

#include "packer/write/messages.h"
#include "packer/write/payload_section.h"

namespace pack {

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

} // namespace pack
