// The processor: whether it will do, what it is called, how many of it there are.
#pragma once

namespace odraz {

// Whether processor and kernel offer what the film is compiled for: x86-64-v3 (AVX2, FMA, BMI, F16C, MOVBE).
// Runs on any x86-64.
bool cpuSuffices();

// Its name without trademarks and clock rate, at most 48 characters and a zero.
void cpuName(char name[49]);

// Processors that this process may run on; >= 1.
int cpuCount();

} // namespace odraz
