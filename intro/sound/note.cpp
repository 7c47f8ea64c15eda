#include "sound/note.h"

#include "base/maths.h"
#include "base/random.h"

namespace odraz {

namespace {

constexpr float kTurn = 4294967296.f; // 2^32

struct Phasor {
    Float8 cos, sin;
};

// Not inlined, to save bytes: it has two callers.
[[gnu::noinline]] Phasor phasor(Uint8 phase, Float8 amplitude) {
    Float8 angle = toFloat((Int8)phase) * (2 * kPi / kTurn);
    return {cos(angle) * amplitude, sin(angle) * amplitude};
}

// Converts turns to a phase. Whole turns do not matter.
Uint8 phaseOf(Float8 turns) { return (Uint8)toInt((turns - round(turns)) * kTurn); }

// Returns the share of a bend that is over.
float bent(const Instrument &i, int time) {
    return 1 - exp2((float)time * (-1.f / kSampleRate) / i.bendTime);
}

// Returns how far a note is ahead of one with a constant pitch, in turns per hertz: the integral of its bend
// and of its vibrato, which fades in within a second.
float ahead(const Instrument &i, int time) {
    constexpr float kSpeed = 34; // radians a second: 5.4 Hz
    float t = (float)time * (1.f / kSampleRate);
    return bent(i, time) * i.bend * i.bendTime * 1.442695f +
           min(t, 1.f) * sin(t * kSpeed) * (i.vibrato / kSpeed);
}

Float8 randomLanes(uint32_t seed) {
    return toFloat((Int8)(pcg((Uint8)kLanes + seed * 8) >> 8)) * (1.f / 16777216);
}

bool isStruck(const Instrument &i) { return i.attack * kSampleRate < kBlock; }

// A level over a block: linear from one value to another, or up within the attack if that is shorter.
struct Ramp {
    float value, step, most;
    float next() {
        float now = value;
        value = min(value + step, most);
        return now;
    }
};

// Returns the filters' coefficient: the tangent of half the angle by which the bands' pitch turns per sample.
Float8 warped(const Voice &v, int time) {
    const Instrument &i = *v.note.instrument;
    Float8 half = toFloat((Int8)v.group[0].turn) * (fmadd(1 - bent(i, time), i.bend, 1.f) * 0.5f);
    half = clamp(half, 0, kHighest / kSampleRate * 0.5f * kTurn);
    Phasor p = phasor((Uint8)toInt(half), broadcast(1.f));
    return p.sin / p.cos;
}

void renderNoise(Voice &v, int time, Float8 amplitude, Ramp gain, Float8 *out) {
    const Voice::Group &group = v.group[0];
    float width = v.note.instrument->noise;
    Float8 g = warped(v, time), step = (warped(v, time + kBlock) - g) * (1.f / kBlock),
           falls = exp2(group.fall);
    for (int n = 0; n < kBlock; ++n) {
        Float8 white = toFloat((Int8)pcg(group.phase + (uint32_t)(time + n))) * (1.f / 2147483648.f);
        Float8 x = fmadd(white - v.low, g, v.band) / fmadd(g, g + width, 1.f), y = fmadd(x, g, v.low);
        v.band = x + x - v.band, v.low = y + y - v.low;
        out[n] = fmadd(x * amplitude, gain.next(), out[n]);
        amplitude *= falls;
        g += step;
    }
}

} // namespace

float Voice::envelope(float time) const {
    const Instrument &i = *note.instrument;
    time *= 1.f / kSampleRate;
    float held = 1 - (time - note.length) / i.release;
    return clamp(min(time / i.attack, held), 0.f, 1.f);
}

float Voice::loudness(float time) const {
    return envelope(time) * group[0].amplitude[0] * exp2(group[0].fall[0] * time);
}

void beginVoice(Voice &v, const Note &note, int block) {
    const Instrument &i = *note.instrument;
    v.note = note;
    v.start = block;
    v.band = v.low = Float8{};
    v.groups = i.partials / 4;
    float frequency = exp2((note.key - 69) * (1.f / 12)) * 440;
    float tilt = i.tilt + i.softer * (1 - note.velocity), width = min(note.room, 1.f);
    for (int g = 0; g < v.groups; ++g) {
        Voice::Group &group = v.group[g];
        Int8 left = kLanes & 3;
        Float8 k = log2(toFloat(left + 4 * g + 1));
        uint32_t seed = (uint32_t)(block * 32 + g) * 3 + (uint32_t)(int)note.key * 1664525u;
        // Random numbers make notes differ. Both copies of a partial share them, except for some of the phase
        Float8 random = randomLanes(seed), shared = (Float8)_mm256_permute2f128_ps(random, random, 0);
        Float8 side = select(kLanes < 4, 1.f, -1.f);
        Float8 ratio = exp2(k * i.stretch);
        ratio += (shared - 0.5f) * 2.f * i.scatter;
        ratio = abs(ratio) * (1.f + side * (i.detune * width));
        Float8 hertz = ratio * frequency;
        group.turn = (Uint8)toInt(min(hertz, kHighest) * (kTurn / kSampleRate));
        group.phase = phaseOf(random * (i.spread * width) + (isStruck(i) ? Float8{} : shared));
        group.hertz = hertz;
        group.amplitude = select(hertz * (1 + i.bend) < kHighest,
                                 exp2(k * -tilt) * fmadd(shared, 0.4f, 0.8f) * fmadd(side, note.left, 1.f) *
                                     (i.level * note.velocity),
                                 0.f);
        group.fall = exp2(k * i.damp) * (-9.96578f / kSampleRate / i.decay);
    }
}

void renderVoice(Voice &v, int time, float gain0, float gain1, Float8 *out) {
    const Instrument &i = *v.note.instrument;
    gain0 *= v.envelope((float)time);
    gain1 *= v.envelope((float)(time + kBlock));
    Ramp gain = {gain0, (gain1 - gain0) * (1.f / kBlock), max(gain0, gain1)};
    if (time == 0 && isStruck(i)) gain.step = gain1 / (i.attack * kSampleRate);
    float ahead0 = ahead(i, time), ahead1 = ahead(i, time + kBlock);
    for (int g = 0; g < v.groups; ++g) {
        const Voice::Group &group = v.group[g];
        Float8 amplitude = group.amplitude * exp2(group.fall * (float)time);
        if (!any(amplitude > kInaudible)) continue;
        if (i.noise > 0) {
            renderNoise(v, time, amplitude, gain, out);
            continue;
        }
        // Compute the phase at the start and the turn per sample: within a block the pitch is constant
        Uint8 phase = group.phase + group.turn * (uint32_t)time + phaseOf(group.hertz * ahead0);
        Uint8 turn = group.turn + (Uint8)toInt(group.hertz * (ahead1 - ahead0) * (kTurn / kBlock));
        Phasor p = phasor(phase, amplitude), by = phasor(turn, exp2(group.fall));
        Ramp level = gain;
        for (int n = 0; n < kBlock; ++n) {
            out[n] = fmadd(p.sin, level.next(), out[n]);
            Float8 turned = fmadd(p.cos, by.cos, -(p.sin * by.sin));
            p.sin = fmadd(p.sin, by.cos, p.cos * by.sin);
            p.cos = turned;
        }
    }
}

} // namespace odraz
