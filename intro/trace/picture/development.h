// Develops a picture: from linear radiance, by a film curve, to sRGB of eight bits.
#pragma once

#include "base/float8.h"
#include "base/parallel.h"
#include "trace/picture/glare.h"

namespace odraz {

// The film curve: 0 -> 0, rising, infinity -> 1; 0.18 -> 0.26, 1 -> 0.78. x >= 0, NaN gives 0.
Float8 filmic(Float8 x);

// Encodes [0, 1] as sRGB, after IEC 61966-2-1.
Float8 encodeSrgb(Float8 x);

// Both functions in one table with linear interpolation; the error is below 1/40 of one of the 255 steps.
// Entries are evenly spaced in the bits of x + kFoot, 32 for each doubling, up to kHead, which is white.
struct ToneCurve {
    static constexpr float kFoot = 1.f / 32, kHead = 32768;
    static constexpr int kShift = 18; // turns the bits of x + kFoot into the index of an entry
    // Upper half: the value, in 1/128 of a step. Lower half: the difference to the next entry's value
    int32_t entry[20 << (23 - kShift) | 1];
};
void makeToneCurve(ToneCurve &curve);

// Effects of the lens and the film.
struct CameraLook {
    float glare;    // share of the light that is spread (glare.h), 0 .. 1
    float vignette; // share of the light that the corners lose, 0 .. 1
    int grain;      // amplitude of the noise of film grain, in 1/32 of one of the 255 steps
};
inline constexpr CameraLook kPlainLook = {0, 0, 0};

// Fills frame.rgba: radiance with its glare (null: none), times exposure, through the film curve to sRGB.
// Noise of one step, different for each colour and seed, hides the steps.
void develop(const ToneCurve &curve, Frame &frame, Workers &workers, float exposure, uint32_t seed,
             const Glare *glare = nullptr, const CameraLook &look = kPlainLook);

} // namespace odraz
