// The seam between the film and its hosts: all that a host may call.
#pragma once

#include "base/arena.h"
#include "base/parallel.h"
#include "show/show.h"
#include "trace/adaptive.h"

namespace odraz {

// The film, loaded. The host owns it; it holds no resources beyond the arena it was loaded from.
struct Intro {
    Workers *workers;
    Tracer tracer;
    Scene *scene;
    Frame picture;
    Facts facts;
};

// Bytes of arena that load() needs for pictures of this size and so many workers.
size_t memoryNeeded(int width, int height, int workers);

// Prepares the film for pictures of this size, calling progress(0 .. 1) on the way; false when the arena is
// too small or the viewer has left.
bool load(Intro &intro, Arena &arena, Workers &workers, int width, int height, const Facts &facts,
          void (*progress)(float done, void *context), void *context);

double duration(); // seconds

// The shot on at a time: its scene's index in kScenes.
int sceneAt(double seconds);

// How the scripted camera stands at a time.
CameraKey cameraAt(double seconds);

// Traces and develops the picture of a time. It depends on nothing but the time, the quality and the size.
// With a camera given, that one looks instead of the scripted one.
const Frame &frame(Intro &intro, double seconds, const Quality &quality, const CameraKey *camera = nullptr);

} // namespace odraz
