// What the panel needs of the film beyond intro.h: its shots, cameras' keys, events and materials, and what
// happens while a picture is made. All of it goes through one table of functions, so that the film may be
// another object than the panel.
#pragma once

#include "intro.h"
#include "timeline/camera.h"
#include "timeline/track.h"

namespace odraz {

inline constexpr int kNameLetters = 32; // of an event's name, with the zero at its end

// Seconds of the film, [from, to); `story`: the second from which its camera's rows count.
struct ShotSeen {
    double from, to, story;
    int scene;
    CameraPath path; // its keys, as they stand in the film's tables
    // How it is followed, and which keys it has: the film's own code may take others, which are being edited
    CameraKey (*follow)(CameraPath path, float row) = pose;
    CameraPath (*edited)(CameraPath path) = nullptr;

    CameraPath keys() const { return edited ? edited(path) : path; }
    CameraKey at(double seconds) const { return follow(path, (float)((seconds - story) * kRowsPerSecond)); }
};
struct EventSeen {
    double at;               // seconds of the film
    char name[kNameLetters]; // "light is born", of kLightIsBorn
    bool heard;
};

// A material of the scene that the last picture shows.
struct MaterialSeen {
    uint32_t hash; // of all that it is made of: equal if it looks the same
    int shapes;    // that have it
    bool mirror, glass, glows, textured;
};
inline constexpr int kMostMaterials = 32;

// The parts of making a picture.
enum class Cost { Posing, Tracing, Glare, Development, Enlarging, Count };

// What is noted while pictures are made. The host provides the clock and the memory.
struct Probe {
    int64_t (*clock)() = nullptr;         // nanoseconds
    int64_t spent[(int)Cost::Count] = {}; // nanoseconds, since the host set them to 0
    // null, or width * height numbers of samples, to which every sample adds one at its pixel. A sample on
    // the line between two pixels counts for the right or the lower one, one outside for the pixel at the
    // edge
    uint32_t *samples = nullptr;
    int width = 0, height = 0;
    // Pictures are developed at least so bright that their lights can be seen: also where the film has faded
    // out, or where the camera looks from a dark side.
    bool brightens = false;
};

struct Backstage {
    // All shots and events in the order of time, at most `most`; their number.
    int (*shots)(ShotSeen *to, int most);
    int (*events)(EventSeen *to, int most);
    // The materials of the last picture's scene, in their order; their number, at most kMostMaterials.
    int (*materials)(const Intro &intro, MaterialSeen *to);
    // Traces a ball of each of these materials, in squares of `side` pixels, `across` in a row, and as many
    // rows as they need: sRGB, four bytes a pixel. Takes swatchMemory() of the arena; false if that is too
    // little. samplesTaken() then tells of this picture.
    bool (*swatches)(Intro &intro, Arena &arena, int across, int side, uint8_t *rgba);
    size_t (*swatchMemory)(int across, int side);
    // From now on this probe notes what happens; null: none.
    void (*watch)(Probe *probe);
    // A copy of the film's music, apart from what is played: as loadSound() and soundBlock() of intro.h.
    size_t (*soundMemory)();
    Sound *(*loadSound)(Arena &arena);
    void (*soundBlock)(Sound &sound, float *stereo);
};

const Backstage &backstage();

} // namespace odraz
