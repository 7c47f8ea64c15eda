#include "tools/common/text.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace common {

static void append(std::string &to, const char *format, va_list arguments) {
    va_list again;
    va_copy(again, arguments);
    int size = std::vsnprintf(nullptr, 0, format, again);
    va_end(again);
    if (size < 0) return;
    size_t before = to.size();
    to.resize(before + (size_t)size + 1); // with the final zero
    std::vsnprintf(&to[before], (size_t)size + 1, format, arguments);
    to.pop_back();
}

std::string format(const char *format, ...) {
    std::string text;
    va_list arguments;
    va_start(arguments, format);
    append(text, format, arguments);
    va_end(arguments);
    return text;
}

void append(std::string &to, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    append(to, format, arguments);
    va_end(arguments);
}

std::string thousands(double value) {
    std::string digits = format("%.0f", std::abs(value)), text = std::round(value) < 0 ? "-" : "";
    for (size_t i = 0; i < digits.size(); ++i) {
        if (i && (digits.size() - i) % 3 == 0) text += ',';
        text += digits[i];
    }
    return text;
}

std::string counted(size_t count, const std::string &what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string shellWord(const std::string &word) {
    constexpr char kPlain[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./,:=+-@%";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
    std::string quoted = "'";
    for (char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

std::string htmlText(const std::string &text) {
    std::string escaped;
    for (char c : text) switch (c) {
        case '<':
            escaped += "&lt;";
            break;
        case '>':
            escaped += "&gt;";
            break;
        case '&':
            escaped += "&amp;";
            break;
        case '"':
            escaped += "&quot;";
            break;
        default:
            escaped += c;
        }
    return escaped;
}

} // namespace common
