// Clocks. Measurements count processor time, user and system, because other programs disturb it least.
#pragma once

#include <functional>

namespace common {

double processorSeconds(); // of all threads of this process
double wallSeconds();      // since an arbitrary moment

// The median processor time of a call, in milliseconds. Each of `rounds` rounds makes as many calls as take
// 10 ms together.
double medianMs(const std::function<void()> &call, int rounds = 9);

} // namespace common
