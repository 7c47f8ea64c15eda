#include "play/player.h"

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
    double to;  // seconds of the film
    bool ended; // no more pictures are made
    Queue queue;
    Statistics statistics;
    Music music;

    bool leaves() const { return __atomic_load_n(leave, __ATOMIC_RELAXED); }

    bool goesOn(double time) const { return time < to && !leaves(); }
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
        while (!queue.removed(number) && !leaves()) sleepFor(kNap);
    }
};

[[gnu::force_align_arg_pointer]] void *make(void *player) {
    Player &p = *(Player *)player;
    Governor governor;
    const Options &o = *p.options;
    if (o.quality == QualityName::Count && !o.sized) governor.width = o.width, governor.height = o.height;
    makePictures(p, governor, seconds(o.from));
    __atomic_store_n(&p.ended, true, __ATOMIC_RELEASE);
    return nullptr;
}

} // namespace

int play(Intro &intro, Sound *sound, const Options &o, FilmWindow &window, const int *leave, int64_t began,
         const Recorder *recorder) {
    double from = seconds(o.from), to = seconds(o.to);
    static Player p; // too large for the stack
    p.intro = &intro, p.options = &o, p.leave = leave, p.to = to;
    if (startThread(make, &p)) {
        Message m;
        m << "no thread to trace on: " << kMoreThreads;
        return showError(m.data);
    }

    // The film and its sound begin when the first pictures are ready
    while (p.queue.ready() < Queue::kAhead && !__atomic_load_n(&p.ended, __ATOMIC_ACQUIRE) && !p.leaves())
        sleepFor(kNap);
    startMusic(p.music, sound, from, leave);
    int64_t firstShown = 0;
    for (double time = from;;) {
        int64_t before = nanoseconds();
        p.music.clock.watch(before, processorNanoseconds());
        bool paused = __atomic_load_n(&window.paused, __ATOMIC_RELAXED);
        p.music.playback.pause(paused);
        if (paused) p.music.clock.start(time, before);
        time = p.music.clock.at(before);
        if (time < from) time = from; // the first sound is not heard yet
        if (time >= to || p.leaves()) break;
        Queue::Action action = p.queue.action(time);
        if (action == Queue::kWait) {
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
