// The instruments of the score: sines first, then bands of noise.
#include "show/instruments.h"

#include "base/float8.h"

namespace odraz {

// Rounds a number to eight significant bits: nobody hears more, and fewer bits pack better.
static consteval float operator""_s(long double x) { return fromBits((bits((float)x) + 0x8000) & ~0xffff); }

// clang-format off
constexpr Instrument kInstruments[] = { // rows in the enum's order
    [kGlassDrop] = {.partials = 8, .level = 0.11_s, .stretch = 1.46_s, .scatter = 0.01_s, .tilt = 1.2_s, .softer = 1, .decay = 4.5_s, .damp = 0.9_s,
        .release = 3, .detune = 0.0004_s, .spread = 0.5_s, .room = 1, .echo = 0.3_s},
    [kPiano] = {.partials = 20, .level = 0.134_s, .stretch = 1.003_s, .tilt = 0.9_s, .softer = 1.2_s, .decay = 7, .damp = 0.8_s,
        .release = 1.2_s, .detune = 0.0005_s, .spread = 0.5_s, .room = 0.6_s, .echo = 0.12_s, .ducked = 0.2_s},
    [kPad] = {.partials = 12, .level = 0.06_s, .stretch = 1, .scatter = 0.002_s, .tilt = 1.2_s, .softer = 0.8_s, .decay = 60,
        .attack = 1.4_s, .release = 2.4_s, .detune = 0.0022_s, .spread = 0.5_s, .room = 0.6_s, .ducked = 0.7_s},
    [kBass] = {.partials = 8, .level = 0.125_s, .stretch = 1, .tilt = 1.1_s, .softer = 0.6_s, .decay = 9, .damp = 0.5_s,
        .release = 0.5_s, .detune = 0.0008_s, .spread = 0.2_s, .room = 0.2_s, .ducked = 0.8_s},
    [kWood] = {.partials = 8, .level = 0.12_s, .stretch = 1.72_s, .scatter = 0.03_s, .tilt = 1.1_s, .softer = 0.8_s, .decay = 0.5_s, .damp = 0.6_s,
        .release = 0.3_s, .detune = 0.001_s, .spread = 0.2_s, .bend = 0.06_s, .bendTime = 0.008_s, .room = 0.7_s, .echo = 0.25_s},
    [kPulse] = {.partials = 16, .level = 0.07_s, .stretch = 1.01_s, .tilt = 0.6_s, .softer = 0.9_s, .decay = 0.45_s, .damp = 0.5_s,
        .release = 0.1_s, .detune = 0.0006_s, .spread = 0.2_s, .room = 0.35_s},
    [kDrum] = {.partials = 8, .level = 0.5_s, .stretch = 1.6_s, .scatter = 0.05_s, .tilt = 1, .softer = 0.5_s, .decay = 0.9_s, .damp = 1.1_s,
        .release = 0.5_s, .detune = 0.001_s, .spread = 0.1_s, .bend = 1.6_s, .bendTime = 0.025_s, .room = 0.5_s, .ducks = 0.8_s},
    [kVoice] = {.partials = 12, .level = 0.12_s, .stretch = 1, .scatter = 0.003_s, .tilt = 1.5_s, .softer = 0.6_s, .decay = 20, .damp = 0.3_s,
        .attack = 0.12_s, .release = 0.5_s, .detune = 0.0025_s, .spread = 0.5_s, .vibrato = 0.006_s, .room = 1, .echo = 0.1_s},
    [kBrush] = {.noise = 1, .level = 0.45_s, .stretch = 0.7_s, .tilt = 0.3_s, .softer = 0.3_s, .decay = 0.3_s, .damp = 0.3_s,
        .release = 0.1_s, .spread = 1, .room = 0.3_s, .echo = 0.1_s},
    [kHat] = {.noise = 0.5_s, .level = 0.42_s, .stretch = 0.3_s, .softer = 0.3_s, .decay = 0.12_s, .release = 0.05_s, .spread = 1, .room = 0.2_s},
    [kWind] = {.noise = 0.3_s, .level = 0.15_s, .stretch = 0.9_s, .tilt = 0.5_s, .decay = 60, .attack = 2, .release = 3, .spread = 1,
        .bend = 0.5_s, .bendTime = 2, .room = 0.5_s},
    [kRiser] = {.noise = 0.5_s, .level = 0.25_s, .stretch = 1, .tilt = 0.3_s, .decay = 60, .attack = 4, .release = 0.1_s, .spread = 1,
        .bend = 0.1_s, .bendTime = -1, .room = 0.5_s},
    [kImpact] = {.noise = 1.5_s, .level = 2, .stretch = 2, .tilt = 0.2_s, .decay = 1.2_s, .damp = 0.5_s, .release = 1, .spread = 1,
        .bend = 2, .bendTime = 0.03_s, .room = 0.6_s},
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
    "4 to 32 partials in groups of four; noise has one group");

} // namespace odraz
