#include "tools/radiosity/read/text_lines.h"

#include "tools/common/whole_file.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <locale>
#include <strings.h>

namespace odraz::radiosity {

namespace {

bool blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

std::string_view trimmed(std::string_view s) {
    while (!s.empty() && blank(s.front())) s.remove_prefix(1);
    while (!s.empty() && blank(s.back())) s.remove_suffix(1);
    return s;
}

// UTF-16 as UTF-8; `high` is the index of each unit's high byte.
std::string fromUtf16(std::string_view s, size_t high, const std::string &path) {
    std::u16string units;
    for (size_t i = 0; i + 1 < s.size(); i += 2)
        units += (char16_t)((uint8_t)s[i + high] << 8 | (uint8_t)s[i + 1 - high]);
    std::string to(units.size() * 3, '\0');
    std::mbstate_t state = {};
    const char16_t *read;
    char8_t *written, *begin = (char8_t *)to.data();
    using Utf = std::codecvt<char16_t, char8_t, std::mbstate_t>;
    if (std::use_facet<Utf>(std::locale::classic())
            .out(state, units.data(), units.data() + units.size(), read, begin, begin + to.size(), written) !=
        Utf::ok)
        throw common::Refused(path + ": its UTF-16 is damaged: save it as UTF-8");
    to.resize((size_t)(written - begin));
    return to;
}

std::string decoded(std::string text, const std::string &path) {
    auto begins = [&](std::string_view mark) { return text.compare(0, mark.size(), mark) == 0; };
    // Without a byte order mark, the zero bytes of ASCII characters decide
    int zero = 0; // a bit for each of the first four bytes; the first byte has the highest
    for (size_t i = 0; i < 4; ++i) zero = zero << 1 | (i < text.size() && text[i] == 0);
    const bool little = begins("\xff\xfe");
    if (zero == 0b1110 || zero == 0b0111 || (little && zero == 0b0011) || begins({"\0\0\xfe\xff", 4}))
        throw common::Refused(path + ": it is UTF-32: save it as UTF-8");
    if (little || begins("\xfe\xff")) return fromUtf16(std::string_view(text).substr(2), little, path);
    if (zero == 0b0101 || zero == 0b1010) return fromUtf16(text, zero == 0b0101, path);
    return begins("\xef\xbb\xbf") ? text.substr(3) : text;
}

} // namespace

TextLines::TextLines(const std::string &path) : text(decoded(common::readWhole(path), path)) {
    auto control = [](char c) {
        return (uint8_t)c < ' ' && !blank(c) &&
               std::string_view("\r\n\x1a").find(c) == std::string_view::npos;
    };
    isText = std::none_of(text.begin(), text.end(), control);
    if (!isText) std::replace(text.begin(), text.end(), '\0', ' ');
    if (text.find('\r') == std::string::npos) return;
    size_t to = 0;
    for (size_t i = 0; i < text.size(); ++i)
        if (text[i] != '\r' || i + 1 == text.size() || text[i + 1] != '\n')
            text[to++] = text[i] == '\r' ? '\n' : text[i];
    text.resize(to);
}

bool TextLines::next() {
    while (at < text.size()) {
        number = following;
        auto nextPhysical = [&] {
            size_t from = at, end = std::min(text.find('\n', at), text.size());
            at = end + 1, ++following;
            return std::string_view(text).substr(from, end - from);
        };
        std::string_view line = trimmed(nextPhysical());
        if (!line.empty() && line.back() == '\\' && line.front() != '#') {
            joined = line;
            while (!joined.empty() && joined.back() == '\\') {
                joined.back() = ' ';
                if (at < text.size()) joined += nextPhysical();
            }
            line = trimmed(joined);
        }
        if (line.empty() || line.front() == '#') continue;
        rest = line;
        word = takeWord(rest);
        return true;
    }
    return false;
}

int TextLines::keyword(std::span<const char *const> keywords) {
    for (size_t i = 0; i < keywords.size(); ++i)
        if (word == keywords[i]) return (int)i;
    for (size_t i = 0; i < keywords.size(); ++i)
        if (word.size() == std::strlen(keywords[i]) && !strncasecmp(word.data(), keywords[i], word.size())) {
            otherCase.emplace(word, keywords[i]);
            return (int)i;
        }
    return -1;
}

std::string_view takeWord(std::string_view &text) {
    size_t end = 0;
    while (end < text.size() && !blank(text[end])) ++end;
    std::string_view word = text.substr(0, end);
    text = trimmed(text.substr(end));
    return word;
}

bool takeNumber(std::string_view &text, double &number) {
    std::string_view rest = text, word = takeWord(rest);
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error == std::errc::result_out_of_range) number = std::strtod(std::string(word).c_str(), nullptr);
    if (error == std::errc::invalid_argument || end != word.data() + word.size()) return false;
    text = rest;
    return true;
}

} // namespace odraz::radiosity
