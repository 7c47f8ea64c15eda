// The messages of a packed program that cannot start, and the names in them. Each stands in the stub, or for
// Windows in the headers, in a space of fixed size, so names cost nothing.
#pragma once

#include "packer/read/program.h"

namespace pack {

// Letters, digits and . _ + -; empty: not given.
struct Names {
    std::string program; // the name of the program in its messages
    std::string safe;    // of the same program, not packed, for systems that do not run written memory
};

// Throws common::Refused if a name has other characters, or the messages with it do not fit.
void checkNames(const Names &names);

struct Message {
    enum What { kDamaged, kNoMemory, kMayNotRun, kNoInterpreter } what;
    const char *usual; // as it stands in the stub; its length is the space
    bool called;       // follows the name by which the program was called, and ends with a 0
};

// The message with names in it, as long as the usual one. Throws common::Refused if it does not fit.
std::string withNames(const Message &message, const Names &names);

// The messages of stub.S and of PeMessages: all are printed with the same length.
inline constexpr Message kMessages[] = {
    {Message::kDamaged, "damaged: get it afresh\n", false},
    {Message::kNoMemory, "not enough free memory\n", false},
    {Message::kMayNotRun, "it may not run packed.\n", false},
};
// ... and of stub_loader.S.
inline constexpr Message kLoaderMessages[] = {
    {Message::kDamaged, ": damaged: get it afresh\n", true},
    {Message::kNoMemory, ": not enough free memory\n", true},
    {Message::kMayNotRun, ": may not run packed\n", true},
    {Message::kNoInterpreter, ": interpreter missing\n", true},
};

// A stub whose messages can be replaced.
class NamedStub {
public:
    // `named`: where the stub has the four bytes that take the name by which the program was called; 0 if it
    // does not print that.
    template <size_t kMessageCount>
    NamedStub(const uint8_t *stub, size_t size, const Message (&messages)[kMessageCount], size_t named)
        : usual(stub, stub + size), messages(messages), count(kMessageCount), named(named) {}

    NamedStub(const uint8_t *stub, size_t size) : usual(stub, stub + size) {} // without messages

    size_t size() const { return usual.size(); }
    Bytes with(const Names &names) const;
    // Whether the stub lies at `at`, with any names.
    bool same(const uint8_t *at) const;

private:
    size_t placeOf(const Message &message) const;

    Bytes usual;
    const Message *messages = nullptr;
    size_t count = 0, named = 0;
};

} // namespace pack
