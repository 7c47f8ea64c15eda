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

// The loaded film. All its memory is in the arena that load() got.
struct Intro;

struct IntroSettings {
    int width, height; // size of its pictures
    // Size of the executable and name of the processor, for the credits; 0 and null if they must not be in
    // the picture (dumps)
    int64_t bytes = 0;
    const char *machine = nullptr;
    // Whether there are two slots, for in-betweens; if not, there is only slot 0
    bool pairs = false;
    bool hall = false; // whether to solve the hall. Without it, scenes there cannot be shown
};

// Returns whether a scene in [from, to) seconds plays in the hall, which load() must then solve.
bool needsHall(double from, double to);

// Returns the bytes of arena that load() needs with this many workers.
size_t memoryNeeded(const IntroSettings &settings, int workers);

// How the patches of the hall see each other: OpenGL draws what they see, or rays find it
// (radiosity/hemicube.h).
struct HemicubeMethod;
extern const HemicubeMethod kDrawnHemicubes, kTracedHemicubes;

// Prepares the film, and reports the progress of solving the hall. `gl`: the table of OpenGL, if `method`
// draws; its context must be current. Returns null, or a line that says what is missing and what to do. If
// the arena has memoryNeeded() bytes, only the light of the hall is missing then: its scenes are black, and
// all others can be shown.
const char *load(Intro *&intro, const IntroSettings &settings, Arena &arena, Workers &workers,
                 const HemicubeMethod &method, const Gl *gl, const Progress &progress = {});

double duration(); // seconds

// The scene at a time, and its name.
inline constexpr int kMaxScenes = 16;
int sceneAt(double seconds);      // returns a number below kMaxScenes
double shotStart(double seconds); // time at which the shot of this time begins
const char *sceneName(int scene);

// Returns a scene's limits for the governor.
Pace paceOf(int scene);

// Returns the pose of the scripted camera at a time.
CameraKey cameraAt(double seconds);

// A picture to show or to keep: sRGB, four bytes a pixel, top row first. The caller may overwrite it, and the
// kHeaderRoom bytes before it. It stays valid until the next picture is made in the same slot or buffer.
struct Picture {
    int width, height;
    uint8_t *rgba;
};
inline constexpr int kHeaderRoom = 64;
inline constexpr int kSlots = 2;          // slots for traced pictures, 0 and 1
inline constexpr int kBetweenBuffers = 5; // buffers for in-betweens

// The size at which a picture is traced, in pixels; 0: the size at which it is shown.
struct TracedSize {
    int width, height;
};
inline constexpr int kMostEnlarged = 2560; // widest picture that may be traced in fewer pixels

// Traces and develops the picture of a time, in seconds, in a slot. It depends only on the time, the quality
// and the sizes. If fewer pixels are traced, the picture is scaled up. `camera` replaces the scripted one.
Picture picture(Intro &intro, int slot, double seconds, const Quality &quality,
                const CameraKey *camera = nullptr, TracedSize traced = {});

// Makes the picture that is `share` of the way in time, 0 .. 1, between the pictures of two slots. It is made
// from both or, if they show different shots, from the one that shows the same shot as the new picture. It
// depends only on these two, which do not change, and is traced in as many pixels as the later one.
Picture between(Intro &intro, int earlier, int later, double share = 0.5, int buffer = 0);

// Returns the number of samples of the last picture.
int64_t samplesTaken(const Intro &intro);
// Returns null or, if the last picture is wrong, a line that names the constant to raise for its scene.
const char *exceededLimit(const Intro &intro);

// --- Sound: independent of the picture, so that it may run on another thread ---

// The film's music while it is played. Samples, -1 .. 1, of the left and the right side alternate.
struct Sound;
inline constexpr int kSoundRate = 48000; // samples a second for each side
inline constexpr int kSoundBlock = 240;  // samples of each side in a block: 5 ms

// Returns the bytes of arena that loadSound() needs.
size_t soundMemory();

// Prepares the music, at the film's start. Returns null if the arena is full.
Sound *loadSound(Arena &arena);

// Moves to a block of the film. Takes about 0.2 s, because it renders earlier notes that still sound there.
void seekSound(Sound &sound, int block);

// Renders the next block, or skips it if `stereo` is null. After the film's end there is silence.
void soundBlock(Sound &sound, float *stereo);

} // namespace odraz
