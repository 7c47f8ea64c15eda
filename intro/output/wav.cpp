#include "output/wav.h"

#include "host/files.h"
#include "host/process.h"
#include "output/output.h"
#include "output/samples.h"

namespace odraz {

namespace {

// "Multimedia Programming Interface and Data Specifications 1.0", Microsoft and IBM, 1991.
struct Header {
    char riff[4] = {'R', 'I', 'F', 'F'};
    uint32_t rest = 36; // bytes that follow
    char wave[8] = {'W', 'A', 'V', 'E', 'f', 'm', 't', ' '};
    uint32_t formatSize = 16;
    uint16_t pcm = 1, channels = 2;
    uint32_t rate = kSoundRate, bytesPerSecond = 4 * kSoundRate;
    uint16_t bytesPerFrame = 4, bits = 16;
    char data[4] = {'d', 'a', 't', 'a'};
    uint32_t size = 0; // bytes
};
static_assert(sizeof(Header) == 44);

constexpr size_t kSlack = 4 * kSoundBlock; // bytes of a block: room before and after the part to write

} // namespace

int writeWav(const Options &o, bool stdoutClosed) {
    if (int status = checkOutput(o.wav, stdoutClosed)) return status;
    // Begin and end at the first sample at or after --from and --to, as for frames
    int from = (int)firstFrame(o.from, {kSoundRate, 1}), to = (int)firstFrame(o.to, {kSoundRate, 1});
    size_t size = (size_t)(to - from) * 4, bytes = soundMemory() + kSlack + size + kSlack;
    Arena arena = {(unsigned char *)takeMemory(bytes), bytes, 0};
    if (!arena.base) return cannotWrite(o.wav, "not enough memory");
    Sound *sound = loadSound(arena);
    uint8_t *first = arena.allocate<uint8_t>(kSlack + size) + kSlack;

    // Render from the film's start, and keep the part to write. Its first block may begin before it, and its
    // last block may end after it: kSlack is the room for that
    for (int at = 0; at < to; at += kSoundBlock) {
        float block[2 * kSoundBlock];
        soundBlock(*sound, block);
        if (at + kSoundBlock <= from) continue;
        quantize(block, at / kSoundBlock, (int16_t *)first + (int64_t)2 * (at - from));
    }
    Header *header = (Header *)first - 1;
    *header = {};
    header->size = (uint32_t)size;
    header->rest += (uint32_t)size;
    return writeOutput(o.wav, header, sizeof(Header) + size);
}

} // namespace odraz
