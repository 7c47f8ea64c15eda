// The parts of an Intro, for intro.cpp and for tools and tests that measure them. Hosts use intro.h alone.
#pragma once

#include "intro.h"
#include "show/score.h"
#include "show/show.h"
#include "sound/mixer.h"
#include "timeline/shot.h"
#include "trace/picture/between.h"
#include "trace/picture/development.h"

namespace odraz {

// A traced picture, and its time.
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
    int width, height; // size of the pictures
    Frame frame;       // for in-betweens, and for letters
    uint8_t *unscaled; // a picture before it is scaled up
    ToneCurve curve;
    Glare glare;
    Slot slots[kSlots];
    // If false, there is only slot 0, which uses the frame above and the film's scene
    bool pairs;
    Between between;                // working memory for in-betweens
    uint8_t *made[kBetweenBuffers]; // finished in-betweens; the first one is frame.rgba
};

struct Sound {
    Mixer mixer;
};

} // namespace odraz
