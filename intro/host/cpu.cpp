#include "host/cpu.h"

#include <cpuid.h>

namespace odraz {

bool cpuSuffices() {
    // AVX2 and BMI are in leaf 7, the others in leaves 1 and 0x80000001. The kernel must save wide registers
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
    // Leave out trademarks in parentheses, the clock rate and repeated blanks
    const char *from = (const char *)words;
    int size = 0;
    bool inParentheses = false;
    for (int i = 0; i < 48 && from[i] && from[i] != '@'; ++i) {
        inParentheses |= from[i] == '(';
        if (!inParentheses && (from[i] != ' ' || (size && name[size - 1] != ' '))) name[size++] = from[i];
        inParentheses &= from[i] != ')';
    }
    while (size && name[size - 1] == ' ') --size;
    name[size] = 0;
}

} // namespace odraz
