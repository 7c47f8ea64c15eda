// The instruments of the score.
#pragma once

#include "sound/instrument.h"

#include <stdint.h>

namespace odraz {

// clang-format off
enum InstrumentId : uint8_t {
    kGlassDrop, kPiano, kPad, kBass, kWood, kPulse, kDrum, kVoice, // sines
    kBrush, kHat, kWind, kRiser, kImpact,                       // noise
    kInstrumentCount
};
// clang-format on
extern const Instrument kInstruments[kInstrumentCount];

} // namespace odraz
