#include "play.h"

#include "dump.h"
#include "host/clock.h"
#include "host/process.h"
#include "host/threads.h"
#include "music.h"

namespace odraz {

namespace {

constexpr int kBins = 5000; // of a tenth of a millisecond
// Pictures a second that a viewer should see; a slot without a new one is missed.
constexpr int kSlots = 60;
constexpr int64_t kNap = 500000; // nanoseconds

struct Histogram {
    int count;
    int bins[kBins];

    void add(int64_t nanoseconds) {
        int64_t bin = nanoseconds / 100000;
        ++bins[bin < kBins ? bin : kBins - 1];
        ++count;
    }
    // The smallest time, in milliseconds, that a share of all stays within.
    double quantile(double share) const {
        int wanted = (int)(share * (double)count), seen = 0;
        for (int i = 0; i < kBins; ++i)
            if ((seen += bins[i]) > wanted) return i * 0.1;
        return 0;
    }
};

struct SceneStats {
    int traced, between, shown, missed;
    double samples; // of all traced pictures, in every pixel
    Histogram trace, make, present;
};

// Moves between `film`, `play` and `draft`: a little every picture, by how far the last ones were from the
// time that they should take, so that nobody sees a step. Sixty pictures a second are traced where they can
// be so at `play`; else thirty, and one between any two is made of them. Where even that is too much, fewer;
// and none between, until the next scene, where these take nearly as long as what is traced.
struct Governor {
    static constexpr QualityName kWay[] = {QualityName::Film, QualityName::Play, QualityName::Draft};
    static constexpr int kSteps = sizeof kWay / sizeof *kWay - 1;
    enum { kSixty, kPairs, kThirty } way = kPairs;
    float level = 1;                          // 0 .. kSteps along kWay
    float average = 0.029f, tracing = 0.029f; // seconds that the last pictures took, and those traced alone
    int scene = -1;

    bool pairs() const { return way == kPairs; }
    double step() const { return way == kSixty ? 1 / 60.0 : 1 / 30.0; }
    Quality quality() const {
        int from = min((int)level, kSteps - 1);
        return between(kQualities[(int)kWay[from]], kQualities[(int)kWay[from + 1]], level - (float)from);
    }
    void enter(int next) {
        if (scene != next && way == kThirty) way = kPairs;
        scene = next;
    }
    void spent(float trace, float make) {
        float wanted = way == kSixty ? 0.0145f : 0.029f;
        tracing += (trace - tracing) * 0.25f;
        average += (trace + make - average) * 0.25f;
        level = clamp(level + clamp(average / wanted - 1, -0.5f, 1.f) * 0.16f, 0.1f, (float)kSteps);
        bool late = pairs() && level == kSteps && average > 1.1f * wanted && average > 1.8f * tracing;
        if (pairs() ? level <= 1 && tracing < 0.014f : way == kSixty && level > 1.05f) {
            way = pairs() ? kSixty : kPairs;
            average = tracing;
        } else if (late) {
            way = kThirty;
            average = tracing;
        }
    }
};

// A picture on its way from the thread that traces to the one that shows.
struct Made {
    Picture picture;
    double time;
    float trace, make; // seconds that it took, or 0
    float samples;     // in every pixel
};

struct Player {
    Intro *intro;
    const Options *options;
    const int *leave;
    // Numbers of pictures since the start, in the order in which they are shown. Each lies in memory that is
    // used again for the second next traced one, or the next one between
    unsigned made, shown;
    bool ended; // no more are made
    Made ring[4];

    bool leaves() const { return __atomic_load_n(leave, __ATOMIC_RELAXED); }
    unsigned ready() const { return __atomic_load_n(&made, __ATOMIC_ACQUIRE); }
    void add(const Made &m) {
        ring[made % 4] = m;
        __atomic_store_n(&made, made + 1, __ATOMIC_RELEASE);
    }
    // Waits until all up to that number are shown.
    void await(unsigned number) const {
        while ((int)(__atomic_load_n(&shown, __ATOMIC_ACQUIRE) - number) < 0 && !leaves()) sleepFor(kNap);
    }
};

// Zero at the start
SceneStats theStats[kMaxScenes];
Music theMusic;
Player thePlayer;

// Traces the film ahead of its clock: it is scripted.
[[gnu::force_align_arg_pointer]] void *make(void *) {
    Player &p = thePlayer;
    const Options &o = *p.options;
    Governor governor;
    // How many must be shown before the memory of a traced picture, by turns, and of one between is free
    unsigned until[2] = {}, untilBetween = 0;
    double time = seconds(o.from), to = seconds(o.to), last = time;
    for (int n = 0; time < to && !p.leaves(); ++n) {
        p.await(until[n & 1]);
        int64_t began = nanoseconds();
        Made m = {};
        m.time = time;
        m.picture =
            picture(*p.intro, time,
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
            b.picture = pictureBetween(*p.intro);
            ended = nanoseconds();
            b.make = (float)(ended - waited) * 1e-9f;
            p.add(b);
            untilBetween = p.made;
        }
        p.add(m);
        until[n & 1] = p.made;
        governor.spent(m.trace, (float)(ended - waited) * 1e-9f);
        // What comes next must be there when its time comes; what is made from both, sooner
        last = time;
        time += governor.step();
        double soonest = theMusic.clock.started() ? theMusic.clock.at(ended) + governor.average +
                                                        (governor.pairs() ? 0.5 * governor.step() : 0)
                                                  : 0;
        if (time < soonest - 0.004) time = soonest;
    }
    __atomic_store_n(&p.ended, true, __ATOMIC_RELEASE);
    return nullptr;
}

int printStats(double untilFirst) {
    Text<2048> t;
    (t << "first picture after ").decimal(untilFirst, 2) << " s\n";
    t << "                                            trace ms        between ms      present ms\n"
         "scene      traced  between  shown  missed  median p95      median p95      median p95      "
         "samples/pixel\n";
    for (int i = 0; i < kMaxScenes; ++i) {
        const SceneStats &s = theStats[i];
        if (!s.shown) continue;
        int line = t.size;
        (t << sceneName(i)).padTo(line + 11) << s.traced;
        t.padTo(line + 19) << s.between;
        t.padTo(line + 28) << s.shown;
        t.padTo(line + 35) << s.missed;
        const Histogram *times[] = {&s.trace, &s.make, &s.present};
        for (int k = 0; k < 3; ++k) {
            t.padTo(line + 43 + 16 * k).decimal(times[k]->quantile(0.5), 1);
            t.padTo(line + 50 + 16 * k).decimal(times[k]->quantile(0.95), 1);
        }
        t.padTo(line + 91).decimal(s.samples / (s.traced + !s.traced), 2) << '\n';
    }
    // How far what was heard was from the film when the device told it
    const int *offs = theMusic.clock.offs;
    int count = 0, median = 0, most = 0, seen = 0;
    for (int i = 0; i < FilmClock::kOffs; ++i) count += offs[i];
    for (int i = 0; i < FilmClock::kOffs && count; ++i) {
        seen += offs[i];
        if (seen * 2 <= count) median = i + 1;
        if (seen * 20 <= count * 19) most = i + 1;
    }
    if (count) t << "sound off by ms: median below " << median + 1 << ", p95 below " << most + 1 << '\n';
    t << "(missed: sixtieths of a second without a new picture)\n";
    return writeOutput("-", t.data, (size_t)t.size);
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

    // The film begins when its first pictures are there, and its sound with it
    while (p.ready() < 3 && !__atomic_load_n(&p.ended, __ATOMIC_ACQUIRE) && !p.leaves()) sleepFor(kNap);
    startMusic(theMusic, sound, from, leave);
    int64_t start = nanoseconds(), lastSlot = -1, firstShown = 0;
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
        SceneStats &s = theStats[sceneAt(m.time)];
        // Of several whose time has come, the last
        if (ready - p.shown < 2 || p.ring[(p.shown + 1) % 4].time > time) {
            present(window, m.picture.rgba, m.picture.width, m.picture.height);
            int64_t shown = nanoseconds();
            if (!firstShown) firstShown = shown;
            int64_t slot = (int64_t)((double)(shown - start) * 1e-9 * kSlots);
            if (slot > lastSlot + 1 && lastSlot >= 0) s.missed += (int)(slot - lastSlot - 1);
            lastSlot = slot;
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
    return o.stats && firstShown ? printStats((double)(firstShown - began) * 1e-9) : 0;
}

} // namespace odraz
