// printf that appends to a string; at most 399 characters a call.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <string>

namespace odraz {

[[gnu::format(printf, 2, 3)]] inline void print(std::string &to, const char *format, ...) {
    char line[400];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    to += line;
}

} // namespace odraz
