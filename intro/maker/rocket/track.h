// A track of GNU Rocket: values on rows, and the interpolation between them.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace odraz::maker::rocket {

// Kinds of interpolation, numbered as in the protocol.
enum class Interpolation : uint8_t {
    Step,   // constant
    Linear, // straight
    Smooth, // t^2 (3 - 2t), flat at both keys
    Ramp,   // t^2, flat at the first
};

struct Key {
    float value;
    Interpolation interpolation; // up to the next key
    bool operator==(const Key &) const = default;
};

using Track = std::map<uint32_t, Key>; // by row

// Returns tracks as a document for editors of GNU Rocket: the XML that the original editor writes, which
// emoon's editor also reads. `rows`: the document's length. Names must not contain characters that XML
// reserves (the film's have letters, digits, '.', '-' and ':').
std::string document(const std::vector<std::string> &names, const std::vector<Track> &tracks, int rows);

} // namespace odraz::maker::rocket
