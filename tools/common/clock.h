// Clocks. Processor time, user and system, is what measurements count, since neighbours disturb it least.
#pragma once

#include <functional>

namespace odraz {

double processorSeconds(); // of all threads of this process
double threadSeconds();    // of this thread
double wallSeconds();      // since some moment

// The median time of a call on this process's processors, in milliseconds: of `rounds` rounds, each of as
// many calls as take 10 ms together.
double medianMs(const std::function<void()> &call, int rounds = 9);

} // namespace odraz
