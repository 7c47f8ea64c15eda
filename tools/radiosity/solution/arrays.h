// Arrays in files, stored as in memory, with a checksum against damage.
#pragma once

#include "tools/common/hash.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace odraz::radiosity {

// FNV-1a over 8-byte words, which is faster than over bytes. High bits are mixed into low ones.
inline uint64_t checksum(const char *p, size_t size) {
    uint64_t sum = common::kFnvStart;
    for (; size >= 8; p += 8, size -= 8) {
        uint64_t word;
        std::memcpy(&word, p, 8);
        sum = common::fnv1a(sum, word);
        sum ^= sum >> 29;
    }
    return common::fnv1a({p, size}, sum);
}

// The content of a file: a line that names its kind, the checksum of the rest, and the rest.
inline std::string withChecksum(const std::string &magic, const std::string &body) {
    uint64_t sum = checksum(body.data(), body.size());
    return magic + std::string((const char *)&sum, sizeof sum) + body;
}
// The offset of the part after the checksum; npos if that part is damaged, 0 if the file is of another kind.
inline size_t bodyOf(std::string_view file, const std::string &magic) {
    size_t at = magic.size() + sizeof(uint64_t);
    if (file.size() < at || file.compare(0, magic.size(), magic) != 0) return 0;
    uint64_t sum;
    std::memcpy(&sum, file.data() + magic.size(), sizeof sum);
    return sum == checksum(file.data() + at, file.size() - at) ? at : std::string::npos;
}

// Appends arrays. Each is its count, the size of one item, and the items' bytes.
template <class... Arrays> void put(std::string &to, const Arrays &...all) {
    auto one = [&to](const auto &from) {
        const uint64_t head[2] = {std::size(from), sizeof *std::data(from)};
        to.append((const char *)head, sizeof head);
        if (head[0]) to.append((const char *)std::data(from), head[0] * head[1]);
    };
    (one(all), ...);
}

// Finds the bytes of an array whose items have this size.
inline bool getBytes(std::string_view from, size_t &at, size_t size, std::string_view &to) {
    uint64_t head[2];
    if (from.size() - at < sizeof head) return false;
    std::memcpy(head, from.data() + at, sizeof head);
    at += sizeof head;
    if (head[1] != size || head[0] > (from.size() - at) / size) return false;
    to = from.substr(at, head[0] * size);
    at += to.size();
    return true;
}
// Reads characters in place, and copies other arrays.
inline bool getOne(std::string_view from, size_t &at, std::string_view &to) {
    return getBytes(from, at, 1, to);
}
template <class T> bool getOne(std::string_view from, size_t &at, std::vector<T> &to) {
    std::string_view found;
    if (!getBytes(from, at, sizeof(T), found)) return false;
    to.resize(found.size() / sizeof(T));
    if (!to.empty()) std::memcpy((void *)to.data(), found.data(), found.size());
    return true;
}
// Reads arrays that put() wrote, from offset `at` on, and moves `at` past them. False if one cannot be read.
template <class... Arrays> bool get(std::string_view from, size_t &at, Arrays &...all) {
    return (getOne(from, at, all) && ...);
}

} // namespace odraz::radiosity
