// Builds text without libc, in a fixed buffer. What does not fit is cut off.
#pragma once

#include <stdint.h>

namespace odraz {

// Text of any size: all sizes share one copy of the code.
struct AnyText {
    char *data;
    int capacity; // bytes, including the zero at the end
    int size = 0;

    AnyText &operator<<(char c);
    AnyText &operator<<(const char *s);
    AnyText &operator<<(int64_t x);
    AnyText &operator<<(int x) { return *this << (int64_t)x; }
    // At least `digits` digits, zeros in front.
    AnyText &number(uint64_t x, int digits);
    // x >= 0 with `places` decimals, rounded.
    AnyText &decimal(double x, int places);
    AnyText &padTo(int column);
};

template <int N> struct Text : AnyText {
    char buffer[N];

    Text() : AnyText{buffer, N} {}
    Text(const Text &) = delete;
};

} // namespace odraz
