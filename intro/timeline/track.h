// A value over time as keys, with those interpolations of GNU Rocket that the film uses.
//
// Time is in rows: kRowsPerSecond of them, a sixteenth note each at 120 beats a minute; a bar is kRowsPerBar.
// Keys stand in ascending rows. Before the first key its value holds, after the last key the last one's;
// an empty track is 0. The interpolation of a key rules the stretch up to the next key.
#pragma once

namespace odraz {

inline constexpr double kRowsPerSecond = 8;
inline constexpr double kRowsPerBar = 16;

enum class Interpolation : unsigned char {
    Linear, // straight
    Smooth, // t^2 (3 - 2t): flat at both keys
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

// The track's value at a row; any finite row.
float value(Track track, double row);

} // namespace odraz
