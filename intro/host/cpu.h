// The processor: whether the film runs on it, and its name.
#pragma once

namespace odraz {

// Whether processor and kernel offer what the film is compiled for: x86-64-v3 (AVX2, FMA, BMI, F16C, MOVBE).
// Runs on any x86-64.
bool cpuSuffices();

// Its name without trademarks and clock rate, at most 48 characters and a zero.
void cpuName(char name[49]);

} // namespace odraz
