// The processor: whether the film runs on it, and its name.
#pragma once

namespace odraz {

// Returns whether processor and kernel support x86-64-v3 (AVX2, FMA, BMI, F16C, MOVBE), for which the film is
// compiled. Runs on any x86-64.
bool cpuSuffices();

// Writes the processor's name without trademarks and clock rate: at most 48 characters and a zero.
void cpuName(char name[49]);

} // namespace odraz
