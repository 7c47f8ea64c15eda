// A table of keys that may be replaced while the film plays: what odraz-debug has in place of the film's
// constants (timeline/keys.h). All tables of a program make a list.
#pragma once

#include "timeline/key_bits.h"
#include "timeline/track.h"

namespace odraz {

inline constexpr int kMostKeys = 1024;

// The interpolations of GNU Rocket that the film does not use. Only a KeyTable may have them.
inline constexpr Interpolation kStep = (Interpolation)2, kRamp = (Interpolation)3;

struct KeyTable {
    const char *name, *file; // "kLamp"; of its source, "./intro/show/scenes/hall.keys"
    bool camera;             // a path: its keys are `poses`, else `keys`
    float start = 0;         // the row of the scene that a track's rows count from
    int bits = 24;           // of a path's numbers
    int count = 0;
    union {
        Key keys[kMostKeys];
        CameraKey poses[kMostKeys];
    };
    KeyTable *next;                           // in the list; null: it is the last
    static inline KeyTable *newest = nullptr; // where the list begins

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

// The value at any finite row, steps and ramps included.
float value(const KeyTable &table, float row);

} // namespace odraz
