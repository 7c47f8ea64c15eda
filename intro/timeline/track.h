// A value over time, as keys. The interpolations are those of GNU Rocket that the film uses.
//
// Time is in rows, kRowsPerSecond a second and kRowsPerBar a bar: a row is a sixteenth note at 120 beats a
// minute. Keys are in ascending order of rows. The first key's value holds before it, and the last key's
// value after it. An empty track has the value 0. A key's interpolation applies up to the next key.
#pragma once

namespace odraz {

inline constexpr double kRowsPerSecond = 8;
inline constexpr double kRowsPerBar = 16;

enum class Interpolation : unsigned char {
    Linear, // straight
    Smooth, // t^2 (3 - 2t), flat at both keys
};

struct Key {
    float row;
    float value;
    Interpolation interpolation;
};

struct Track {
    const Key *keys;
    int count;
};

template <int N> constexpr Track track(const Key (&keys)[N]) { return {keys, N}; }

// Returns the track's value at any finite row.
float value(Track track, float row);

} // namespace odraz
