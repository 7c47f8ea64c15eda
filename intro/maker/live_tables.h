// The tables of keys in the film that is shown: which there are, and what else they may be read as.
#pragma once

#include "timeline/camera.h"
#include "timeline/track.h"

namespace odraz {

struct Intro;

// A table, as a scene or a shot reads it.
struct Table {
    const void *keys; // of CameraKey if it is a camera's path, else of Key
    int count;
    int scene; // that reads it first
    bool camera;
    float shift; // where it is read first: the film's row, minus the table's
};

inline constexpr int kChannels = 8; // of a camera: eye, target, roll, field of view

// What a table is read as instead. Keys have the rows of the table.
struct Replaced {
    const void *keys;               // the table's own
    Track track;                    // of a table of Key
    CameraPath channels[kChannels]; // of a camera's path: what each number is taken from; empty: its own
};

// The interpolations of GNU Rocket that the film does not use; they may stand in a Replaced.
inline constexpr Interpolation kStep = (Interpolation)2, kRamp = (Interpolation)3;

// Finds the tables in the order in which the film reads them, `most` at most, and returns how many. Poses the
// whole film for that, 0.1 s or so; the next picture is as ever. The film must be loaded, with its hall.
int findTables(Intro &intro, Table *to, int most);

// The table of the camera's path that is shown at a time.
const CameraKey *pathAt(double seconds);

// A path as it is read now.
CameraPath editedPath(CameraPath path);

// From now on, tables are read as these. They are not copied, and are in force until others are given.
void replaceTables(const Replaced *all, int count);

} // namespace odraz
