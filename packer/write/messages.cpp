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

// What follows a program's name, by Message::What; the best first.
constexpr const char *kWithName[][2] = {
    {" is damaged"}, {": no memory"}, {" may not run", ": denied"}, {": no ld.so"}};

// The lines that can replace the usual one, the best first.
std::vector<std::string> lines(const Message &message, const Names &names) {
    if (message.what == Message::kMayNotRun && !names.safe.empty()) {
        std::string called = message.called && names.program.empty() ? ": " : "";
        return {called + "use " + names.safe + " instead\n", called + "use " + names.safe + "\n"};
    }
    if (names.program.empty()) return {message.usual};
    std::vector<std::string> all;
    for (const char *rest : kWithName[message.what])
        if (rest) all.push_back(names.program + rest + "\n");
    return all;
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
