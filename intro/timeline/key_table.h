// A table of keys that can be replaced while the film plays. odraz-debug has these instead of constants
// (timeline/keys.h). All tables of a program form a list.
#pragma once

#include "timeline/key_bits.h"
#include "timeline/track.h"

namespace odraz {

inline constexpr int kMostKeys = 1024;

// Interpolations of GNU Rocket that the film does not use. Only a KeyTable may have them.
inline constexpr Interpolation kStep = (Interpolation)2, kRamp = (Interpolation)3;

struct KeyTable {
    const char *name, *file; // such as "kLamp" and "./intro/show/scenes/hall.keys"
    bool camera;             // true: its keys are `poses`; false: `keys`
    float start = 0;         // the scene's row from which a track's rows count
    int bits = 24;           // significant bits of each number of a path
    int count = 0;
    union {
        Key keys[kMostKeys];
        CameraKey poses[kMostKeys];
    };
    KeyTable *next;                           // the next table of the list, or null
    static inline KeyTable *newest = nullptr; // the head of the list

    KeyTable(const char *name, const char *file, float start, std::initializer_list<Key> list)
        : name(name), file(file), camera(false), start(start), next(newest) {
        for (const Key &k : list) keys[count++] = k;
        newest = this;
    }
    KeyTable(const char *name, const char *file, int bits, std::initializer_list<CameraKey> list)
        : name(name), file(file), camera(true), bits(bits), next(newest) {
        for (const CameraKey &k : list) poses[count++] = withBits(k, bits);
        newest = this;
    }
};

inline const KeyTable &track(const KeyTable &table) { return table; }
inline CameraPath path(const KeyTable &table) { return {table.poses, table.count}; }

// Returns the value at any finite row, with steps and ramps.
float value(const KeyTable &table, float row);

} // namespace odraz
