// The message of a packed program that the system does not let run. It has a fixed size, in the stub or, for
// Windows, in the headers. So a message that names another program to use costs no bytes.
#pragma once

#include "packer/read/program.h"

namespace pack {

// The message in stub.S and for Windows; and in stub_loader.S, where it follows the name by which the program
// was called, and ends with a 0.
inline constexpr char kMayNotRun[] = "it may not run packed.\n",
                      kLoaderMayNotRun[] = ": may not run packed\n";

// Whether this can be the name of the same program, not packed, for systems that do not run written memory.
// An empty name is valid: there is none.
bool isSafeName(const std::string &name);
// Throws common::Refused if not.
void checkSafeName(const std::string &name);

// Returns the usual message or, if there is a safe name, a message of the same size that names it.
std::string mayNotRun(const std::string &usual, const std::string &safeName);

// A stub whose message can be replaced.
class NamedStub {
public:
    NamedStub(const uint8_t *stub, size_t size, const char *message = "") // one of the two above
        : usual(stub, stub + size), message(message) {}

    size_t size() const { return usual.size(); }
    Bytes with(const std::string &safeName) const;
    // Whether the stub is at `at`, with any message.
    bool same(const uint8_t *at) const;

private:
    Bytes replaced(Bytes stub, const std::string &by) const;

    Bytes usual;
    std::string message;
};

} // namespace pack
