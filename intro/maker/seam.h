// The functions of intro.h, each as FILM(type, name, (parameters), (arguments)). SOUND functions are called
// on the music thread, with the Sound that was loaded first; the arguments here pass the newest one.
#pragma once

#include "intro.h"

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
