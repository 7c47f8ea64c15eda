// The seam between the film and its hosts: the functions that a host may call.
#pragma once

#include "base/arena.h"
#include "base/gl.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "timeline/camera.h"
#include "timeline/pace.h"
#include "trace/quality.h"

namespace odraz {

// The film, loaded. All of it is in the arena that it was loaded from.
struct Intro;

struct IntroSettings {
    int width, height; // of its pictures
    // For the credits: the size of the executable and the processor's name; 0 and null if they must not be
    // in the picture (dumps)
    int64_t bytes = 0;
    const char *machine = nullptr;
    // whether there are two slots, for in-betweens; if not, there is only slot 0
    bool pairs = false;
};

// Whether some scene in [from, to) seconds plays in the hall, which must then be solved.
bool needsHall(double from, double to);

// Bytes of arena that load() needs with this many workers.
size_t memoryNeeded(const IntroSettings &settings, int workers, bool hall);

// Prepares the film. With a table of OpenGL, whose context must be current, it solves the hall and reports
// its progress; without one, scenes that play there cannot be shown. Returns null, or a line that says what
// is missing and what to do.
const char *load(Intro *&intro, const IntroSettings &settings, Arena &arena, Workers &workers,
                 const Gl *gl = nullptr, const Progress &progress = {});

double duration(); // seconds

// The scene that is shown at a time, and its name.
inline constexpr int kMaxScenes = 16;
int sceneAt(double seconds); // below kMaxScenes
double shotStart(double seconds); // when the shot began, in seconds
const char *sceneName(int scene);

// Its limits for the governor.
Pace paceOf(int scene);

// The pose of the scripted camera at a time.
CameraKey cameraAt(double seconds);

// A picture to show or to keep: sRGB, four bytes a pixel, top row first. The caller may overwrite it, and the
// kHeaderRoom bytes before it. It stays valid until another one is made in its place: in the same slot, or by
// between().
struct Picture {
    int width, height;
    uint8_t *rgba;
};
inline constexpr int kHeaderRoom = 64;
inline constexpr int kSlots = 2;  // places for pictures, 0 and 1
inline constexpr int kPlaces = 5; // places for in-betweens

// How many pixels of a picture are traced; 0: as many as it has.
struct TracedSize {
    int width, height;
};
inline constexpr int kMostEnlarged = 2560; // width of pictures that may be traced in fewer pixels

// Traces and develops the picture of a time, in seconds, in a slot. It depends on nothing but the time, the
// quality and the sizes. If fewer pixels are traced, the picture is scaled up. A given `camera` replaces the
// scripted one.
Picture picture(Intro &intro, int slot, double seconds, const Quality &quality,
                const CameraKey *camera = nullptr, TracedSize traced = {});

// Makes the picture that is `share` of the way in time, 0 .. 1, between those of two slots: from these two
// or, if they are of different shots, from the one of its own shot. It depends on nothing but these two,
// which stay as they are, and has the size of the later one. It stays valid until another one is made in its
// place.
Picture between(Intro &intro, int earlier, int later, double share = 0.5, int place = 0);

// About the last picture: the number of samples that it took; and null, or the constant of scene.h that is
// too small for its scene, so that the picture is wrong.
int64_t samplesTaken(const Intro &intro);
const char *outgrown(const Intro &intro);

// --- Sound: independent of the picture, so that it may run on another thread ---

// The film's music while it is being played. It is stereo: samples of the left and the right side alternate,
// -1 .. 1.
struct Sound;
inline constexpr int kSoundRate = 48000; // samples a second, of each side
inline constexpr int kSoundBlock = 240;  // of each side that are made at a time: 5 ms

// Bytes of arena that loadSound() takes.
size_t soundMemory();

// Makes the music, at the film's start; null if the arena is full.
Sound *loadSound(Arena &arena);

// Moves to a block of the film. Takes some 0.2 s, because earlier notes that still sound there are rendered.
void seekSound(Sound &sound, int block);

// Renders the next block, or skips it if `stereo` is null. After the film's end there is silence.
void soundBlock(Sound &sound, float *stereo);

} // namespace odraz
