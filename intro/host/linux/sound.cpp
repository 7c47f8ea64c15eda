// Plays through ALSA's library, which works with PipeWire, PulseAudio and bare hardware.
#include "host/sound.h"

#include "host/library.h"

// The declarations of alsa/asoundlib.h, so that this header is not needed to build the film.
struct _snd_pcm;
typedef struct _snd_pcm snd_pcm_t;
typedef long snd_pcm_sframes_t;
extern "C" {
int snd_pcm_open(snd_pcm_t **pcm, const char *name, int stream, int mode);
int snd_pcm_set_params(snd_pcm_t *pcm, int format, int access, unsigned channels, unsigned rate, int resample,
                       unsigned latency);
snd_pcm_sframes_t snd_pcm_writei(snd_pcm_t *pcm, const void *buffer, unsigned long frames);
int snd_pcm_delay(snd_pcm_t *pcm, snd_pcm_sframes_t *delay);
int snd_pcm_recover(snd_pcm_t *pcm, int error, int silent);
int snd_pcm_close(snd_pcm_t *pcm);
int snd_lib_error_set_handler(void (*handler)(const char *, int, const char *, int, const char *, ...));
}

namespace odraz {

namespace {

#define ODRAZ_ALSA(F)                                                                                        \
    F(snd_pcm_open)                                                                                          \
    F(snd_pcm_set_params)                                                                                    \
    F(snd_pcm_writei) F(snd_pcm_delay) F(snd_pcm_recover) F(snd_pcm_close) F(snd_lib_error_set_handler)

struct Alsa {
    ODRAZ_ALSA(ODRAZ_MEMBER)
};

Alsa theAlsa;
snd_pcm_t *thePcm; // belongs to the host: one process has one sound output

constexpr int kAgain = -11;          // EAGAIN
constexpr unsigned kLatency = 50000; // microseconds of sound that the device may hold

void silent(const char *, int, const char *, int, const char *, ...) {}

bool open() {
    if (!theAlsa.snd_lib_error_set_handler) {
        if (loadFunctions("libasound.so.2", ODRAZ_ALSA(ODRAZ_NAME), (void **)&theAlsa)) return false;
        theAlsa.snd_lib_error_set_handler(silent);
    }
    if (theAlsa.snd_pcm_open(&thePcm, "default", 0 /* PLAYBACK */, 1 /* NONBLOCK */) < 0) return false;
    if (theAlsa.snd_pcm_set_params(thePcm, 2 /* S16_LE */, 3 /* RW_INTERLEAVED */, 2, kDeviceRate, 1,
                                   kLatency) >= 0)
        return true;
    theAlsa.snd_pcm_close(thePcm);
    return false;
}

int write(const int16_t *samples, int frames) {
    long taken = theAlsa.snd_pcm_writei(thePcm, samples, (unsigned long)frames);
    if (taken >= 0) return (int)taken;
    // A device that ran dry or was suspended can recover. Without a sound server, a device returns EAGAIN
    // while it wakes up
    if (taken == kAgain || theAlsa.snd_pcm_recover(thePcm, (int)taken, 1) >= 0) return 0;
    theAlsa.snd_pcm_close(thePcm);
    return -1;
}

int64_t delay() {
    long frames;
    return theAlsa.snd_pcm_delay(thePcm, &frames) < 0 ? -1 : frames;
}

} // namespace

const SoundOutput kSystemSound = {open, write, delay};
const char kNoSound[] = "no libasound.so.2, or no device: silence";

} // namespace odraz
