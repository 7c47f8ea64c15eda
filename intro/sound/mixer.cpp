#include "sound/mixer.h"

#include "base/maths.h"

namespace odraz {

static constexpr float kLoud = 1.9f;        // gain of the mix before it is clipped softly
static constexpr float kThreshold = 0.006f; // mean square above which the compressor acts, 4:3
static constexpr float kFade = 0.35f;       // decrease of the gain per block while muted
static constexpr float kRoomLevel = 0.42f;
static constexpr float kPeak = 0.68f;       // the largest sample: leaves room for peaks between samples
static constexpr int kSeekBlocks = 8 * 200; // rendered before the block sought, to fill room and echo

void playNote(Mixer &m, const Note &note) {
    if (!(note.key > 0 && note.velocity > 0 && note.room >= 0) || m.voiceCount == kVoices) return;
    beginVoice(m.voices[m.voiceCount++], note, m.block);
    m.ducked = max(m.ducked, note.instrument->ducks);
}

// Adds every voice to the mix if `audible`, and drops those that end. If fewer than kVoicesAtOnce voices are
// free, fades out the quietest one. `ducked`: m.ducked before this row.
static void mixVoices(Mixer &m, bool audible, float ducked) {
    int stolen = m.voiceCount > kVoices - kVoicesAtOnce ? m.quietest : -1;
    float least = kInfinity;
    int remaining = 0;
    for (int i = 0; i < m.voiceCount; ++i) {
        Voice &v = m.voices[i];
        const Instrument &kind = *v.note.instrument;
        int time = (m.block - v.start) * kBlock;
        if (audible) {
            renderVoice(v, time, 1 - ducked * kind.ducked, i == stolen ? 0 : 1 - m.ducked * kind.ducked,
                        m.voice);
            float send = kind.room * v.note.room * kRoomLevel;
            for (int n = 0; n < kBlock; ++n) {
                m.dry[n] += m.voice[n];
                m.wet[n] = fmadd(m.voice[n], send, m.wet[n]);
                m.echoed[n] = fmadd(m.voice[n], kind.echo, m.echoed[n]);
                m.voice[n] = Float8{};
            }
        }
        // Drop voices that are inaudible at the block's end
        float loudness = v.loudness((float)(time + kBlock));
        if (i == stolen || !(loudness > kInaudible)) continue;
        if (loudness < least) least = loudness, m.quietest = remaining;
        m.voices[remaining++] = v;
    }
    m.voiceCount = remaining;
}

constexpr float kPerDecibel = 0.166096f; // log2(10) / 20

// Mixes down to two channels: crossfeed, the compressor's gain and the level, soft clipping. Clears the mix.
static void mixDown(Mixer &m, float *stereo) {
    // Move the gain linearly over the block; after silence in 1 ms, so that struck notes keep their attack
    float gain =
        kLoud * exp2(fmadd(max(log2(m.power * (1 / kThreshold)), 0.f), -0.125f, m.level * kPerDecibel));
    if (m.muted) gain = max(m.gain - kFade, 0.f);
    float step = (gain - m.gain) / (m.gain > 0 ? kBlock : 48), most = max(gain, m.gain);
    Float8 squares = {};
    for (int n = 0; n < kBlock; ++n) {
        Float8 x = m.dry[n];
        m.dry[n] = m.wet[n] = m.echoed[n] = Float8{};
        x = (Float8)_mm256_hadd_ps(x, x);
        x = (Float8)_mm256_hadd_ps(x, x);
        x = fmadd((Float8)_mm256_permute2f128_ps(x, x, 1) - x, m.crossfeed, x);
        squares = fmadd(x, x, squares);
        m.gain = min(m.gain + step, most);
        x *= m.gain;
        // Clip softly, by a cubic that is flat at 1.5
        x = clamp(x, -1.5f, 1.5f);
        x = (x - x * x * x * (4.f / 27)) * kPeak;
        stereo[2 * n] = x[0], stereo[2 * n + 1] = x[4];
    }
    m.gain = gain;
    float grown = (squares[0] + squares[4]) * (0.5f / kBlock) - m.power;
    m.power = fmadd(grown, grown > 0 ? 0.05f : 0.005f, m.power);
}

void renderBlock(Mixer &m, float *stereo) {
    unsigned control = _mm_getcsr();
    _mm_setcsr(control | 0x8040); // FTZ and DAZ: denormal numbers are slow
    float ducked = m.ducked;
    if (m.block % kBlocksPerRow == 0) m.player(m, m.block / kBlocksPerRow);
    mixVoices(m, stereo, ducked);
    if (stereo) {
        renderEcho(m.echo, m.block, m.echoed, m.dry, m.wet);
        renderReverb(m.reverb, m.block, m.wet, m.dry);
        mixDown(m, stereo);
    }
    ++m.block;
    m.ducked *= 0.93f;
    _mm_setcsr(control);
}

void seekBlock(Mixer &m, int block) {
    RowPlayer player = m.player;
    __builtin_memset((void *)&m, 0, sizeof m);
    m.player = player;
    float unheard[2 * kBlock];
    while (m.block < block) renderBlock(m, m.block < block - kSeekBlocks ? nullptr : unheard);
}

} // namespace odraz
