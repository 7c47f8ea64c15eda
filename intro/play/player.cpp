#include "play/player.h"

#include "host/clock.h"
#include "host/process.h"
#include "host/threads.h"
#include "play/governor.h"
#include "play/music.h"
#include "play/statistics.h"

namespace odraz {

namespace {

// Pictures a second that a viewer should see; a sixtieth of a second without a new one counts as missed.
constexpr int kScreenRate = 60;
constexpr int64_t kNap = 500000; // nanoseconds

// A picture on its way from the thread that traces to the one that shows.
struct Made {
    Picture picture;
    double time;
    float trace, make; // seconds that this took, or 0
    float samples;     // per pixel
};

struct Player {
    Intro *intro;
    const Options *options;
    const int *leave;
    // Numbers of pictures since the start, in the order in which they are shown. Traced ones are in the two
    // slots in turn
    unsigned made, shown;
    bool ended; // no more are made
    Made ring[4];

    bool leaves() const { return __atomic_load_n(leave, __ATOMIC_RELAXED); }
    unsigned ready() const { return __atomic_load_n(&made, __ATOMIC_ACQUIRE); }
    void add(const Made &m) {
        ring[made % 4] = m;
        __atomic_store_n(&made, made + 1, __ATOMIC_RELEASE);
    }
    // Waits until that many pictures have been shown.
    void await(unsigned number) const {
        while ((int)(__atomic_load_n(&shown, __ATOMIC_ACQUIRE) - number) < 0 && !leaves()) sleepFor(kNap);
    }
};

// Zero at the start
Statistics theStatistics;
Music theMusic;
Player thePlayer;

// Traces the film ahead of its clock, which is possible because the film is scripted.
[[gnu::force_align_arg_pointer]] void *make(void *) {
    Player &p = thePlayer;
    const Options &o = *p.options;
    Governor governor;
    // How many pictures must have been shown before each slot, and the frame of in-betweens, may be used
    // again
    unsigned until[2] = {}, untilBetween = 0;
    double time = seconds(o.from), to = seconds(o.to), last = time;
    for (int n = 0; time < to && !p.leaves(); ++n) {
        int slot = n & 1;
        p.await(until[slot]);
        int64_t began = nanoseconds();
        Made m = {};
        m.time = time;
        m.picture =
            picture(*p.intro, slot, time,
                    o.quality == QualityName::Count ? governor.quality() : o.qualityOr(QualityName::Play));
        int64_t traced = nanoseconds(), waited = traced, ended = traced;
        m.samples = (float)samplesTaken(*p.intro) / (float)(m.picture.width * m.picture.height);
        m.trace = (float)(traced - began) * 1e-9f;
        governor.enter(sceneAt(time));
        if (n && governor.pairs()) {
            p.await(untilBetween);
            waited = nanoseconds();
            Made b = {};
            b.time = time - (time - last) * 0.5;
            b.picture = between(*p.intro, !slot, slot);
            ended = nanoseconds();
            b.make = (float)(ended - waited) * 1e-9f;
            p.add(b);
            untilBetween = p.made;
        }
        p.add(m);
        until[slot] = p.made;
        governor.spent(m.trace, (float)(ended - waited) * 1e-9f);
        last = time;
        time = governor.next(time, theMusic.clock.started() ? theMusic.clock.at(ended) : Governor::kNotBegun);
    }
    __atomic_store_n(&p.ended, true, __ATOMIC_RELEASE);
    return nullptr;
}

} // namespace

int play(Intro &intro, Sound *sound, const Options &o, FilmWindow &window, const int *leave, int64_t began) {
    double from = seconds(o.from), to = seconds(o.to);
    Player &p = thePlayer;
    p.intro = &intro, p.options = &o, p.leave = leave;
    if (startThread(make, nullptr)) {
        Message m;
        m << "no thread to trace on: " << kMoreThreads;
        return refuse(m.data);
    }

    // The film and its sound begin when the first pictures are ready
    while (p.ready() < 3 && !__atomic_load_n(&p.ended, __ATOMIC_ACQUIRE) && !p.leaves()) sleepFor(kNap);
    startMusic(theMusic, sound, from, leave);
    int64_t start = nanoseconds(), lastSixtieth = -1, firstShown = 0;
    for (;;) {
        int64_t before = nanoseconds();
        theMusic.clock.watch(before, processorNanoseconds());
        double time = theMusic.clock.at(before);
        if (time < from) time = from; // what is heard first is still on its way
        if (time >= to || p.leaves()) break;
        unsigned ready = p.ready();
        const Made &m = p.ring[p.shown % 4];
        if (ready == p.shown || m.time > time) {
            sleepFor(kNap);
            continue;
        }
        SceneStatistics &s = theStatistics.scenes[sceneAt(m.time)];
        // If several pictures' time has come, show only the last
        if (ready - p.shown < 2 || p.ring[(p.shown + 1) % 4].time > time) {
            present(window, m.picture.rgba, m.picture.width, m.picture.height);
            int64_t shown = nanoseconds();
            if (!firstShown) firstShown = shown;
            int64_t sixtieth = (int64_t)((double)(shown - start) * 1e-9 * kScreenRate);
            if (sixtieth > lastSixtieth + 1 && lastSixtieth >= 0)
                s.missed += (int)(sixtieth - lastSixtieth - 1);
            lastSixtieth = sixtieth;
            ++s.shown;
            s.present.add(shown - before);
        }
        if (m.trace > 0) {
            ++s.traced;
            s.samples += m.samples;
            s.trace.add((int64_t)(m.trace * 1e9f));
        } else {
            ++s.between;
            s.make.add((int64_t)(m.make * 1e9f));
        }
        __atomic_store_n(&p.shown, p.shown + 1, __ATOMIC_RELEASE);
    }
    endMusic(theMusic);
    return o.stats && firstShown
               ? printStatistics(theStatistics, theMusic.clock, (double)(firstShown - began) * 1e-9)
               : 0;
}

} // namespace odraz
