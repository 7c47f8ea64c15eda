// A value over time, as keys. It has those interpolations of GNU Rocket that the film uses.
//
// Time is in rows, kRowsPerSecond of them: a row is a sixteenth note at 120 beats a minute, and a bar has
// kRowsPerBar. Keys are in ascending order of rows. Before the first key its value holds, after the last key
// the last value. An empty track is 0. A key's interpolation applies up to the next key.
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

// The track's value at any finite row.
float value(Track track, float row);

} // namespace odraz
