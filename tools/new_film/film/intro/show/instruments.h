// The instruments of the score.
#pragma once

#include "sound/instrument.h"

#include <stdint.h>

namespace odraz {

enum InstrumentId : uint8_t { kPiano, kPad, kDrum, kInstrumentCount };
extern const Instrument kInstruments[kInstrumentCount];

} // namespace odraz
