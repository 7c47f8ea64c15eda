// The film's data for odraz-debug in addition to intro.h: shots, camera keys, events, and the costs of a
// picture. One table has all functions, because the film is a shared object.
#pragma once

#include "intro.h"
#include "show/font.h"
#include "timeline/camera.h"
#include "timeline/track.h"

namespace odraz::maker {

// A shot, [from, to) in seconds of the film. `story`: the second from which its camera's rows count.
struct ShotInfo {
    double from, to, story;
    int scene;
    const CameraPath *path; // lives in the film, which may replace its keys
};
struct EventInfo {
    double at; // seconds of the film
    float row; // in its scene
    bool heard;
    char name[40]; // "kLightIsBorn", zero-terminated
};

// The parts of making a picture.
enum class PicturePart { Posing, Tracing, Glare, Development, Enlarging, Count };

// Measurements of a picture. The host provides the clock and the memory.
struct Probe {
    int64_t (*clock)() = nullptr;                // nanoseconds
    int64_t spent[(int)PicturePart::Count] = {}; // nanoseconds; the host sets them to 0
    // null, or [height][width] counters: each sample adds one at its pixel. A sample on the border of two
    // pixels counts for the right or lower one; a sample outside counts for the nearest pixel at the edge
    uint32_t *samples = nullptr;
    int width = 0, height = 0;
};

// Sets the probe that measures pictures; null: none. Not to be called while a picture is made. In probe.cpp.
void watchPictures(Probe *probe);

struct Inspector {
    // Write at most `most` shots in the order of time, or events in any order. Return their number.
    int (*shots)(ShotInfo *to, int most);
    int (*events)(EventInfo *to, int most);
    void (*watch)(Probe *probe); // watchPictures()
    // Draws in the film's font. In a shared object the font also has the characters of compilers' messages.
    decltype(&odraz::drawText) drawText;
};

const Inspector &inspector();

} // namespace odraz::maker
