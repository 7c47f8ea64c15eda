// A sequence of random numbers, the same in every run.
#pragma once

#include "base/random.h"

namespace odraz {

struct Random {
    uint32_t state;
    float next() { return unitFloat(pcg(state++)); } // [0, 1)
};

} // namespace odraz
