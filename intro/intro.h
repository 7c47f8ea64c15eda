// The seam between the film and its hosts: all that a host may call.
#pragma once

#include "base/arena.h"
#include "base/gl.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "timeline/camera.h"
#include "trace/quality.h"

namespace odraz {

// The film, loaded. It lies in the arena that it was loaded from and holds nothing else.
struct Intro;

struct IntroSettings {
    int width, height; // of its pictures
    // What the credits tell of this copy and this machine: the size of the executable and the processor's
    // name; 0 and null where they must not enter the picture (dumps)
    int64_t bytes = 0;
    const char *machine = nullptr;
    bool pairs = false; // whether there are two slots, and pictures between them; else there is slot 0
};

// Whether some scene in [from, to) seconds plays in the hall, which must then be solved.
bool needsHall(double from, double to);

// Bytes of arena that load() needs, for so many workers.
size_t memoryNeeded(const IntroSettings &settings, int workers, bool hall);

// Prepares the film. With a table of OpenGL, whose context must be current, it solves the hall, telling how
// far it is; without one, scenes that play there cannot be shown. Returns null, or a line that says what is
// missing and what to do.
const char *load(Intro *&intro, const IntroSettings &settings, Arena &arena, Workers &workers,
                 const Gl *gl = nullptr, const Progress &progress = {});

double duration(); // seconds

// The scene that is on at a time, and what it is called.
inline constexpr int kMaxScenes = 16;
int sceneAt(double seconds); // below kMaxScenes
const char *sceneName(int scene);

// How the scripted camera stands at a time.
CameraKey cameraAt(double seconds);

// A picture to show or to keep: sRGB, four bytes a pixel, top row first. The caller may overwrite it, and the
// kHeaderRoom bytes before it. It lasts until another one is made in its place: in the same slot, or between.
struct Picture {
    int width, height;
    uint8_t *rgba;
};
inline constexpr int kHeaderRoom = 64;
inline constexpr int kSlots = 2; // places for pictures, 0 and 1

// Traces and develops the picture of a time, in a slot. It depends on nothing but the time, the quality and
// the size. With a camera given, that one looks instead of the scripted one.
Picture picture(Intro &intro, int slot, double seconds, const Quality &quality,
                const CameraKey *camera = nullptr);

// The picture half-way in time between those of two slots: made from them, or where they are of different
// shots, traced. It depends on nothing but these two; they stay as they are. What must be traced has the
// quality of the later one.
Picture between(Intro &intro, int earlier, int later);

// Of the last picture: samples that it took; null, or the constant of scene.h that its scene outgrew, so that
// it is not what was meant.
int64_t samplesTaken(const Intro &intro);
const char *outgrown(const Intro &intro);

// --- Sound: apart from the picture, for another thread if a host likes ---

// The film's music as it is being played: zeroed memory of this struct's size makes one. Stereo, samples of
// the left and of the right side in turn, -1 .. 1.
struct Sound;
inline constexpr int kSoundRate = 48000; // samples a second, of each side
inline constexpr int kSoundBlock = 240;  // that are made at a time: 5 ms

size_t soundMemory();

// At the film's begin; null where the arena is full.
Sound *loadSound(Arena &arena);

// Goes to a block of the film, in some 0.2 s: what rings there from before is rendered.
void seekSound(Sound &sound, int block);

// Renders the next block, or goes on without when that is null. After the film's end there is silence.
void soundBlock(Sound &sound, float *stereo);

} // namespace odraz
