// The instruments of the score; sound/instrument.h tells what the numbers mean.
#include "show/instruments.h"

#include "base/float8.h"

namespace odraz {

// Rounds a number to eight significant bits: the ear needs no more, and fewer bits pack better.
static consteval float operator""_s(long double x) { return fromBits((bits((float)x) + 0x8000) & ~0xffff); }

// clang-format off
constexpr Instrument kInstruments[] = {
    [kPiano] = {.partials = 20, .level = 0.134_s, .stretch = 1.003_s, .tilt = 0.9_s, .softer = 1.2_s, .decay = 7, .damp = 0.8_s,
        .release = 1.2_s, .detune = 0.0005_s, .spread = 0.5_s, .room = 0.6_s, .echo = 0.12_s, .ducked = 0.2_s},
    [kPad] = {.partials = 12, .level = 0.06_s, .stretch = 1, .scatter = 0.002_s, .tilt = 1.2_s, .softer = 0.8_s, .decay = 60,
        .attack = 0.5_s, .release = 2.4_s, .detune = 0.0022_s, .spread = 0.5_s, .room = 0.6_s, .ducked = 0.7_s},
    [kDrum] = {.partials = 8, .level = 0.4_s, .stretch = 1.6_s, .scatter = 0.05_s, .tilt = 1.5_s, .softer = 0.5_s, .decay = 0.9_s, .damp = 1.1_s,
        .release = 0.5_s, .detune = 0.001_s, .spread = 0.1_s, .bend = 1.6_s, .bendTime = 0.025_s, .room = 0.5_s, .ducks = 0.5_s},
};
// clang-format on
static_assert(sizeof kInstruments / sizeof *kInstruments == kInstrumentCount);
static_assert(
    [] {
        for (const Instrument &i : kInstruments)
            if (i.partials < 4 || i.partials > 32 || i.partials % 4 || (i.noise > 0 && i.partials > 4))
                return false;
        return true;
    }(),
    "groups of four partials, 32 at most, one of noise");

} // namespace odraz
