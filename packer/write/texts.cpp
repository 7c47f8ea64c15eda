#include "packer/write/texts.h"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace pack {

namespace {

constexpr size_t kMostOfName = 10, kMostOfSafeName = 14;
constexpr char kTooLong[] =
    "a name is too long for what the packed program says: --name takes up to 10 letters, "
    "--safe-name up to 14";
constexpr uint8_t kNoName[] = {0x31, 0xf6, 0x66, 0x90}; // xor esi, esi; two bytes that do nothing

// The lines that may stand in place of the usual one, the best first.
std::vector<std::string> lines(const Text &text, const Names &names) {
    const std::string &program = names.program, &safe = names.safe;
    if (text.what == Text::kMayNotRun && !safe.empty()) {
        std::string called = text.called && program.empty() ? ": " : "";
        return {called + "use " + safe + " instead\n", called + "use " + safe + "\n"};
    }
    if (program.empty()) return {text.usual};
    switch (text.what) {
    case Text::kDamaged:
        return {program + " is damaged\n"};
    case Text::kNoMemory:
        return {program + ": no memory\n"};
    case Text::kMayNotRun:
        return {program + " may not run\n", program + ": denied\n"};
    case Text::kNoInterpreter:
        return {program + ": no ld.so\n"};
    }
    return {};
}

bool isName(const std::string &name) {
    return std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return (c < 128 && std::isalnum(c)) || (c && std::strchr("._+-", c));
    });
}

} // namespace

std::string withNames(const Text &text, const Names &names) {
    size_t room = std::strlen(text.usual);
    for (std::string &line : lines(text, names)) {
        if (line.size() > room) continue;
        if (text.called)
            line.resize(room);
        else
            line.insert(line.size() - 1, room - line.size(), ' ');
        return line;
    }
    throw common::Refused(kTooLong);
}

void checkNames(const Names &names) {
    need(isName(names.program) && isName(names.safe), "names consist of letters, digits and . _ + -");
    need(names.program.size() <= kMostOfName && names.safe.size() <= kMostOfSafeName, kTooLong);
    for (const Text &text : kTexts) withNames(text, names);
    for (const Text &text : kLoaderTexts) withNames(text, names);
}

size_t NamedStub::placeOf(const Text &text) const {
    const char *end = text.usual + std::strlen(text.usual);
    return (size_t)(std::search(usual.begin(), usual.end(), text.usual, end) - usual.begin());
}

Bytes NamedStub::with(const Names &names) const {
    Bytes stub = usual;
    for (size_t i = 0; i < count; ++i) {
        std::string text = withNames(texts[i], names);
        std::copy(text.begin(), text.end(), stub.begin() + (long)placeOf(texts[i]));
    }
    if (named && !names.program.empty()) std::copy_n(kNoName, sizeof kNoName, stub.begin() + (long)named);
    return stub;
}

bool NamedStub::same(const uint8_t *at) const {
    Bytes stub(at, at + usual.size());
    for (size_t i = 0; i < count; ++i)
        std::copy_n(texts[i].usual, std::strlen(texts[i].usual), stub.begin() + (long)placeOf(texts[i]));
    if (named && std::equal(kNoName, std::end(kNoName), stub.begin() + (long)named))
        std::copy_n(usual.begin() + (long)named, sizeof kNoName, stub.begin() + (long)named);
    return stub == usual;
}

} // namespace pack
