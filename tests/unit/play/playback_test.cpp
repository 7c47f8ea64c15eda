// Tests the film's clock and its sound on devices that work, drift, stop, fail, lose sound and report wrong
// positions. Time is simulated.
#include "play/playback.h"

#include <deque>

using namespace odraz;

constexpr int64_t kMillisecond = 1000000, kSecond = 1000 * kMillisecond;

// A device with a buffer of some frames that plays at its own speed.
struct Device {
    int64_t holds = kSoundRate / 20; // frames that its buffer holds
    int64_t behind = 0;              // additional delay of the sound in frames, which it reports as queued
    double speed = 1;
    int64_t stops = -1, goesOn = -1, dies = -1, returns = -1; // times; -1: never
    bool there = true, swallows = false; // swallows: accepts everything, and plays nothing
    int64_t error = 0;                   // frames that it adds to its reported delay

    int64_t now = 0;
    double played = 0; // frames that are due now
    std::deque<int16_t> queue = {};
    struct PlayedFrame {
        int64_t when;
        int16_t value;
    };
    std::vector<PlayedFrame> record = {}; // the first sample of each frame
    int opened = 0;

    bool dead() const { return dies >= 0 && now >= dies && now < returns; }
    bool stopped() const { return stops >= 0 && now >= stops && now < goesOn; }
    void pass(int64_t until) {
        for (; now < until; now += kMillisecond / 4) {
            if (stopped() || dead()) continue;
            played += speed * kSoundRate / 4000;
            for (; played >= 1; played -= 1) {
                if (queue.empty()) continue;
                record.push_back({now + behind * kSecond / kSoundRate, queue.front()});
                queue.pop_front();
            }
        }
    }
};
static Device *theDevice;

const SoundOutput kFake = {[] { return ++theDevice->opened, theDevice->there && !theDevice->dead(); },
                           [](const int16_t *samples, int frames) {
                               Device &d = *theDevice;
                               if (d.dead()) {
                                   d.queue.clear();
                                   return -1;
                               }
                               if (d.stopped()) return 0;
                               if (d.swallows) return frames;
                               int taken = (int)std::min<int64_t>(frames, d.holds - (int64_t)d.queue.size());
                               for (int i = 0; i < taken; ++i) d.queue.push_back(samples[2 * i]);
                               return taken;
                           },
                           [] {
                               Device &d = *theDevice;
                               return d.swallows ? 0 : (int64_t)d.queue.size() + d.behind + d.error;
                           }};

// Every sample holds the number of its block plus 1.
struct Source {
    int64_t block = 0;
    int sought = 0;
    SoundSource table() {
        return {[](void *s, int64_t frame) {
                    ((Source *)s)->block = frame / kSoundBlock;
                    ++((Source *)s)->sought;
                },
                [](void *s, int16_t *samples) {
                    int64_t n = ((Source *)s)->block++ % 30000;
                    std::fill(samples, samples + 2 * kSoundBlock, (int16_t)(1 + n));
                },
                this};
    }
};

// Plays a film with a device. The film is updated 30 times a second.
struct Play {
    Device device;
    Source source;
    FilmClock clock = {};
    std::vector<double> film;         // the film's time at each millisecond
    int64_t frozen = -1, thawed = -1; // moments at which the process is stopped, and continued
    int64_t pauses = -1, goesOn = -1; // moments at which the viewer pauses, and continues
    int64_t mutes = -1, unmutes = -1; // moments at which the viewer mutes the sound, and hears it again

    // Plays for `length`. Returns the errors between sound and film, in milliseconds, of all frames played at
    // full loudness between two moments.
    std::vector<double> run(int64_t length, int64_t from, int64_t to, double begin = 0) {
        theDevice = &device;
        Playback player = {};
        player.prepare(source.table(), kFake, clock, begin);
        int64_t wake = 0, picture = 0;
        for (int64_t now = kMillisecond; now < length; now += kMillisecond) {
            device.pass(now);
            if (now < frozen || now >= thawed || frozen < 0) {
                if (now >= 300 * kMillisecond && !clock.started()) clock.start(begin, now);
                bool paused = now >= pauses && now < goesOn;
                player.pause(paused);
                player.mute(now >= mutes && now < unmutes);
                if (paused) clock.start(film.back(), now);
                if (now >= picture && clock.started()) {
                    clock.watch(now, now - (frozen >= 0 && now >= thawed ? thawed - frozen : 0));
                    picture = now + 33 * kMillisecond;
                }
                for (int steps = 0; now >= wake && steps < 1000; ++steps)
                    if (int64_t nap = player.step(now)) wake = now + nap;
            }
            film.push_back(clock.started() ? clock.at(now) : begin);
        }
        std::vector<double> off;
        for (const Device::PlayedFrame &f : device.record) {
            if (f.when < from || f.when >= to || f.value < 1) continue;
            double shown = film[std::min(film.size() - 1, (size_t)(f.when / kMillisecond))];
            off.push_back(std::fabs((f.value - 1) * 5.0 + 2.5 - shown * 1e3));
        }
        return off;
    }
    // Whether silence was played between two moments.
    bool silent(int64_t from, int64_t to) const {
        return std::none_of(device.record.begin(), device.record.end(), [=](const Device::PlayedFrame &f) {
            return f.when > from && f.when < to && f.value;
        });
    }
    // Returns the largest difference of the film's speed from 1, over a tenth of a second.
    double unsteady() const {
        double most = 0;
        for (size_t i = 400; i + 100 < film.size(); ++i)
            most = std::max(most, std::fabs((film[i + 100] - film[i]) * 10 - 1));
        return most;
    }
};
static double largest(const std::vector<double> &off) {
    return off.empty() ? 1e9 : *std::max_element(off.begin(), off.end());
}

// Sound and film stay together. The film's speed changes by 1.5 % at most, which no viewer notices.
TEST(Playback, FilmFollowsItsDevice) {
    const struct {
        const char *what;
        Device device;
        int from, to; // seconds in which sound and film are compared
        double off;   // milliseconds
    } kCases[] = {
        {"exact", {}, 1, 60, 8},
        {"slow", {.speed = 0.998}, 1, 60, 8},
        {"fast", {.speed = 1.002}, 1, 60, 8},
        {"a little behind", {.behind = 1000}, 2, 20, 20},
        {"behind", {.behind = 5000}, 2, 20, 20},
        {"far behind", {.behind = 9000}, 2, 20, 20},
        {"stops", {.stops = 5 * kSecond, .goesOn = 7 * kSecond}, 9, 20, 20},
        {"dies", {.dies = 5 * kSecond, .returns = 8 * kSecond}, 10, 20, 20},
    };
    for (const auto &c : kCases) {
        SCOPED_TRACE(c.what);
        Play p;
        p.device = c.device;
        std::vector<double> off = p.run(c.to * kSecond, c.from * kSecond, c.to * kSecond);
        EXPECT_LT(largest(off), c.off);
        EXPECT_GT(off.size(), (c.to - c.from - 0.2) * kSoundRate);
        EXPECT_LT(p.unsteady(), 0.015);
        EXPECT_EQ(p.device.opened > 1, c.device.dies >= 0); // a dead device is opened again
        EXPECT_LE(p.device.opened, 6);
        if (c.to < 60) continue;
        EXPECT_NEAR(p.film.back(), 60 * c.device.speed, 0.1); // the whole film, a little later
        EXPECT_EQ(p.source.sought, 0);
    }
}

TEST(Playback, BeginsInTheMiddle) {
    Play p;
    std::vector<double> off = p.run(10 * kSecond, kSecond, 10 * kSecond, 100);
    EXPECT_LT(largest(off), 8);
    EXPECT_GT(off.size(), 8.9 * kSoundRate);
}

TEST(Playback, PlaysWithoutADevice) {
    Play p;
    p.device.there = false;
    p.run(10 * kSecond, 0, 0);
    EXPECT_NEAR(p.film.back(), 9.7, 0.01);
    EXPECT_LT(p.unsteady(), 1e-3);
    EXPECT_LE(p.device.opened, 11);
}

TEST(Playback, ADeviceThatSwallowsIsPaced) {
    Play p;
    p.device.swallows = true;
    p.run(10 * kSecond, 0, 0);
    EXPECT_NEAR((double)p.source.block * 0.005, 10.2, 0.1);
    EXPECT_LT(p.unsteady(), 1e-3);
    EXPECT_EQ(p.source.sought, 0);
}

TEST(Playback, AWrongPositionIsIgnored) {
    Play p;
    p.device.error = 44 * kSoundRate;
    p.run(10 * kSecond, 0, 0);
    EXPECT_LT(p.unsteady(), 0.015);
}

TEST(Playback, AStoppedFilmGoesOnWhereItStopped) {
    Play p;
    p.frozen = 5 * kSecond;
    p.thawed = 9 * kSecond;
    EXPECT_LT(largest(p.run(20 * kSecond, 11 * kSecond, 20 * kSecond)), 20);
    EXPECT_NEAR(p.film.back(), 16, 0.2);
}

TEST(Playback, StopsWhileTheViewerPauses) {
    Play p;
    p.pauses = 5 * kSecond;
    p.goesOn = 9 * kSecond;
    EXPECT_LT(largest(p.run(20 * kSecond, 10 * kSecond, 20 * kSecond)), 20);
    EXPECT_NEAR(p.film.back(), 16, 0.5);
    EXPECT_EQ(p.film[8900], p.film[5100]);
    EXPECT_TRUE(p.silent(5100 * kMillisecond, 9 * kSecond));
}

TEST(Playback, FollowsADeviceWhileItIsMuted) {
    Play p;
    p.device.speed = 0.998;
    p.mutes = 5 * kSecond;
    p.unmutes = 55 * kSecond;
    EXPECT_LT(largest(p.run(60 * kSecond, 55100 * kMillisecond, 60 * kSecond)), 8);
    EXPECT_LT(p.unsteady(), 0.015);
    EXPECT_EQ(p.source.sought, 0);
    EXPECT_TRUE(p.silent(5100 * kMillisecond, p.unmutes));
}
