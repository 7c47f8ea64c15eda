#include "play/playback.h"

#include "base/maths.h"

namespace odraz {

static_assert(kSoundRate == kDeviceRate && kSoundBlock == kDeviceBlock);

namespace {

constexpr int64_t kSecond = 1000000000, kNap = 2000000; // nanoseconds
// These limits are in frames. If the sound is off by more than kLate, it skips frames or waits; if it is off
// by more than kSeek, it seeks. A device that accepts everything and does not report its delay is kept kLead
// ahead of the film.
constexpr int64_t kLate = kSoundRate / 50, kSeek = kSoundRate, kLead = kSoundRate / 5;
constexpr float kFade = 0.5f; // change of the level in a block

} // namespace

void Playback::prepare(const SoundSource &what, const SoundOutput &where, FilmClock &by, double from) {
    source = what;
    output = where;
    clock = &by;
    position = begin = (int64_t)(from * kSoundRate);
    // The film's start needs neither a seek nor a fade-in
    sought = !begin;
    level = sought;
}

// Renders the next block, and fades to a level within it.
void Playback::fill(float to) {
    source.render(source.context, block);
    position += kSoundBlock;
    if (level != 1 || to != 1)
        for (int i = 0; i < 2 * kSoundBlock; ++i)
            block[i] = (int16_t)((float)block[i] * (level + (to - level) * (float)i * (0.5f / kSoundBlock)));
    level = to;
    quiet = 0;
}

// Makes a block of silence. Unless `still`, seeks to a frame of the film, or renders up to it if it is near.
void Playback::leap(int64_t frame, bool still) {
    int64_t off = frame - position;
    if (!still && (!sought || off > kSeek || off < -kSeek)) {
        position = frame - frame % kSoundBlock;
        source.seek(source.context, position);
        sought = true;
    }
    for (; !still && frame > position; position += kSoundBlock) source.render(source.context, block);
    for (int16_t &sample : block) sample = 0;
    quiet += kSoundBlock;
}

// Treats the device as lost, and lets it be opened again in a second.
int64_t Playback::lose(int64_t now) {
    opened = false;
    level = 0;
    held = left = 0;
    __atomic_store_n(&audible, false, __ATOMIC_RELEASE);
    openAt = now + kSecond;
    return kNap;
}

int64_t Playback::step(int64_t now) {
    // After a gap in calls of this function the film's clock may be wrong until FilmClock::watch() is called
    if (lastStep && now - lastStep > FilmClock::kGap) {
        doubt = true;
        watched = clock->watched();
    }
    lastStep = now;
    bool playing = clock->started(), still = __atomic_load_n(&paused, __ATOMIC_ACQUIRE);
    if (doubt && playing && clock->watched() == watched) return kNap;
    doubt = false;

    if (!opened) {
        if (now < openAt) return kNap;
        opened = output.open();
        if (!opened) return lose(now);
    }
    if (left) {
        int taken = output.write(block + 2 * (kSoundBlock - left), left);
        if (taken < 0) return lose(now);
        left -= taken;
        follow(now, left > 0);
        return taken ? 0 : kNap;
    }

    // Decide whether to leap. `off`: the frames by which the next block would be heard too late. Before the
    // film begins it is in time. If the device's delay is unknown, the block may be early
    int64_t film = playing ? (int64_t)(clock->at(now) * kSoundRate) : begin;
    int64_t off = playing ? film + held - position : 0;
    bool leaps = still || !sought || off > kLate || off < -(held ? kLate : kLead + kLate);
    if (!leaps && position - film > kLead) {
        if (!playing) clock->start((double)begin / kSoundRate, now);
        return kNap;
    }
    if (!leaps)
        fill(__atomic_load_n(&muted, __ATOMIC_RELAXED) ? max(level - kFade, 0.f) : min(level + kFade, 1.f));
    else if (level > 0)
        fill(max(level - kFade, 0.f));
    else
        leap(playing ? film + held : begin, still);
    left = kSoundBlock;
    return 0;
}

// Starts the clock once the device is full, and corrects it by what is heard.
void Playback::follow(int64_t now, bool full) {
    held = output.delay();
    if (held < 0) held = 0;
    double time = (double)(position - left - held) / kSoundRate;
    if (held && !clock->started() && full)
        clock->start(time, now);
    else if (held && clock->started() && !quiet && (level == 1 || level == 0))
        clock->correct(time, now);
    __atomic_store_n(&audible, quiet - left < held, __ATOMIC_RELEASE);
}

} // namespace odraz
