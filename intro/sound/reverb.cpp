#include "sound/reverb.h"

#include "base/maths.h"

namespace odraz {

// The delay lines' lengths in samples: not in ratios of small integers, so that their echoes seldom coincide.
// In the order of their lengths, the lines are on the left and the right in turn.
static constexpr Float8 kLengths = {1511, 2039, 2741, 3697, 1753, 2371, 3187, 4001};

static constexpr int kDiffusers[] = {223, 467, 907}; // samples

// Returns the lines' lengths at the start of a block. Each follows a triangle wave with a different period,
// about 20 seconds. The slope is constant, so that all frequencies are detuned equally.
static Float8 drifted(int block) {
    Float8 turned = fmadd(toFloat(kLanes), 0.00002f, 0.0002f) * (float)block;
    return fmadd(abs(turned - round(turned)), 4 * kDrift, kLengths);
}

void renderReverb(Reverb &reverb, int block, const Float8 *in, Float8 *out) {
    // A line of n samples loses 60 n / decay dB; a one-pole low-pass increases the loss at high frequencies
    constexpr float kRatio = kDecay / kDecayHigh;
    Float8 powers = kLengths * (-9.96578f / kSampleRate / kDecay); // log2 of the gain
    Float8 pole = powers * (0.173287f * (1 - kRatio * kRatio));
    // The Hadamard matrix amplifies by sqrt(8)
    Float8 gain = exp2(powers) * (1.f - pole) * 0.353553391f;

    Float8 delay = drifted(block), step = (drifted(block + 1) - delay) * (1.f / kBlock);
    const float *lines = (const float *)reverb.lines;
    for (int n = 0; n < kBlock; ++n) {
        Int8 whole = toInt(delay);
        Int8 at = reverb.at - whole;
        auto read = [&](Int8 at) { return gather(lines, (at & (Reverb::kLength - 1)) * 8 + kLanes); };
        Float8 x = read(at);
        x = fmadd(read(at - 1) - x, delay - toFloat(whole), x);
        delay += step;
        Float8 y = reverb.low = fmadd(reverb.low, pole, x * gain);
        out[n] += y;
        for (int stage = 0; stage < 3; ++stage) {
            y = (Float8)_mm256_addsub_ps((Float8)_mm256_permute_ps(y, 0xb1), y);
            y = (Float8)_mm256_permutevar8x32_ps(y, (__m256i)Int8{0, 2, 4, 6, 1, 3, 5, 7});
        }
        Float8 entering = in[n];
        for (int i = 0; i < 3; ++i) {
            Float8 *line = reverb.diffuser[i];
            Float8 late = line[(reverb.at - kDiffusers[i]) & 1023];
            Float8 now = line[reverb.at & 1023] = fmadd(late, 0.6f, entering);
            entering = fmadd(now, -0.6f, late);
        }
        reverb.lines[reverb.at] = y + entering;
        reverb.at = (reverb.at + 1) & (Reverb::kLength - 1);
    }
}

void renderEcho(Echo &echo, int block, const Float8 *in, Float8 *dry, Float8 *wet) {
    constexpr Float8 kLeft = {1, 1, 1, 1};
    Float8 *line = echo.line + block % Echo::kBlocks * kBlock;
    for (int n = 0; n < kBlock; ++n) {
        Float8 late = line[n], both = in[n] + (Float8)_mm256_permute2f128_ps(in[n], in[n], 1);
        line[n] = fmadd((Float8)_mm256_permute2f128_ps(late, late, 1), 0.5f, both * kLeft);
        dry[n] += late;
        wet[n] = fmadd(late, 0.3f, wet[n]);
    }
}

} // namespace odraz
