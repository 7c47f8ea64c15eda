// The message that a packed program prints if the system does not let it run. It has a fixed size, in the
// stub or, for Windows, in the headers. So it costs no bytes to name another program to use.
#pragma once

#include "packer/read/program.h"

namespace pack {

// The usual messages. The first one is for stub.S and for Windows. The second one is for stub_loader.S: it
// follows the name by which the program was called, and ends with a 0.
inline constexpr char kMayNotRun[] = "it may not run packed.\n",
                      kLoaderMayNotRun[] = ": may not run packed\n";

// Whether this is a valid name of another program to use, which is not packed. An empty name is valid: it
// means none.
bool isSafeName(const std::string &name);
// Throws common::Refused if the name is not valid.
void checkSafeName(const std::string &name);

// Returns the usual message or, if there is a safe name, a message of the same size that names it.
std::string mayNotRun(const std::string &usual, const std::string &safeName);

// A stub whose message can be replaced.
class NamedStub {
public:
    NamedStub(const uint8_t *stub, size_t size, const char *message = "") // a usual message
        : usual(stub, stub + size), message(message) {}

    size_t size() const { return usual.size(); }
    Bytes with(const std::string &safeName) const;
    // Whether the bytes at `at` are this stub, with any message.
    bool same(const uint8_t *at) const;

private:
    Bytes replaced(Bytes stub, const std::string &by) const;

    Bytes usual;
    std::string message;
};

} // namespace pack
