// A track of GNU Rocket: values on rows, and how the value runs from each to the next.
#pragma once

#include <cstdint>
#include <map>

namespace odraz::maker::rocket {

// As the protocol numbers them.
enum class Interpolation : uint8_t {
    Step,   // holds
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

// The value at any finite row: before the first key its value, after the last key that one's; 0 without keys.
double value(const Track &track, double row);

} // namespace odraz::maker::rocket
