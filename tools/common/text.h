// Text: printf into a string, long numbers, and quoting for a shell and for HTML.
#pragma once

#include <string>

namespace common {

// printf into a new string, and at the end of one. Any length.
[[gnu::format(printf, 1, 2)]] std::string format(const char *format, ...);
[[gnu::format(printf, 2, 3)]] void append(std::string &to, const char *format, ...);

// 12345.6 as 12,346.
std::string thousands(double value);

// "1 triangle" or "2 triangles".
std::string counted(size_t count, const std::string &what);

// A word as a shell reads it: in quotes where it needs them.
std::string shellWord(const std::string &word);

// Text for HTML and XML, outside tags and within quoted attributes.
std::string htmlText(const std::string &text);

} // namespace common
