// Plays through waveOut, which every Windows has, from a ring of buffers of one block each.
#include "host/sound.h"

#include "host/library.h"
#include "host/windows/calls.h"

namespace odraz {

using namespace windows;

namespace {

constexpr int kBuffers = 36; // 180 ms in all; Wine alone holds 100 ms
constexpr uint32_t kDone = 1;

struct Buffer {
    WaveHeader header;
    int16_t samples[2 * kDeviceBlock];
};

HANDLE theDevice; // belongs to the host: one process has one sound output
Buffer theBuffers[kBuffers];
int theNext;      // index of the buffer to fill
int64_t theTaken; // frames accepted since the device was opened
bool theLost;     // whether the device is gone

void close() {
    waveOutReset(theDevice);
    for (Buffer &b : theBuffers) waveOutUnprepareHeader(theDevice, &b.header, sizeof b.header);
    waveOutClose(theDevice);
}

bool open() {
    if (loadFunctions("winmm.dll", ODRAZ_WINMM(ODRAZ_NAME), odrazFunctions.winmm)) return false;
    WaveFormat format = {1 /* PCM */, 2, kDeviceRate, 4 * kDeviceRate, 4, 16, 0};
    if (waveOutOpen(&theDevice, ~0u /* the default device */, &format, nullptr, nullptr, 0)) return false;
    theNext = 0;
    theTaken = 0;
    theLost = false;
    for (Buffer &b : theBuffers) {
        b.header = {};
        b.header.data = b.samples;
        b.header.size = sizeof b.samples;
        if (waveOutPrepareHeader(theDevice, &b.header, sizeof b.header)) {
            close();
            return false;
        }
        b.header.flags |= kDone;
    }
    waveOutPause(theDevice); // until the ring is full, so that it does not run dry at once
    return true;
}

int write(const int16_t *samples, int frames) {
    int taken = 0;
    while (taken < frames && !theLost) {
        Buffer &b = theBuffers[theNext];
        if (!(__atomic_load_n(&b.header.flags, __ATOMIC_ACQUIRE) & kDone)) break;
        int n = frames - taken < kDeviceBlock ? frames - taken : kDeviceBlock;
        __builtin_memcpy(b.samples, samples + 2 * taken, (size_t)n * 4);
        b.header.size = (uint32_t)n * 4;
        b.header.flags &= ~kDone;
        if (waveOutWrite(theDevice, &b.header, sizeof b.header)) {
            theLost = true;
            break;
        }
        theNext = (theNext + 1) % kBuffers;
        taken += n;
    }
    if (theLost) {
        close();
        return -1;
    }
    if ((theTaken += taken) == kBuffers * kDeviceBlock) waveOutRestart(theDevice);
    return taken;
}

int64_t delay() {
    WaveTime time = {};
    time.kind = 2; // TIME_SAMPLES
    // With some drivers only this call fails when the device has been unplugged
    theLost |= waveOutGetPosition(theDevice, &time, sizeof time) != 0;
    if (time.kind != 2) return -1;
    return theTaken - time.samples;
}

} // namespace

const SoundOutput kSystemSound = {open, write, delay};
const char kNoSound[] = "no device: silence";

} // namespace odraz
