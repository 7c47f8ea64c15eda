// The seam between the film and its hosts: all that a host may call.
#pragma once

#include "base/arena.h"
#include "base/parallel.h"
#include "show/show.h"
#include "trace/picture/adaptive.h"

namespace odraz {

// The film, loaded. The host owns it; it holds no resources beyond the arena it was loaded from.
struct Intro {
    Workers *workers;
    Tracer tracer;
    Scene *scene;
    Hall *hall; // null where it was not asked for
    Frame picture;
    Facts facts;
};

// Whether some scene in [from, to) seconds plays in the hall, which must then be solved.
bool needsHall(double from, double to);

// Bytes of arena that load() needs for pictures of this size and so many workers.
size_t memoryNeeded(int width, int height, int workers, bool hall);

// Prepares the film for pictures of this size. With a table of OpenGL, whose context must be current, it
// solves the hall, telling how far it is; without one, scenes that play there cannot be shown. Returns null,
// or a line that says what is missing and what to do.
const char *load(Intro &intro, Arena &arena, Workers &workers, int width, int height, const Facts &facts,
                 const Gl *gl = nullptr, const Progress &progress = {});

double duration(); // seconds

// The shot on at a time: its scene's index in kScenes.
int sceneAt(double seconds);

// How the scripted camera stands at a time.
CameraKey cameraAt(double seconds);

// Traces and develops the picture of a time. It depends on nothing but the time, the quality and the size.
// With a camera given, that one looks instead of the scripted one.
const Frame &frame(Intro &intro, double seconds, const Quality &quality, const CameraKey *camera = nullptr);

} // namespace odraz
