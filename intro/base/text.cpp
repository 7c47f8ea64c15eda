#include "base/text.h"

namespace odraz {

AnyText &AnyText::operator<<(char c) {
    if (size < capacity - 1) data[size++] = c;
    data[size] = 0;
    return *this;
}

AnyText &AnyText::operator<<(const char *s) {
    while (*s) *this << *s++;
    return *this;
}

AnyText &AnyText::operator<<(int64_t x) {
    if (x < 0) *this << '-';
    return number(x < 0 ? 0 - (uint64_t)x : (uint64_t)x, 1);
}

AnyText &AnyText::number(uint64_t x, int digits) {
    char reversed[20];
    int n = 0;
    for (; x || n < digits; x /= 10) reversed[n++] = (char)('0' + x % 10);
    while (n) *this << reversed[--n];
    return *this;
}

AnyText &AnyText::decimal(double x, int places) {
    uint64_t scale = 1;
    for (int i = 0; i < places; ++i) scale *= 10;
    uint64_t scaled = (uint64_t)(x * (double)scale + 0.5);
    number(scaled / scale, 1);
    return places ? (*this << '.').number(scaled % scale, places) : *this;
}

AnyText &AnyText::padTo(int column) {
    while (size < column && size < capacity - 1) *this << ' ';
    return *this;
}

} // namespace odraz
