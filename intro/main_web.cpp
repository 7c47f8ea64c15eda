// The film as a page: the functions that its scripts (host/web/) call. They pass only numbers and addresses.
//
// Each worker has an instance of this program, with separate memory: the workers that trace pictures, the one
// that solves the hall's light, whose memory is then copied to the tracing ones, and the one that makes
// music. The page has another instance, for the film's clock and its player.
#include "inside.h"
#include "output/output.h"
#include "play/page_player.h"
#include "play/statistics.h"

using namespace odraz;

#define EXPORT(name) extern "C" __attribute__((export_name(#name), used))

extern "C" __attribute__((import_module("env"), import_name("progress"))) void progress(float done);

namespace {

Intro *theIntro;
Workers theWorkers;
Sound *theSound;
FilmClock theClock;
Statistics theStatistics;
char thePrinted[4096];

// Returns new memory, zeroed; null if there is not enough.
unsigned char *grow(size_t bytes) {
    size_t pages = (bytes + 65535) >> 16, was = __builtin_wasm_memory_grow(0, pages);
    return was == ~(size_t)0 ? nullptr : (unsigned char *)(was << 16);
}

int64_t nanosecondsOf(double milliseconds) { return (int64_t)(milliseconds * 1e6); }

} // namespace

// --- Pictures ---

// Returns null, or a line that says what is missing.
EXPORT(load) const char *loadFilm(int width, int height, int hall) {
    IntroSettings settings = {width, height};
    settings.hall = hall;
    size_t bytes = memoryNeeded(settings, 1);
    Arena arena = {grow(bytes), bytes, 0};
    if (!arena.base) return "not enough memory";
    // Zero it, so that copies of the memory pack well
    arena.giveBack = [](void *memory, size_t count) { __builtin_memset(memory, 0, count); };
    theWorkers = serialWorkers();
    return load(theIntro, settings, arena, theWorkers, kTracedHemicubes, nullptr,
                {[](float done, void *) { progress(done); }, nullptr});
}
EXPORT(picture) uint8_t *pictureAt(double seconds, float level, int width, int height) {
    Governor g;
    g.coarseness = level;
    return picture(*theIntro, 0, seconds, g.quality(), nullptr, {width, height}).rgba;
}
EXPORT(samples) int samplesOf() { return (int)samplesTaken(*theIntro); }

// --- Music ---

// Returns the next `blocks` of music, 0 .. 200: samples of the left and the right side alternate.
EXPORT(sound) float *music(int blocks) {
    static float out[200 * 2 * kSoundBlock];
    for (int i = 0; i < blocks; ++i) soundBlock(*theSound, out + (size_t)i * 2 * kSoundBlock);
    return out;
}
EXPORT(rate) int rate() { return kSoundRate; }
EXPORT(block) int blockSize() { return kSoundBlock; }
// Moves to a block of the film. Returns 0 if there is not enough memory.
EXPORT(seek) int seek(int block) {
    if (!theSound) {
        size_t bytes = soundMemory() + 64;
        Arena arena = {grow(bytes), bytes, 0};
        theSound = arena.base ? loadSound(arena) : nullptr;
    }
    if (theSound) seekSound(*theSound, block);
    return theSound != nullptr;
}

// --- The page's instance: the film's clock and its player ---

EXPORT(duration) double durationOf() { return duration(); }

// `seconds` are the film's time, `now` is in milliseconds of the page's clock.
EXPORT(start) void start(double seconds, double now) { theClock.start(seconds, nanosecondsOf(now)); }
EXPORT(correct) void correct(double seconds, double now) { theClock.correct(seconds, nanosecondsOf(now)); }
EXPORT(at) double at(double now) { return theClock.at(nanosecondsOf(now)); }

namespace {
struct PageFilm {
    Traceable hall; // Now if the hall's light is solved
    bool goesOn(double time) const { return time < duration(); }
    int sceneOf(double time) const { return sceneAt(time); }
    double startOf(double time) const { return shotStart(time); }
    Pace paceOf(int scene) const { return pageOf(odraz::paceOf(scene)); }
    Traceable traceable(double time) const { return needsHall(time, time + 1e-3) ? hall : Traceable::Now; }
} theFilm;
Queue theQueue; // not in thePlayer, so that it is zero at the start and takes no bytes
PagePlayer<PageFilm> thePlayer = {&theFilm, &theQueue, 1};
} // namespace

// Returns the number of workers that trace pictures.
EXPORT(workers) int workersOf(int cores) { return pageWorkers(cores); }
// Begins, or seeks: all pictures planned before are forgotten.
EXPORT(begin) void begin(double from, int width, int height, int workers) {
    thePlayer.workers = workers;
    thePlayer.begin(from, width, height);
    theStatistics.sixtieth = 0;
}
EXPORT(hall) void hall(int traceable) { theFilm.hall = (Traceable)traceable; }
EXPORT(can) int can(double seconds) { return (int)theFilm.traceable(seconds); }
// Returns the next picture to trace, when the film is at `now` seconds: time, level, width, height; or null.
EXPORT(plan) const double *plan(double now) {
    static double planned[4];
    if (!thePlayer.next(now)) return nullptr;
    TracedSize size = thePlayer.governor.size();
    planned[0] = thePlayer.time, planned[1] = thePlayer.governor.level();
    planned[2] = size.width, planned[3] = size.height;
    return planned;
}
// Accepts a picture that plan() returned and a worker traced in `trace` seconds.
EXPORT(traced) void traced(double time, float trace, float samples, int width) {
    thePlayer.traced({{}, time, trace, 0, samples, {width, 0}, 0});
}
EXPORT(ready) float ready() { return thePlayer.ready(); }
// Returns the time of the picture to show at this refresh, when the film is at `now` seconds; -1: none.
EXPORT(due) double due(double now) {
    const FinishedPicture *due = thePlayer.due(now);
    return due ? due->time : -1;
}
// Reports that this picture was shown, `at` seconds after the film's beginning, in `present` milliseconds.
EXPORT(shown) void shown(double at, double present) {
    theStatistics.add(theQueue.first(), at, nanosecondsOf(present));
    theQueue.remove();
}

// --- Statistics ---

EXPORT(statistics) const char *statisticsText(double untilFirst) {
    printStatistics(theStatistics, theClock, untilFirst);
    return thePrinted;
}
int odraz::writeOutput(const char *, const void *data, size_t size) {
    __builtin_memcpy(thePrinted, data, size);
    thePrinted[size] = 0;
    return 0;
}
