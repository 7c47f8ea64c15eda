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

// A picture as it was traced, and when.
struct Slot {
    Traced traced;
    const Shot *shot;
    double seconds;
    Quality quality;
};

struct Intro {
    Workers *workers;
    Film film;
    Tracer tracer;
    Frame frame;
    Curve curve;
    Glare glare;
    Slot slots[kSlots];
    bool pairs;      // false: there is slot 0 alone, and its frame and scene are those above
    Between between; // where pictures between others are made
};

struct Sound {
    Mixer mixer;
};

} // namespace odraz
