// What odraz-debug needs of the film beyond intro.h: its shots, cameras' keys and events, and the costs of a
// picture. All of it goes through one table of functions, because the film is a shared object.
#pragma once

#include "intro.h"
#include "show/font.h"
#include "timeline/camera.h"
#include "timeline/track.h"

namespace odraz::maker {

// Seconds of the film, [from, to); `story`: the second from which its camera's rows count.
struct ShotInfo {
    double from, to, story;
    int scene;
    const CameraPath *path; // in the film, which may replace its keys
};
struct EventInfo {
    double at; // seconds of the film
    float row; // of its scene
    bool heard;
    char name[40]; // "kLightIsBorn", with the zero at its end
};

// The parts of making a picture.
enum class Cost { Posing, Tracing, Glare, Development, Enlarging, Count };

// Measurements of a picture. The host provides the clock and the memory.
struct Probe {
    int64_t (*clock)() = nullptr;         // nanoseconds
    int64_t spent[(int)Cost::Count] = {}; // nanoseconds, since the host set them to 0
    // null, or width * height counters, to which every sample adds one at its pixel. A sample on the border
    // of two pixels counts for the right or the lower one, one outside for the pixel at the edge
    uint32_t *samples = nullptr;
    int width = 0, height = 0;
};

// From now on pictures are measured by this probe; null: by none. Must not be called while a picture is made.
// In probe.cpp.
void watchPictures(Probe *probe);

struct Inspector {
    // All shots in the order of time, and all events, at most `most`; their number.
    int (*shots)(ShotInfo *to, int most);
    int (*events)(EventInfo *to, int most);
    void (*watch)(Probe *probe); // watchPictures()
    // The film's font. That of a shared object has the letters of compilers' messages, too.
    decltype(&odraz::drawText) drawText;
};

const Inspector &inspector();

} // namespace odraz::maker
