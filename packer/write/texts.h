// What a packed program says when it cannot start, and the names in it. Each text stands in the stub, or for
// Windows in the headers, in a room of fixed size, so names cost nothing.
#pragma once

#include "packer/read/program.h"

namespace pack {

// Letters, digits and . _ + -; empty: not given.
struct Names {
    std::string program; // what the texts call the program
    std::string safe;    // the same program, not packed: to be used where nothing that was written may run
};

// Throws common::Refused if a name has other characters, or the texts with it do not fit.
void checkNames(const Names &names);

struct Text {
    enum What { kDamaged, kNoMemory, kMayNotRun, kNoInterpreter } what;
    const char *usual; // as it stands in the stub; its length is the room
    bool called;       // follows the name by which the program was called, and ends with a 0
};

// The text with names in it, as long as the usual one. Throws common::Refused if it does not fit.
std::string withNames(const Text &text, const Names &names);

// The texts of stub.S and of PeTexts: all are printed with the same length.
inline constexpr Text kTexts[] = {
    {Text::kDamaged, "damaged: get it afresh\n", false},
    {Text::kNoMemory, "not enough free memory\n", false},
    {Text::kMayNotRun, "it may not run packed.\n", false},
};
// ... and of stub_loader.S.
inline constexpr Text kLoaderTexts[] = {
    {Text::kDamaged, ": damaged: get it afresh\n", true},
    {Text::kNoMemory, ": not enough free memory\n", true},
    {Text::kMayNotRun, ": may not run packed\n", true},
    {Text::kNoInterpreter, ": interpreter missing\n", true},
};

// A stub, in which the texts may be others.
class NamedStub {
public:
    // `named`: where the stub has the four bytes that take the name by which the program was called; 0 if it
    // does not print that.
    template <size_t kTextCount>
    NamedStub(const uint8_t *stub, size_t size, const Text (&texts)[kTextCount], size_t named)
        : usual(stub, stub + size), texts(texts), count(kTextCount), named(named) {}

    Bytes with(const Names &names) const;
    // Whether the stub lies at `at`, with any names.
    bool same(const uint8_t *at) const;

private:
    size_t placeOf(const Text &text) const;

    Bytes usual;
    const Text *texts;
    size_t count, named;
};

} // namespace pack
