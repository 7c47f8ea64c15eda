// The film as a page: what its scripts (host/web/) call, with numbers and addresses alone.
//
// Every worker has an instance of this program, in a memory of its own: those that trace pictures, the one
// that solves the hall's light, whose memory is then copied to these, and the one that makes music. The page
// has an instance, too, for the film's clock and for the plan of which pictures are made: by the governor, as
// player.h does.
#include "host/web/gl.h"
#include "inside.h"
#include "output/output.h"
#include "play/governor.h"
#include "play/statistics.h"

using namespace odraz;

#define EXPORT(name) extern "C" __attribute__((export_name(#name), used))

extern "C" __attribute__((import_module("env"), import_name("progress"))) void progress(float done);

namespace {

Intro *theIntro;
Workers theWorkers;
Sound *theSound;
Governor theGovernor;
FilmClock theClock;
Statistics theStatistics;
char thePrinted[4096];

// Fresh memory, which is zero; null if there is none.
unsigned char *grow(size_t bytes) {
    size_t pages = (bytes + 65535) >> 16, was = __builtin_wasm_memory_grow(0, pages);
    return was == ~(size_t)0 ? nullptr : (unsigned char *)(was << 16);
}

int64_t nanosecondsOf(double milliseconds) { return (int64_t)(milliseconds * 1e6); }

} // namespace

// --- Pictures ---

// Null, or a line that says what is missing.
EXPORT(load) const char *loadFilm(int width, int height, int hall) {
    IntroSettings settings = {width, height};
    size_t bytes = memoryNeeded(settings, 1, hall);
    Arena arena = {grow(bytes), bytes, 0};
    if (!arena.base) return "there is not enough memory";
    theWorkers = serialWorkers();
    static Gl gl;
    if (hall) fillGl(gl);
    const char *wrong = load(theIntro, settings, arena, theWorkers, hall ? &gl : nullptr,
                             {[](float done, void *) { progress(done); }, nullptr});
    if (!hall || wrong) return wrong;
    clearScratch(*theIntro->film.hall);
    return nullptr;
}
EXPORT(picture) uint8_t *pictureAt(double seconds, float level, int width, int height) {
    Governor g;
    g.coarseness = level;
    return picture(*theIntro, 0, seconds, g.quality(), nullptr, {width, height}).rgba;
}
EXPORT(samples) int samplesOf() { return (int)samplesTaken(*theIntro); }

// --- Music ---

// The next `blocks` of music, 0 .. 200: left and right in turn.
EXPORT(sound) float *music(int blocks) {
    static float out[200 * 2 * kSoundBlock];
    for (int i = 0; i < blocks; ++i) soundBlock(*theSound, out + (size_t)i * 2 * kSoundBlock);
    return out;
}
EXPORT(seek) int seek(int block) {
    size_t bytes = soundMemory() + 64;
    Arena arena = {grow(bytes), bytes, 0};
    theSound = arena.base ? loadSound(arena) : nullptr;
    if (theSound && block) seekSound(*theSound, block);
    return theSound != nullptr;
}

// --- The page's own: the film, its clock, and the plan ---

EXPORT(duration) double durationOf() { return duration(); }
// Whether a picture at this time needs the hall's light.
EXPORT(lit) int lit(double seconds) { return needsHall(seconds, seconds + 1e-3); }

// Times are seconds of the film, and milliseconds of the page's clock.
EXPORT(start) void start(double seconds, double now) { theClock.start(seconds, nanosecondsOf(now)); }
EXPORT(correct) void correct(double seconds, double now) { theClock.correct(seconds, nanosecondsOf(now)); }
EXPORT(at) double at(double now) { return theClock.at(nanosecondsOf(now)); }

// The picture that a worker makes next.
namespace {
struct Planned {
    double time, level, width, height;
} thePlanned;
double theNext; // the last time planned; the first one to plan at the start
bool theBegun;

// The fewest pixels across that are traced, in every scene. A browser takes twice the time of the film, and
// too few pictures look worse than too few pixels.
constexpr int kLeastWidth = 480;

// No in-betweens are made: each takes two thirds of the time of a traced picture, and every worker would
// trace a picture of its neighbour again. So there are 60 traced pictures a second, or 30: the governor's
// pairs, whose in-betweens take no time.
Pace paceHere(int scene) {
    Pace p = paceOf(scene);
    p.leastWidth = min(p.leastWidth, kLeastWidth);
    p.penalty[Governor::kPairs] = p.penalty[Governor::kThirty];
    for (int c = Governor::kPairs + 1; c < kCadences; ++c) p.penalty[c] = 1e9f;
    return p;
}
} // namespace

EXPORT(begin) void begin(double from, int width, int height) {
    theGovernor = {};
    theGovernor.width = width, theGovernor.height = height;
    theNext = from;
    theBegun = false;
}
// Plans the next picture, if the film is at `now` seconds and that many workers trace pictures.
EXPORT(plan) const Planned *plan(double now, int workers) {
    Governor &g = theGovernor;
    int scene = sceneAt(theNext + g.step());
    g.enter(scene, paceHere(scene));
    if (theBegun) {
        // A worker takes as many times longer as there are workers
        double soonest = now + g.tracing * (float)workers - Governor::kTolerance;
        for (theNext += g.step(); theNext < soonest;) theNext += Governor::kSixtieth;
    }
    theBegun = true;
    TracedSize size = g.size();
    thePlanned = {theNext, g.level(), (double)size.width, (double)size.height};
    return &thePlanned;
}
// One of `workers` workers took `trace` seconds for a picture.
EXPORT(spent) void spent(double trace, int workers) {
    theGovernor.spent((float)trace / (float)workers, 0, 1);
}

// --- Statistics ---

// A picture was shown: it took `trace` milliseconds, and `present` to show.
EXPORT(shown)
void shown(double seconds, double trace, double present, double samples, int width, int missed) {
    SceneStatistics &s = theStatistics.scenes[sceneAt(seconds)];
    ++s.shown, ++s.traced;
    s.missed += missed;
    s.present.add(nanosecondsOf(present));
    s.samples += samples;
    s.width += width;
    s.trace.add(nanosecondsOf(trace));
}
EXPORT(statistics) const char *statisticsText(double untilFirst) {
    printStatistics(theStatistics, theClock, untilFirst);
    return thePrinted;
}
int odraz::writeOutput(const char *, const void *data, size_t size) {
    __builtin_memcpy(thePrinted, data, size);
    thePrinted[size] = 0;
    return 0;
}
