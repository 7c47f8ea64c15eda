#include "packer/write/messages.h"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace pack {

bool isSafeName(const std::string &name) {
    return name.size() <= 14 && std::all_of(name.begin(), name.end(), [](unsigned char c) {
               return (c < 128 && std::isalnum(c)) || (c && std::strchr("._+-", c));
           });
}

void checkSafeName(const std::string &name) {
    need(isSafeName(name), "wrong safe name: use up to 14 letters, digits and . _ + -");
}

std::string mayNotRun(const std::string &usual, const std::string &safeName) {
    if (safeName.empty()) return usual;
    bool afterName = usual[0] == ':';
    std::string line = (afterName ? ": use " : "use ") + safeName;
    if (line.size() + std::strlen(" instead\n") <= usual.size()) line += " instead";
    if (afterName)
        (line += "\n").resize(usual.size());
    else
        line.resize(usual.size() - 1, ' '), line += "\n";
    return line;
}

Bytes NamedStub::replaced(Bytes stub, const std::string &by) const {
    auto offset = std::search(usual.begin(), usual.end(), message.begin(), message.end()) - usual.begin();
    std::copy(by.begin(), by.end(), stub.begin() + offset);
    return stub;
}

Bytes NamedStub::with(const std::string &safeName) const {
    return replaced(usual, mayNotRun(message, safeName));
}

bool NamedStub::same(const uint8_t *at) const {
    return replaced(Bytes(at, at + usual.size()), message) == usual;
}

} // namespace pack
