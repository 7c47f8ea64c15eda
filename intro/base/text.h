// Builds text without libc, in a fixed buffer. Text that does not fit is cut off.
#pragma once

#include <stdint.h>

namespace odraz {

// The base of texts of all sizes, which share one copy of the code.
struct AnyText {
    char *data;
    int capacity; // bytes, including the zero at the end
    int size = 0;

    AnyText &operator<<(char c);
    AnyText &operator<<(const char *s);
    AnyText &operator<<(int64_t x);
    AnyText &operator<<(int x) { return *this << (int64_t)x; }
    // Appends x, padded with zeros to at least `digits` digits.
    AnyText &number(uint64_t x, int digits);
    // Appends x >= 0, rounded to `places` decimals.
    AnyText &decimal(double x, int places);
    AnyText &padTo(int column);
};

template <int N> struct Text : AnyText {
    char buffer[N];

    Text() : AnyText{buffer, N} {}
    Text(const Text &) = delete;
};

} // namespace odraz
