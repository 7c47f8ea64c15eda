// The message of a packed program that may not run what it decoded. It stands in the stub, or for Windows in
// the headers, in a space of fixed size, so the name of another program to use costs nothing.
#pragma once

#include "packer/read/program.h"

namespace pack {

// As they stand in stub.S and for Windows, and in stub_loader.S, where the name by which the program was
// called precedes it and a 0 ends it.
inline constexpr char kMayNotRun[] = "it may not run packed.\n",
                      kLoaderMayNotRun[] = ": may not run packed\n";

// Whether this can be the name of the same program, not packed, for systems that do not run written memory;
// empty: there is none.
bool isSafeName(const std::string &name);
// Throws common::Refused if it cannot.
void checkSafeName(const std::string &name);

// The usual message, or one of the same length that names another program.
std::string mayNotRun(const std::string &usual, const std::string &safeName);

// A stub whose message can be replaced.
class NamedStub {
public:
    NamedStub(const uint8_t *stub, size_t size, const char *message = "") // ... of those above
        : usual(stub, stub + size), message(message) {}

    size_t size() const { return usual.size(); }
    Bytes with(const std::string &safeName) const;
    // Whether the stub lies at `at`, with any message.
    bool same(const uint8_t *at) const;

private:
    Bytes replaced(Bytes stub, const std::string &by) const;

    Bytes usual;
    std::string message;
};

} // namespace pack
