#include "play/player.h"

#include "base/maths.h"
#include "host/clock.h"
#include "host/process.h"
#include "host/threads.h"
#include "play/music.h"
#include "play/schedule.h"
#include "play/statistics.h"

namespace odraz {

namespace {

constexpr int64_t kNap = 500000; // nanoseconds

// Plays the film. It makes the pictures on a separate thread. All members are zero at the start.
struct Player {
    Intro *intro;
    const Options *options;
    const int *leave;
    double from, to;     // seconds of the film: pictures are made from here on
    bool stopped, ended; // no more pictures shall be made; all are made
    Queue queue;
    Statistics statistics;
    Music music;

    bool leaves() const { return __atomic_load_n(leave, __ATOMIC_RELAXED); }

    bool stops() const { return __atomic_load_n(&stopped, __ATOMIC_RELAXED) || leaves(); }

    bool goesOn(double time) const { return time < to && !stops(); }
    int64_t now() const { return nanoseconds(); }
    double filmAt(int64_t now) const {
        return music.clock.started() ? music.clock.at(now) : Governor::kNotBegun;
    }
    int sceneOf(double time) const { return sceneAt(time); }
    double startOf(double time) const { return shotStart(time); }
    Pace paceOf(int scene) const { return odraz::paceOf(scene); }
    void trace(FinishedPicture &m, int slot, const Governor &governor) {
        m.picture = picture(*intro, slot, m.time,
                            options->quality == QualityName::Count ? governor.quality()
                                                                   : options->qualityOr(QualityName::Play),
                            nullptr, m.size = governor.size());
        if (!m.size.width) m.size = {m.picture.width, m.picture.height};
        m.level = governor.level();
        m.samples = (float)samplesTaken(*intro) / (float)(m.size.width * m.size.height);
    }
    void between(FinishedPicture &m, int earlier, int later, double share, int buffer) {
        m.picture = odraz::between(*intro, earlier, later, share, buffer);
    }
    unsigned add(const FinishedPicture &m) { return queue.add(m); }
    void await(unsigned number) const {
        while (!queue.removed(number) && !stops()) sleepFor(kNap);
    }

    // Makes pictures from this time on. All others are forgotten.
    void seek(double time) {
        __atomic_store_n(&stopped, true, __ATOMIC_RELAXED);
        while (!__atomic_load_n(&ended, __ATOMIC_ACQUIRE) && !leaves()) sleepFor(kNap);
        from = time;
        queue.made = queue.shown = 0;
        statistics.sixtieth = 0;
        stopped = false;
        __atomic_store_n(&ended, false, __ATOMIC_RELEASE);
    }
};

[[gnu::force_align_arg_pointer]] void *make(void *player) {
    Player &p = *(Player *)player;
    Governor governor;
    const Options &o = *p.options;
    if (o.quality == QualityName::Count && !o.sized) governor.width = o.width, governor.height = o.height;
    for (;;) {
        makePictures(p, governor, p.from);
        __atomic_store_n(&p.ended, true, __ATOMIC_RELEASE);
        while (__atomic_load_n(&p.ended, __ATOMIC_ACQUIRE)) sleepFor(kNap);
    }
}

} // namespace

int play(Intro &intro, Sound *sound, const Options &o, FilmWindow &window, const int *leave, int64_t began,
         const Recorder *recorder) {
    double from = seconds(o.from), to = seconds(o.to);
    static Player p; // too large for the stack
    p.intro = &intro, p.options = &o, p.leave = leave, p.from = from, p.to = to;
    if (startThread(make, &p)) {
        Message m;
        m << "no thread to trace on: " << kMoreThreads;
        return showError(m.data);
    }

    // The film and its sound begin when the first pictures are ready
    auto mustWait = [] {
        return p.queue.ready() < Queue::kAhead && !__atomic_load_n(&p.ended, __ATOMIC_ACQUIRE);
    };
    while (mustWait() && !p.leaves()) sleepFor(kNap);
    startMusic(p.music, sound, from, leave);
    int64_t firstShown = 0;
    unsigned drawn = 0; // number of events when it was drawn last
    for (double time = from;;) {
        int64_t before = nanoseconds();
        p.music.clock.watch(before, processorNanoseconds());
        unsigned events = __atomic_load_n(&window.events, __ATOMIC_RELAXED);
        // The film stands while it is paused, and after a seek until pictures are ready
        bool still = isOn(window, kPause) || mustWait();
        p.music.playback.pause(still);
        p.music.playback.mute(isOn(window, kMute));
        if (still)
            p.music.clock.start(time, before);
        else
            time = p.music.clock.at(before);
        if (time < p.from) time = p.from; // the first sound is not heard yet
        bool over = time >= to;
        if (p.leaves() || (over && !isOn(window, kLoop))) break;
        auto taken = [&](Action key) {
            return __atomic_exchange_n(&window.presses[key], 0, __ATOMIC_RELAXED);
        };
        int seek = taken(kAhead) - taken(kBack);
        if (over || seek) {
            time += 5 * seek;
            if (time > to - 1) time = to - 1;
            if (over || time < from) time = from;
            p.seek(time);
            continue;
        }
        Queue::Action action = p.queue.action(time);
        if (action == Queue::kWait) {
            if (still && events != drawn) present(window, nullptr, o.width, o.height);
            drawn = events;
            sleepFor(kNap);
            continue;
        }
        const FinishedPicture &m = p.queue.first();
        int64_t presenting = -1;
        if (action == Queue::kShow) {
            present(window, m.picture.rgba, m.picture.width, m.picture.height);
            int64_t shown = nanoseconds();
            if (!firstShown) firstShown = shown;
            presenting = shown - before;
        }
        if (recorder)
            recorder->record(recorder->context, m,
                             action == Queue::kShow ? p.music.clock.at(nanoseconds()) : -1);
        p.statistics.add(m, time - from, presenting);
        p.queue.remove();
    }
    endMusic(p.music);
    return o.stats && firstShown
               ? printStatistics(p.statistics, p.music.clock, (double)(firstShown - began) * 1e-9)
               : 0;
}

} // namespace odraz
