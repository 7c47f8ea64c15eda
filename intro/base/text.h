// Text put together without libc, in a fixed buffer: what does not fit is cut off.
#pragma once

#include <stdint.h>

namespace odraz {

template <int N> struct Text {
    char data[N];
    int size = 0;

    Text &operator<<(char c) {
        if (size < N - 1) data[size++] = c;
        data[size] = 0;
        return *this;
    }
    Text &operator<<(const char *s) {
        while (*s) *this << *s++;
        return *this;
    }
    Text &operator<<(int64_t x) {
        if (x < 0) *this << '-';
        return number(x < 0 ? 0 - (uint64_t)x : (uint64_t)x, 1);
    }
    Text &operator<<(int x) { return *this << (int64_t)x; }
    // At least `digits` digits, zeros in front.
    Text &number(uint64_t x, int digits) {
        char reversed[20];
        int n = 0;
        for (; x || n < digits; x /= 10) reversed[n++] = (char)('0' + x % 10);
        while (n) *this << reversed[--n];
        return *this;
    }
    // x >= 0 with `places` decimals, rounded.
    Text &decimal(double x, int places) {
        uint64_t scale = 1;
        for (int i = 0; i < places; ++i) scale *= 10;
        uint64_t scaled = (uint64_t)(x * (double)scale + 0.5);
        number(scaled / scale, 1);
        if (places) (*this << '.').number(scaled % scale, places);
        return *this;
    }
    Text &padTo(int column) {
        while (size < column && size < N - 1) *this << ' ';
        return *this;
    }
};

} // namespace odraz
