// What an Intro is made of: for intro.cpp, and for tools and tests that measure its parts. Hosts know intro.h
// alone.
#pragma once

#include "intro.h"
#include "show/score.h"
#include "show/show.h"
#include "sound/mixer.h"
#include "trace/picture/development.h"
#include "trace/picture/tracer.h"

namespace odraz {

struct Intro {
    Workers *workers;
    Film film;
    Tracer tracer;
    Frame frame;
    Curve curve;
};

struct Sound {
    Mixer mixer;
};

} // namespace odraz
