#include "maker/source/tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <regex>

namespace odraz::maker {

namespace {

constexpr size_t kTrackNumbers = 3, kPathNumbers = 9;
constexpr const char *kInterpolations[] = {"Linear", "Smooth"};

size_t numbersIn(TableKind kind) { return kind == TableKind::Track ? kTrackNumbers : kPathNumbers; }

// The end of what begins at a place and holds no tables: a comment, a string, #if 0 to its #endif. The place
// itself if nothing of that begins there.
size_t endOfOther(const std::string &text, size_t at) {
    auto after = [&](const char *end, size_t from) {
        size_t found = text.find(end, from);
        return found == text.npos ? text.size() : found + std::strlen(end);
    };
    if (text.compare(at, 2, "//") == 0) return after("\n", at);
    if (text.compare(at, 2, "/*") == 0) return after("*/", at + 2);
    if (text.compare(at, 5, "#if 0") == 0) return after("#endif", at);
    if (text[at] != '"') return at;
    while (++at < text.size() && text[at] != '"' && text[at] != '\n') at += text[at] == '\\';
    return std::min(at + 1, text.size());
}

// The text with blanks for all that.
std::string codeOf(const std::string &text) {
    std::string code = text;
    for (size_t at = 0, end; at < text.size(); at = std::max(end, at + 1))
        std::fill(code.begin() + (std::ptrdiff_t)at,
                  code.begin() + (std::ptrdiff_t)(end = endOfOther(text, at)), ' ');
    return code;
}

// Reads lists of C++ expressions in the code of a text.
class Reader {
public:
    Reader(const std::string &text, size_t at) : text(text), at(at) {}

    size_t place() {
        skip();
        return at;
    }
    bool take(char c) {
        skip();
        if (at >= text.size() || text[at] != c) return false;
        ++at;
        return true;
    }
    // An expression up to a comma or a bracket that is not its own; without blanks at its end.
    Span expression() {
        skip();
        Span s = {at, at};
        for (int depth = 0; at < text.size(); skip()) {
            char c = text[at];
            if (depth == 0 && (c == ',' || c == '}' || c == ')' || c == ';')) break;
            depth += c == '{' || c == '(' ? 1 : c == '}' || c == ')' ? -1 : 0;
            s.end = ++at;
        }
        return s;
    }

private:
    void skip() {
        while (at < text.size() && std::isspace((unsigned char)text[at])) ++at;
    }

    const std::string &text;
    size_t at;
};

// The numbers of a list in braces, which may hold lists itself; false if it is none.
bool readNumbers(const std::string &text, Reader &reader, std::vector<Span> &numbers) {
    if (!reader.take('{')) return false;
    while (!reader.take('}')) {
        if (text[reader.place()] == '{') {
            if (!readNumbers(text, reader, numbers)) return false;
        } else {
            Span s = reader.expression();
            if (s.end == s.begin) return false;
            numbers.push_back(s);
        }
        reader.take(',');
    }
    return true;
}

// The keys of a table, behind its opening brace.
bool readKeys(const std::string &text, Reader &reader, SourceTable &table) {
    while (!reader.take('}')) {
        Span whole = reader.expression();
        if (whole.end == whole.begin) return false;
        SourceKey key = {whole, {}};
        if (text[whole.begin] == '{') {
            Reader inner(text, whole.begin);
            if (!readNumbers(text, inner, key.numbers)) return false;
            if (key.numbers.size() != numbersIn(table.kind)) key.numbers.clear(); // the rest is 0
        }
        table.keys.push_back(key);
        reader.take(',');
    }
    return true;
}

void readArray(const std::string &text, size_t at, SourceTable table, bool nested,
               std::vector<SourceTable> &tables) {
    Reader reader(text, at);
    if (!nested) {
        if (readKeys(text, reader, table)) tables.push_back(table);
        return;
    }
    std::string name = table.name;
    for (int i = 0; !reader.take('}'); ++i) {
        table.name = name + "[" + std::to_string(i) + "]";
        table.keys.clear();
        if (!reader.take('{') || !readKeys(text, reader, table)) return;
        tables.push_back(table);
        reader.take(',');
    }
}

// --- What is written ---

std::string writtenKey(const SourceTable &table, const KeyNumbers &key, const std::string &qualifier) {
    std::string text = "{";
    for (size_t i = 0; i < key.size(); ++i) {
        bool path = table.kind == TableKind::Path;
        if (i) text += ", ";
        if (path && (i == 1 || i == 4)) text += "{";
        text += !path && i == 2 ? qualifier + kInterpolations[(int)key[i] & 1] : written(key[i]);
        if (path && (i == 3 || i == 6)) text += "}";
    }
    return text + "}";
}

// A row that is named keeps its name: `change` goes into what is added to it.
std::string movedRow(const std::string &row, float change, float now) {
    static const std::regex named(R"((\w+\(\w+\))(?:\s*([+-])\s*([0-9.]+)f?)?)");
    std::smatch part;
    if (!std::regex_match(row, part, named)) return written(now);
    float offset = part[3].matched ? std::strtof(part[3].str().c_str(), nullptr) : 0;
    if (part[2] == "-") offset = -offset;
    offset += change;
    if (offset == 0) return part[1];
    return part[1].str() + (offset < 0 ? " - " : " + ") + written(std::fabs(offset));
}

// Which of the keys before each key after comes from; -1: it is new. It changes as little as possible, and
// rather a key on its row than a key's row.
std::vector<int> matched(const std::vector<KeyNumbers> &before, const std::vector<KeyNumbers> &after) {
    size_t n = before.size(), m = after.size();
    auto cost = [&](size_t i, size_t j) {
        return before[i] == after[j] ? 0 : before[i][0] == after[j][0] ? 2 : 3;
    };
    constexpr int kNew = 2; // or gone; two of them are dearer than any change
    std::vector<std::vector<int>> least(n + 1, std::vector<int>(m + 1, 0));
    for (size_t i = n + 1; i-- > 0;)
        for (size_t j = m + 1; j-- > 0;) {
            if (i == n || j == m) {
                least[i][j] = kNew * (int)(n - i + m - j);
                continue;
            }
            least[i][j] =
                std::min({least[i + 1][j + 1] + cost(i, j), least[i + 1][j] + kNew, least[i][j + 1] + kNew});
        }
    std::vector<int> from(m, -1);
    for (size_t i = 0, j = 0; i < n && j < m;) {
        if (least[i][j] == least[i + 1][j + 1] + cost(i, j))
            from[j++] = (int)i++;
        else if (least[i][j] == least[i + 1][j] + kNew)
            ++i;
        else
            ++j;
    }
    return from;
}

} // namespace

KeyNumbers numbersOf(const Key &key) { return {key.row, key.value, (float)key.interpolation}; }
KeyNumbers numbersOf(const CameraKey &key) {
    return {key.row,      key.eye.x,    key.eye.y, key.eye.z, key.target.x,
            key.target.y, key.target.z, key.roll,  key.fov};
}
Key keyOf(const KeyNumbers &k) { return {k[0], k[1], (Interpolation)(int)k[2]}; }
CameraKey cameraKeyOf(const KeyNumbers &k) {
    return {k[0], {k[1], k[2], k[3]}, {k[4], k[5], k[6]}, k[7], k[8]};
}

std::string written(float number) {
    char text[40];
    for (int digits = 1; digits <= 9; ++digits) {
        std::snprintf(text, sizeof text, "%.*g", digits, (double)number);
        if (std::strtof(text, nullptr) == number) break;
    }
    bool whole = number == std::floor(number) && std::fabs(number) < 1e7f;
    if (whole) std::snprintf(text, sizeof text, "%.0f", (double)number + 0.0); // + 0: -0 is 0
    std::string s = text;
    return s.find_first_of(".e") == std::string::npos ? s : s + "f";
}

std::vector<SourceTable> findTables(const std::string &text) {
    // static constexpr Key kName[2][3] = {      static constexpr auto kName = coarse<8>({
    static const std::regex opening(
        R"(\bconstexpr\s+(?:(CameraKey|Key)\s+(\w+)\s*((?:\[[^\]]*\]\s*)+)=\s*\{|auto\s+(\w+)\s*=\s*coarse(?:<\s*(\d+)\s*>)?\s*\(\s*\{))");
    constexpr int kUsualBits = 8;
    std::vector<SourceTable> tables;
    const std::string code = codeOf(text);
    for (std::sregex_iterator m(code.begin(), code.end(), opening), end; m != end; ++m) {
        size_t inside = (size_t)(m->position() + m->length());
        if ((*m)[4].matched) {
            int bits = (*m)[5].matched ? std::atoi((*m)[5].str().c_str()) : kUsualBits;
            readArray(code, inside, {(*m)[4], TableKind::Path, bits, {}}, false, tables);
        } else {
            std::string sizes = (*m)[3];
            bool nested = std::count(sizes.begin(), sizes.end(), '[') == 2;
            TableKind kind = (*m)[1] == "Key" ? TableKind::Track : TableKind::Path;
            readArray(code, inside, {(*m)[2], kind, 0, {}}, nested, tables);
        }
    }
    return tables;
}

KeyNumbers rounded(const SourceTable &table, KeyNumbers key) {
    if (!table.bits) return key;
    constexpr size_t kCoarse[] = {1, 2, 3, 4, 5, 6, 8}; // all but row and roll, as coarse() in show/film.cpp
    uint32_t unit = 1u << (24 - table.bits);
    for (size_t i : kCoarse) {
        uint32_t bits;
        std::memcpy(&bits, &key[i], sizeof bits);
        bits = (bits + unit / 2) & -unit;
        std::memcpy(&key[i], &bits, sizeof bits);
    }
    return key;
}

std::string withKeys(const std::string &text, const SourceTable &table, const std::vector<KeyNumbers> &before,
                     const std::vector<KeyNumbers> &after) {
    if (before.size() != table.keys.size() || before.empty() || after.empty()) return text;
    // As the file names interpolations: with or without a qualifier
    bool qualified = text.find("using enum Interpolation") == std::string::npos;
    std::string qualifier = qualified ? "Interpolation::" : "";

    auto changed = [&](size_t i, const KeyNumbers &now) {
        const SourceKey &key = table.keys[i];
        std::string whole = text.substr(key.whole.begin, key.whole.end - key.whole.begin);
        if (before[i] == now) return whole;
        if (key.numbers.empty()) return writtenKey(table, now, qualifier);
        for (size_t k = now.size(); k-- > 0;) { // from the last on, so that the places before stay true
            if (before[i][k] == now[k]) continue;
            Span s = key.numbers[k];
            std::string old = text.substr(s.begin, s.end - s.begin);
            std::string fresh = k == 0 ? movedRow(old, now[0] - before[i][0], now[0]) : written(now[k]);
            if (table.kind == TableKind::Track && k == 2)
                fresh = qualifier + kInterpolations[(int)now[2] & 1];
            whole.replace(s.begin - key.whole.begin, s.end - s.begin, fresh);
        }
        return whole;
    };

    // What stands between keys is taken over with the key before it: a comma, a comment. Where that key goes,
    // its comments stay
    auto gap = [&](size_t i) {
        size_t end = table.keys[i].whole.end;
        return i + 1 < before.size() ? text.substr(end, table.keys[i + 1].whole.begin - end) : std::string();
    };
    auto comments = [](const std::string &gap) {
        size_t at = std::min(gap.find("//"), gap.find("/*"));
        return at == std::string::npos ? std::string() : " " + gap.substr(at);
    };
    std::vector<int> from = matched(before, after);
    std::string middle, next; // what stands in front of the next key
    size_t taken = 0;         // keys of the text that are behind us
    auto skipTo = [&](size_t i) {
        for (; taken < i; ++taken) next += comments(gap(taken));
    };
    for (size_t j = 0; j < after.size(); ++j) {
        if (from[j] >= 0) skipTo((size_t)from[j]);
        if (j && next.find(',') == std::string::npos) next = ", " + next;
        middle += next + (from[j] >= 0 ? changed(taken, after[j]) : writtenKey(table, after[j], qualifier));
        next = from[j] >= 0 ? gap(taken++) : "";
    }
    next = comments(next);
    skipTo(before.size());
    size_t begin = table.keys.front().whole.begin, end = table.keys.back().whole.end;
    bool comma = end < text.size() && text[end] == ',';
    if (comma) ++end;
    return text.substr(0, begin) + middle + (comma ? "," : "") + next + text.substr(end);
}

} // namespace odraz::maker
