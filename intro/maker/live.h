// The film as odraz-debug calls it: a shared object that is rebuilt and reloaded while the film plays.
#pragma once

#include "intro.h"
#include "maker/panel/inspector.h"
#include "timeline/key_table.h"

#include <string>

// The functions of intro.h, each as FILM(type, name, (parameters), (arguments)). SOUND functions are called
// on the music thread, with the Sound that was loaded first; the arguments here pass the newest one.
// clang-format off
#define ODRAZ_SEAM(FILM, SOUND) \
    FILM(bool, needsHall, (double from, double to), (from, to)) \
    FILM(size_t, memoryNeeded, (const IntroSettings &s, int workers), (s, workers)) \
    FILM(const char *, load, (Intro *&intro, const IntroSettings &s, Arena &arena, Workers &workers, \
         const HemicubeMethod &method, const Gl *gl, const Progress &progress), \
         (intro, s, arena, workers, method, gl, progress)) \
    FILM(double, duration, (), ()) \
    FILM(int, sceneAt, (double seconds), (seconds)) \
    FILM(double, shotStart, (double seconds), (seconds)) \
    FILM(const char *, sceneName, (int scene), (scene)) \
    FILM(Pace, paceOf, (int scene), (scene)) \
    FILM(CameraKey, cameraAt, (double seconds), (seconds)) \
    FILM(Picture, picture, (Intro &intro, int slot, double seconds, const Quality &quality, const CameraKey *camera, \
         TracedSize traced), (intro, slot, seconds, quality, camera, traced)) \
    FILM(Picture, between, (Intro &intro, int earlier, int later, double share, int buffer), \
         (intro, earlier, later, share, buffer)) \
    FILM(int64_t, samplesTaken, (const Intro &intro), (intro)) \
    FILM(const char *, exceededLimit, (const Intro &intro), (intro)) \
    FILM(size_t, soundMemory, (), ()) \
    FILM(Sound *, loadSound, (Arena &arena), (arena)) \
    SOUND(void, seekSound, (Sound &first, int block), (sound, block)) \
    SOUND(void, soundBlock, (Sound &first, float *stereo), (sound, stereo))
// clang-format on

namespace odraz::maker {

struct Live {
#define FUNCTION(type, name, parameters, arguments) type(*name) parameters;
    ODRAZ_SEAM(FUNCTION, FUNCTION)
#undef FUNCTION
    const Inspector &(*inspector)();
    // Hashes what lights the hall: geometry, reflectance, lights, settings. Needs hallHashMemory bytes
    uint64_t (*hallHash)(Arena &arena);
    size_t hallHashMemory;
    KeyTable *(*keyTables)(); // the head of the list of all tables
    // Replaces a table's keys from the next picture on. `keys`: at most kMostKeys, of the table's type
    void (*setKeys)(KeyTable &table, const void *keys, int count);
    // Bytes of Intro, Scene, Hall and Sound. If one changes, load() and loadSound() must run again
    size_t sizes[4];
};

using GetLive = const Live *();
inline constexpr char kGetLive[] = "odrazLive"; // the one function that the shared object exports

// --- In the program (live_film.cpp) ---

// Loads an object, even if one of that name is loaded already. If it cannot, returns null, with the reason in
// `wrong`. Objects are never unloaded, because data that they made point into them.
const Live *openLive(const std::string &file, std::string &wrong);

// From now on the functions of intro.h call `live`, and the music thread plays `sound`.
void useLive(const Live *live, Sound *sound);

} // namespace odraz::maker
