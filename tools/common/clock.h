// Clocks. Measurements use processor time, user and system, because other programs disturb it least.
#pragma once

#include <functional>

namespace common {

double processorSeconds(); // processor time of all threads of this process
double wallSeconds();      // time since an arbitrary moment

// The median processor time of a call, in milliseconds. Each of `rounds` rounds calls the function until 10
// ms have passed, and takes the mean.
double medianMs(const std::function<void()> &call, int rounds = 9);

} // namespace common
