// The film's player on a simulated machine, or the page's: their own decisions (play/schedule.h,
// play/governor.h, play/page_player.h), on a clock that counted instructions move. There is no noise, so the
// same numbers come out everywhere.
#pragma once

#include "intro.h"
#include "tools/measure/seen/costs.h"
#include "tools/measure/seen/shown.h"

#include <functional>

namespace odraz::measure {

// Uploading a picture and drawing it: 1.3 ms of a core of 7 G instructions a second at 1280x720, as --stats
// prints for OpenGL in software.
inline constexpr double kPresenting = 10;

// Scaling up, of all threads together: callgrind counts 13 M for 1280x720 from 960x540.
inline constexpr double kEnlarging = 14;

struct Machine {
    double rate;                     // instructions a second, of all cores
    int cores;                       // that share it
    int width, height;               // pixels of its screen
    double presenting = kPresenting; // instructions that showing a pixel takes
    double enlarging = kEnlarging;   // ... and that scaling up takes, for a pixel of the screen
    std::function<Pace(int scene)> paceOf = odraz::paceOf;
    int workers = 0; // the page's player has so many, each on a core; 0: the film's own player
};

// What a picture costs. A table's Costs::of(), or a test's own.
using CostOf = std::function<Cost(const Pictured &)>;

// Plays the film from one second to another and returns which pictures were made and when they were shown, in
// order. All cores share the parallel part of making a picture; one core does the serial part. Showing takes
// time of one core, which is lost to tracing. The screen shows a picture from its next sixtieth of a second
// on; the screen's sixtieths begin half-way between the film's. Nothing else costs time. A page's worker
// makes a picture alone.
std::vector<Shown> simulate(const CostOf &costOf, const Machine &machine, double from, double to);

// What was done for a scene, by the pictures' own times.
struct PlayedScene {
    int scene;
    double seconds; // that the list covers
    int traced, between, shown;
    double level, width; // means, over the traced ones
    double rate;         // instructions a second that making and showing them took
};
// The scenes that a list shows, in the film's order, from its first picture to its last one.
std::vector<PlayedScene> summary(const std::vector<Shown> &list, const CostOf &costOf,
                                 const Machine &machine);
// ... as rows of a CSV, each behind `before`; the last column is in 10^9 a second.
inline constexpr char kSummaryHead[] = "scene,seconds,traced,between,shown,a_second,level,width,giga";
std::string printSummary(const std::vector<PlayedScene> &scenes, const std::string &before);

} // namespace odraz::measure
