// The film's player, or the page's, on a simulated machine. Both use the film's own decisions
// (play/schedule.h, play/governor.h, play/page_player.h); counted instructions advance the clock. There is no
// noise, so results are the same everywhere.
#pragma once

#include "intro.h"
#include "tools/measure/play/costs.h"
#include "tools/measure/play/shown.h"

#include <functional>

namespace odraz::measure {

// Instructions per pixel to upload and draw a picture: 1.3 ms of a core of 7 G instructions a second at
// 1280x720, as --stats prints for OpenGL in software.
inline constexpr double kPresenting = 10;

// Instructions per pixel to scale a picture up, of all threads together: callgrind counts 13 M from 960x540
// to 1280x720, and the threads could execute as many again while they wait for memory.
inline constexpr double kEnlarging = 25;

// Instructions per pixel that all threads together could execute while they wait for memory: in a traced
// picture, and in an in-between. Fitted to 210 kinds of pictures, timed on two threads, in all scenes: times
// differ by 12 % (rms) from what counts and waits predict, and by 26 % without waits.
inline constexpr double kTracingWaits = 27, kCarryingWaits = 115;

// Instructions per pixel of the first pictures, which take new memory from the system: 60 ms each at
// 1280x720.
inline constexpr double kTouching = 950;

struct SimulatedMachine {
    double rate; // instructions a second of all cores together
    int cores;
    int width, height;               // pixels of its screen
    double presenting = kPresenting; // instructions per pixel of the screen
    // Instructions per pixel of a picture
    double tracingWaits = kTracingWaits, carryingWaits = kCarryingWaits, touching = kTouching;
    std::function<Pace(int scene)> paceOf = odraz::paceOf;
    std::function<double(double seconds)> rateAt = {}; // replaces `rate` in the film's own player
    int workers = 0; // workers of the page's player, one per core; 0: the film's own player
};

// Returns the cost of a picture: PictureCosts::of(), or a test's function.
using CostOf = std::function<PictureCost(const PictureKind &)>;

// Plays the film from one second to another. Returns the pictures that were made and when they were shown, in
// order. All cores share the parallel part of making a picture; one core does the serial part. On the page a
// worker makes a picture alone. Showing takes time of one core, which is lost to tracing. The screen shows a
// picture from its next refresh on; it is refreshed 60 times a second, half-way between the film's sixtieths.
// Nothing else costs time.
std::vector<ShownPicture> simulate(const CostOf &costOf, const SimulatedMachine &machine, double from,
                                   double to);

// A scene as it was played. Pictures belong to the scene at their own time.
struct PlayedScene {
    int scene;
    double begin, seconds;      // its first second in the list, and its time there, in all its shots
    int traced, between, shown; // numbers of pictures
    double level, width;        // means of the traced pictures
    double rate;                // instructions a second while pictures were made; 0: not known
};
// The scenes that a list shows, each once, in the order of their first shots, from `since` or its first
// picture to its last one.
std::vector<PlayedScene> summary(const std::vector<ShownPicture> &list, const CostOf &costOf,
                                 const SimulatedMachine &machine, double since = 0);
// The scenes as rows of a CSV, each preceded by `before`; the last column is in 10^9 instructions a second.
inline constexpr char kSummaryHead[] = "scene,begin,seconds,traced,between,shown,a_second,level,width,giga";
std::string printSummary(const std::vector<PlayedScene> &scenes, const std::string &before);

// For SimulatedMachine::rateAt: the instructions that the machine executed in each second of a list. Throws
// Refused if no picture was made in one.
std::function<double(double)> ratesOf(const std::vector<ShownPicture> &list, const CostOf &costOf,
                                      const SimulatedMachine &machine);

} // namespace odraz::measure
