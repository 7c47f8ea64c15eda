#include "play/music.h"

#include "host/clock.h"
#include "host/threads.h"
#include "output/samples.h"

namespace odraz {

namespace {

constexpr int64_t kMillisecond = 1000000;

void seek(void *context, int64_t frame) {
    Music &m = *(Music *)context;
    m.block = (int)(frame / kSoundBlock);
    seekSound(*m.sound, m.block);
}

void render(void *context, int16_t *samples) {
    Music &m = *(Music *)context;
    float block[2 * kSoundBlock];
    soundBlock(*m.sound, block);
    quantize(block, m.block++, samples);
}

[[gnu::force_align_arg_pointer]] void *playMusic(void *context) {
    for (Music &m = *(Music *)context;;)
        if (int64_t nap = m.playback.step(nanoseconds())) sleepFor(nap);
}

} // namespace

void startMusic(Music &m, Sound *sound, double from, const int *leave) {
    int64_t latest = nanoseconds() + 330 * kMillisecond;
    m.sound = sound;
    m.playback.prepare({seek, render, &m}, kSystemSound, m.clock, from);
    if (sound && !startThread(playMusic, &m))
        while (!m.clock.started() && nanoseconds() < latest && !__atomic_load_n(leave, __ATOMIC_RELAXED))
            sleepFor(kMillisecond);
    if (!m.clock.started()) m.clock.start(from, nanoseconds());
}

void endMusic(Music &m) {
    int64_t latest = nanoseconds() + 100 * kMillisecond;
    for (m.playback.pause(true); !m.playback.silence() && nanoseconds() < latest;) sleepFor(kMillisecond);
}

} // namespace odraz
