// The film as a page: what its scripts (host/web/) call, with numbers and addresses alone.
//
// Every worker has an instance of this program, in a memory of its own: those that trace pictures, the one
// that solves the hall's light, whose memory is then copied to these, and the one that makes music. The page
// has an instance, too, for the film's clock and for the plan of which pictures are made: by the governor, as
// player.h does.
#include "base/for_tools.h"
#include "host/web/gl.h"
#include "inside.h"
#include "output/output.h"
#include "play/governor.h"
#include "play/statistics.h"

using namespace odraz;

const bool odraz::kForTools = false;

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
EXPORT(load) const char *loadFilm(int width, int height, int pairs, int hall) {
    IntroSettings settings = {width, height};
    settings.pairs = pairs;
    size_t bytes = memoryNeeded(settings, 1, hall);
    Arena arena = {grow(bytes), bytes, 0};
    if (!arena.base) return "there is not enough memory";
    theWorkers = serialWorkers();
    static Gl gl;
    if (hall) fillGl(gl);
    const char *wrong = load(theIntro, settings, arena, theWorkers, hall ? &gl : nullptr,
                             {[](float done, void *) { progress(done); }, nullptr});
    if (!hall || wrong) return wrong;
    // Clear what was needed for solving alone, so that copies of this memory are small
    Hall &solved = *theIntro->film.hall;
    unsigned char *from = (unsigned char *)solved.radiosity.factors.links;
    __builtin_memset(from, 0, (size_t)((unsigned char *)solved.gloss.matrices - from));
    return nullptr;
}
EXPORT(picture) uint8_t *pictureAt(int slot, double seconds, float level, int width, int height) {
    Governor g;
    g.coarseness = level;
    return picture(*theIntro, slot, seconds, g.quality(), nullptr, {width, height}).rgba;
}
EXPORT(between) uint8_t *betweenOf(int earlier, int later, double share) {
    return between(*theIntro, earlier, later, share).rgba;
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

// What a worker is to make next: `traced` pictures, `step` seconds apart, from `time` on, and between each
// and the one before it `between` in-betweens. `before` is the time of the picture before the first, which
// the worker may have to trace again; negative if there is none.
namespace {
struct Run {
    double time, step, before, between, traced, level, width, height;
} theRun;
double theNext; // the last picture planned; the first one to plan at the start
bool theBegun;

// Pictures in a run, where several workers make in-betweens. The picture before each run is traced twice, so
// longer runs cost less; but they need more pictures ahead.
constexpr int kRun = 3;
} // namespace

EXPORT(begin) void begin(double from, int width, int height) {
    theGovernor = {};
    theGovernor.width = width, theGovernor.height = height;
    theNext = from;
    theBegun = false;
}
// Plans the next run, if the film is at `now` seconds and pictures are traced by so many workers, with or
// without in-betweens.
EXPORT(plan) const Run *plan(double now, int workers, int pairs) {
    Governor &g = theGovernor;
    int scene = sceneAt(theNext + g.step());
    g.enter(scene, paceOf(scene));
    int count = pairs ? Governor::kInBetweens[g.cadence] : 0, traced = count && workers > 1 ? kRun : 1;
    double step = g.step(), time = theNext;
    if (theBegun) {
        // A worker takes as many times longer as there are workers. Its first picture must be in time, and
        // its last one
        float trace = g.tracing * (float)workers, make = g.making * (float)workers, first = trace, last = 0;
        if (count) {
            first += make + (float)(g.ahead(1) * Governor::kSixtieth);
            last = (float)traced * (trace + (float)count * make - (float)step) +
                   (float)(step + g.ahead(count) * Governor::kSixtieth);
        }
        double soonest = now + max(first, last) - Governor::kTolerance;
        for (time += step; time < soonest;) time += Governor::kSixtieth;
    }
    int gap = (int)((time - theNext) / Governor::kSixtieth + 0.5);
    bool joined = theBegun && count && g.between(gap);
    // It ends with the scene
    while (traced > 1 && sceneAt(time + (traced - 1) * step) != scene) --traced;
    TracedSize size = g.size();
    theRun = {time,           step,      joined ? theNext : -1, (double)count,
              (double)traced, g.level(), (double)size.width,    (double)size.height};
    theNext = time + (traced - 1) * step;
    theBegun = true;
    return &theRun;
}
// A run of so many pictures took these seconds to trace, for each picture, and to make in-betweens, for each
// of them.
EXPORT(spent) void spent(int traced, float trace, float make, int count, int workers) {
    for (int i = 0; i < traced; ++i) theGovernor.spent(trace / (float)workers, make / (float)workers, count);
}

// --- Statistics ---

// A picture was shown: it took `trace` or `make` milliseconds, and `present` to show.
EXPORT(shown)
void shown(double seconds, double trace, double make, double present, double samples, int width, int missed) {
    SceneStatistics &s = theStatistics.scenes[sceneAt(seconds)];
    ++s.shown;
    s.missed += missed;
    s.present.add(nanosecondsOf(present));
    if (trace > 0) {
        ++s.traced;
        s.samples += samples;
        s.width += width;
        s.trace.add(nanosecondsOf(trace));
    } else {
        ++s.between;
        s.make.add(nanosecondsOf(make));
    }
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
