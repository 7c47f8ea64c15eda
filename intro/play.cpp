#include "play.h"

#include "host/clock.h"
#include "host/files.h"
#include "music.h"

namespace odraz {

namespace {

constexpr int kBins = 5000; // of a tenth of a millisecond
// Pictures a second that a viewer should see; a slot without a new one is a dropped frame.
constexpr int kSlots = 30;

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
    int shown, dropped;
    double samples; // of all pictures, in every pixel
    Histogram trace, present;
};

// Keeps up with the clock by moving between `film`, `play` and `draft`, below which nothing is shown.
// It moves a little every picture, by how far the last ones were from the time that they should take, so that
// nobody sees a step.
struct Governor {
    static constexpr float kWanted = 0.029f; // seconds a picture
    static constexpr QualityName kWay[] = {QualityName::Film, QualityName::Play, QualityName::Draft};
    static constexpr int kSteps = sizeof kWay / sizeof *kWay - 1;
    float level = 1;         // 0 .. kSteps along the way
    float average = kWanted; // of the last pictures, seconds

    Quality quality() const {
        int from = min((int)level, kSteps - 1);
        return between(kQualities[(int)kWay[from]], kQualities[(int)kWay[from + 1]], level - (float)from);
    }
    void spent(float seconds) {
        average += (seconds - average) * 0.25f;
        level = clamp(level + clamp(average / kWanted - 1, -0.5f, 1.f) * 0.08f, 0.1f, (float)kSteps);
    }
};

// Zero at the start
SceneStats theStats[kMaxScenes];
Music theMusic;

void printStats(double untilFirst) {
    Text<2048> t;
    (t << "first picture after ").decimal(untilFirst, 2) << " s\n";
    t << "scene      shown  dropped  trace ms: median    p95   present ms: median    p95   samples/pixel\n";
    for (int i = 0; i < kMaxScenes; ++i) {
        const SceneStats &s = theStats[i];
        if (!s.shown) continue;
        int line = t.size;
        (t << sceneName(i)).padTo(line + 11) << s.shown;
        t.padTo(line + 18) << s.dropped;
        t.padTo(line + 37).decimal(s.trace.quantile(0.5), 1);
        t.padTo(line + 44).decimal(s.trace.quantile(0.95), 1);
        t.padTo(line + 64).decimal(s.present.quantile(0.5), 1);
        t.padTo(line + 71).decimal(s.present.quantile(0.95), 1);
        t.padTo(line + 86).decimal(s.samples / s.shown, 2) << '\n';
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
    t << "(dropped: thirtieths of a second without a new picture)\n";
    writeAll(1, t.data, (size_t)t.size);
}

} // namespace

int play(Intro &intro, Sound *sound, const Options &o, FilmWindow &window, const int *leave, int64_t began) {
    const Quality &quality = o.qualityOr(QualityName::Play);
    double from = seconds(o.from), to = seconds(o.to);

    Governor governor;
    startMusic(theMusic, sound, from, leave);
    int64_t start = nanoseconds(), lastSlot = -1, firstShown = 0;
    for (;;) {
        int64_t before = nanoseconds();
        theMusic.clock.watch(before, processorNanoseconds());
        double time = theMusic.clock.at(before);
        if (time < from) time = from; // what is heard first is still on its way
        if (time >= to || __atomic_load_n(leave, __ATOMIC_RELAXED)) break;
        Picture p = picture(intro, time, o.quality == QualityName::Count ? governor.quality() : quality);
        if (__atomic_load_n(leave, __ATOMIC_RELAXED)) break;
        int64_t traced = nanoseconds();
        present(window, p.rgba, p.width, p.height);
        int64_t shown = nanoseconds();
        if (!firstShown) firstShown = shown;

        governor.spent((float)(shown - before) * 1e-9f);
        SceneStats &s = theStats[sceneAt(time)];
        int64_t slot = (int64_t)((double)(shown - start) * 1e-9 * kSlots);
        if (slot > lastSlot + 1 && lastSlot >= 0) s.dropped += (int)(slot - lastSlot - 1);
        lastSlot = slot;
        ++s.shown;
        s.samples += (double)samplesTaken(intro) / (p.width * p.height);
        s.trace.add(traced - before);
        s.present.add(shown - traced);
    }
    endMusic(theMusic);
    if (o.stats && firstShown) printStats((double)(firstShown - began) * 1e-9);
    return 0;
}

} // namespace odraz
