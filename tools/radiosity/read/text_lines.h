// Lines of a text file that another program wrote: UTF-8 with or without a byte order mark, or UTF-16; lines
// that end with LF, CR LF or CR; lines that a backslash continues.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace odraz::radiosity {

class TextLines {
public:
    // Throws Refused if the file cannot be read, or is UTF-32. Zero bytes become blanks.
    explicit TextLines(const std::string &path);

    // Moves to the next line that is not empty; false at the end.
    bool next();
    size_t number = 0;     // line number from 1 on; for a continued line, its first line's
    std::string_view word; // the line's first word
    std::string_view rest; // the text after it, without blanks at its ends
    bool isText = true;    // whether the file has no control characters

    // The index of the line's word in `keywords`, or -1. Adds words that differ in case to `otherCase`.
    int keyword(std::span<const char *const> keywords);
    std::map<std::string, const char *> otherCase;

private:
    std::string text, joined;
    size_t at = 0, following = 1;
};

// Removes the first word from `text`, with the blanks after it, and returns it.
std::string_view takeWord(std::string_view &text);

// Removes a number. Returns false, and leaves `text` as it is, if the first word is not a number.
bool takeNumber(std::string_view &text, double &number);

} // namespace odraz::radiosity
