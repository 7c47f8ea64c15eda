// Text: printf into strings, long numbers, and quoting for shells and HTML.
#pragma once

#include <string>
#include <string_view>

namespace common {

// format() prints into a new string, append() at the end of a string. The text may have any length.
[[gnu::format(printf, 1, 2)]] std::string format(const char *format, ...);
[[gnu::format(printf, 2, 3)]] void append(std::string &to, const char *format, ...);

// Prints 12345.6 as "12,346".
std::string thousands(double value);

// Prints "1 triangle" or "2 triangles"; "2 axes" if the plural is given.
std::string counted(size_t count, const std::string &what, const std::string &plural = "");

// Quotes a word for a shell, if it needs quotes.
std::string shellWord(const std::string &word);

// Divides letters with marks into the letter and its marks, as Unicode's form NFD has them: those of Latin,
// Greek, Cyrillic, Korean and Japanese. Two names that look the same become equal.
std::string decomposed(std::string_view text);

// Escapes text for HTML and XML, outside tags and within quoted attributes.
std::string htmlText(const std::string &text);

} // namespace common
