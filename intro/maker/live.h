// The film as odraz-debug calls it: the functions of intro.h, in a shared object that is built and loaded
// anew while the film plays.
#pragma once

#include "intro.h"
#include "maker/live_tables.h"
#include "maker/panel/backstage.h"

namespace odraz {

struct Live {
    bool (*needsHall)(double from, double to);
    size_t (*memoryNeeded)(const IntroSettings &settings, int workers, bool hall);
    const char *(*load)(Intro *&intro, const IntroSettings &settings, Arena &arena, Workers &workers,
                        const Gl *gl, const Progress &progress);
    double (*duration)();
    int (*sceneAt)(double seconds);
    const char *(*sceneName)(int scene);
    Pace (*paceOf)(int scene);
    CameraKey (*cameraAt)(double seconds);
    Picture (*picture)(Intro &intro, int slot, double seconds, const Quality &quality,
                       const CameraKey *camera, TracedSize traced);
    Picture (*between)(Intro &intro, int earlier, int later, double share, int place);
    int64_t (*samplesTaken)(const Intro &intro);
    const char *(*outgrown)(const Intro &intro);
    size_t (*soundMemory)();
    Sound *(*loadSound)(Arena &arena);
    void (*seekSound)(Sound &sound, int block);
    void (*soundBlock)(Sound &sound, float *stereo);
    // A hash of what the hall's light is solved from: its shape, what it reflects, its lights and settings.
    // Takes hallHashMemory bytes of the arena
    uint64_t (*hallHash)(Arena &arena);
    size_t hallHashMemory;
    // Writes text over a picture, on a dark ground, at its lower edge, in as many lines as it takes; and
    // below it a bar that is filled up to `done` (0 .. 1) of the width, if there is something to wait for
    void (*write)(const Picture &picture, const char *text, float done);
    // See live_tables.h
    int (*findTables)(Intro &intro, Table *to, int most);
    const CameraKey *(*pathAt)(double seconds); // the table of the camera's path that is shown
    void (*replaceTables)(const Replaced *all, int count);
    const Backstage &(*backstage)();
    size_t sizes[4]; // of what load() and loadSound() make: where they differ, these must be called again
};

using GetLive = const Live *();
inline constexpr char kGetLive[] = "odrazLive"; // the one function that the shared object shows

} // namespace odraz
