#include "packer/write/messages.h"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace pack {

namespace {

constexpr size_t kMostOfName = 10, kMostOfSafeName = 14;
constexpr char kTooLong[] =
    "a name is too long for the messages of the packed program: --name takes up to 10 letters, "
    "--safe-name up to 14";
constexpr uint8_t kNoName[] = {0x31, 0xf6, 0x66, 0x90}; // xor esi, esi; a nop of two bytes

// The lines that can replace the usual one, the best first.
std::vector<std::string> lines(const Message &message, const Names &names) {
    const std::string &program = names.program, &safe = names.safe;
    if (message.what == Message::kMayNotRun && !safe.empty()) {
        std::string called = message.called && program.empty() ? ": " : "";
        return {called + "use " + safe + " instead\n", called + "use " + safe + "\n"};
    }
    if (program.empty()) return {message.usual};
    switch (message.what) {
    case Message::kDamaged:
        return {program + " is damaged\n"};
    case Message::kNoMemory:
        return {program + ": no memory\n"};
    case Message::kMayNotRun:
        return {program + " may not run\n", program + ": denied\n"};
    case Message::kNoInterpreter:
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

std::string withNames(const Message &message, const Names &names) {
    size_t room = std::strlen(message.usual);
    for (std::string &line : lines(message, names)) {
        if (line.size() > room) continue;
        if (message.called)
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
    for (const Message &message : kMessages) withNames(message, names);
    for (const Message &message : kLoaderMessages) withNames(message, names);
}

size_t NamedStub::placeOf(const Message &message) const {
    const char *end = message.usual + std::strlen(message.usual);
    return (size_t)(std::search(usual.begin(), usual.end(), message.usual, end) - usual.begin());
}

Bytes NamedStub::with(const Names &names) const {
    Bytes stub = usual;
    for (size_t i = 0; i < count; ++i) {
        std::string message = withNames(messages[i], names);
        std::copy(message.begin(), message.end(), stub.begin() + (long)placeOf(messages[i]));
    }
    if (named && !names.program.empty()) std::copy_n(kNoName, sizeof kNoName, stub.begin() + (long)named);
    return stub;
}

bool NamedStub::same(const uint8_t *at) const {
    Bytes stub(at, at + usual.size());
    for (size_t i = 0; i < count; ++i)
        std::copy_n(messages[i].usual, std::strlen(messages[i].usual),
                    stub.begin() + (long)placeOf(messages[i]));
    if (named && std::equal(kNoName, std::end(kNoName), stub.begin() + (long)named))
        std::copy_n(usual.begin() + (long)named, sizeof kNoName, stub.begin() + (long)named);
    return stub == usual;
}

} // namespace pack
