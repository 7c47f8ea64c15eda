// What the machine is and lets us do: processor, time, memory, and saying no in one readable line.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace odraz {

// Whether processor and kernel offer what the film is compiled for: x86-64-v3 (AVX2, FMA, BMI, F16C, MOVBE).
// Runs on any x86-64.
bool cpuSuffices();

// The processor's name without trademarks and clock rate, at most 48 characters and a zero.
void cpuName(char name[49]);

// Processors that this process may run on; >= 1.
int cpuCount();

int64_t nanoseconds(); // monotonic

void *takeMemory(size_t bytes); // zeroed; null when there is none

// Writes "odraz: LINE" to standard error. Returns 1, the exit status of a failure.
int complain(const char *line);

// complain(), and where there is a display shows the line in a small window until a key or the close button.
// For viewers who double-clicked and see no standard error. Any processor.
int refuse(const char *line);

// Opens /dev/null in place of closed standard descriptors, so that no file ends up as standard error. Returns
// a bit for every one that was closed.
int guardStandardDescriptors();

void ignoreBrokenPipes(); // a closed pipe becomes an error of write()

} // namespace odraz
