// Figures of the film's shots and cameras, for its tests.
#pragma once

#include "show/show.h"

namespace odraz {

// Returns the row at which a shot ends.
inline float endOf(int shot) { return shot + 1 < kFilm.count ? kFilm.shots[shot + 1].row : kFilm.endRow; }

// Returns the row at which a scene's story begins; -1 if no shot shows the scene.
inline int firstRow(int scene) {
    for (int i = 0; i < kFilm.count; ++i)
        if (kFilm.shots[i].scene == scene) return (int)kFilm.shots[i].storyRow;
    return -1;
}

// Returns the angle between the directions of two cameras, in degrees.
inline double degreesBetween(const CameraKey &a, const CameraKey &b) {
    float cosine = dot(normalize(a.target - a.eye), normalize(b.target - b.eye));
    return std::acos(std::fmin(1., (double)cosine)) * 57.3;
}

} // namespace odraz
