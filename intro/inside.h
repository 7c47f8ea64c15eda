// What an Intro is made of: for intro.cpp, and for tools and tests that measure its parts. Hosts know intro.h
// alone.
#pragma once

#include "intro.h"
#include "show/score.h"
#include "show/show.h"
#include "sound/mixer.h"
#include "timeline/shot.h"
#include "trace/picture/between.h"
#include "trace/picture/development.h"

namespace odraz {

struct Intro {
    Workers *workers;
    Film film;
    Tracer tracer;
    Frame frame;
    Curve curve;
    Air air;
    // Where pictures between others are made: the last two traced, the later one second, and their moments
    bool pairs;
    Between between;
    Traced sides[2];
    const Shot *shots[2];
    double seconds[2];
    Quality quality; // of the later one
};

struct Sound {
    Mixer mixer;
};

} // namespace odraz
