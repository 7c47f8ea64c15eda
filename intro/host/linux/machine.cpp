#include "host/machine.h"

#include "host/linux/sys.h"

#include <cpuid.h>

namespace odraz {

bool cpuSuffices() {
    // AVX2 and BMI are leaf 7, the rest leaf 1 and 0x80000001; the kernel must save the wide registers
    unsigned a, b, c, d;
    constexpr unsigned kLeaf1 =
        bit_FMA | bit_AVX | bit_F16C | bit_MOVBE | bit_OSXSAVE | bit_POPCNT | bit_SSE4_2;
    if (!__get_cpuid(1, &a, &b, &c, &d) || (c & kLeaf1) != kLeaf1) return false;
    unsigned low, high;
    __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    if ((low & 6) != 6) return false;
    constexpr unsigned kLeaf7 = bit_AVX2 | bit_BMI | bit_BMI2;
    if (!__get_cpuid_count(7, 0, &a, &b, &c, &d) || (b & kLeaf7) != kLeaf7) return false;
    return __get_cpuid(0x80000001, &a, &b, &c, &d) && (c & bit_LZCNT);
}

void cpuName(char name[49]) {
    unsigned words[12] = {};
    for (unsigned i = 0; i < 3; ++i)
        __get_cpuid(0x80000002 + i, words + 4 * i, words + 4 * i + 1, words + 4 * i + 2, words + 4 * i + 3);
    // Leave out trademarks in parentheses, the clock rate, and blanks that repeat
    const char *from = (const char *)words;
    int size = 0;
    bool aside = false;
    for (int i = 0; i < 48 && from[i] && from[i] != '@'; ++i) {
        aside |= from[i] == '(';
        if (!aside && (from[i] != ' ' || (size && name[size - 1] != ' '))) name[size++] = from[i];
        aside &= from[i] != ')';
    }
    while (size && name[size - 1] == ' ') --size;
    name[size] = 0;
}

int cpuCount() {
    uint64_t mask[16];
    long bytes = sys::call(sys::kGetAffinity, 0, sizeof mask, (long)mask);
    int count = 0;
    for (long i = 0; i < bytes / 8; ++i)
        for (uint64_t m = mask[i]; m; m &= m - 1) ++count;
    return count ? count : 1;
}

int64_t nanoseconds() {
    int64_t now[2];
    sys::call(sys::kClockGettime, 1 /* CLOCK_MONOTONIC */, (long)now);
    return now[0] * 1000000000 + now[1];
}

void *takeMemory(size_t bytes) {
    long p = sys::call(sys::kMmap, 0, (long)bytes, 3 /* read, write */, 0x22 /* private, anonymous */, -1, 0);
    return p < 0 && p > -4096 ? nullptr : (void *)p;
}

int complain(const char *line) {
    char text[512] = "odraz: ";
    int size = 7;
    while (*line && size < 510) text[size++] = *line++;
    text[size++] = '\n';
    sys::call(sys::kWrite, 2, (long)text, size);
    return 1;
}

int guardStandardDescriptors() {
    int closed = 0;
    for (int fd = 0; fd < 3; ++fd)
        if (sys::call(sys::kFcntl, fd, 1 /* F_GETFD */) == -sys::kEbadf) {
            closed |= 1 << fd;
            sys::call(sys::kOpen, (long)"/dev/null",
                      2 /* O_RDWR */); // takes the lowest free number: this one
        }
    return closed;
}

void ignoreBrokenPipes() {
    uint64_t action[4] = {1 /* SIG_IGN */};
    sys::call(sys::kSigaction, 13 /* SIGPIPE */, (long)action, 0, 8);
}

} // namespace odraz
