#include "maker/keys/key_file.h"

#include "timeline/key_bits.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace odraz::maker {

namespace {

constexpr const char *kInterpolations[] = {"Linear", "Smooth"};

// Scans a line from left to right.
struct Scanner {
    const char *at;

    bool take(const std::string &token) {
        while (*at == ' ' || *at == '\t') ++at;
        bool here = std::string(at).compare(0, token.size(), token) == 0;
        if (here) at += token.size();
        return here;
    }
    void need(const std::string &token) {
        if (!take(token)) throw std::runtime_error("expected '" + token + "' at '" + at + "'");
    }
    bool atEnd() { return take("") && !*at; }
    std::string name() {
        take("");
        const char *begin = at;
        while (std::isalnum((unsigned char)*at) || *at == '_') ++at;
        return {begin, at};
    }
    float number() {
        take("");
        double number;
        auto [end, error] = std::from_chars(at, at + std::string(at).size(), number);
        if (error != std::errc() || !std::isfinite((float)number))
            throw std::runtime_error("expected a number at '" + std::string(at) + "'");
        at = end;
        return (float)number; // rounded from a double, as the compiler does
    }
    void numbers(int count, KeyNumbers &to) {
        for (int i = 0; i < count; ++i) {
            if (i) need(",");
            to.push_back(number());
        }
    }
    float row(const Events &events, std::string &event) {
        if (!take("rowOf(")) return number();
        event = name();
        need(")");
        if (!events.count(event)) throw std::runtime_error("there is no event '" + event + "'");
        float row = events.at(event);
        return take("+") ? row + number() : take("-") ? row - number() : row;
    }
    KeyNumbers key(bool camera, const Events &events, std::string &event) {
        need("{");
        KeyNumbers key = {row(events, event)};
        need(",");
        for (int i = 0; camera && i < 2; ++i) {
            need("{");
            numbers(3, key);
            need("}");
            need(",");
        }
        numbers(camera ? 2 : 1, key);
        if (!camera) {
            need(",");
            std::string kind = name();
            auto known = std::find(std::begin(kInterpolations), std::end(kInterpolations), kind);
            if (known == std::end(kInterpolations))
                throw std::runtime_error("expected Linear or Smooth, not '" + kind + "'");
            key.push_back((float)(known - kInterpolations));
        }
        need("}");
        need(",");
        return key;
    }
};

// Returns the index of the old key that each new key replaces, -1: none. Matches by row or the key before.
std::vector<int> originsOf(const std::vector<KeyNumbers> &before, const std::vector<KeyNumbers> &after) {
    std::vector<int> from(after.size(), -1);
    std::vector<bool> used(before.size() + 1, false);
    used.back() = true;
    for (size_t i = 0, j = 0; j < after.size(); ++j) {
        while (i < before.size() && before[i][0] < after[j][0]) ++i;
        if (i == before.size() || before[i][0] != after[j][0]) continue;
        used[i] = true;
        from[j] = (int)i++;
    }
    for (size_t j = 0, next = 0; j < after.size(); ++j) {
        if (from[j] < 0 && !used[next]) {
            from[j] = (int)next;
            used[next] = true;
        }
        if (from[j] >= 0) next = (size_t)from[j] + 1;
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
    char text[32];
    auto format = std::fabs(number) < 1e7f ? std::chars_format::general : std::chars_format::scientific;
    std::string shortest(text, std::to_chars(text, text + sizeof text, number + 0.f, format).ptr); // no -0
    return shortest;
}

std::string writtenKey(const KeyNumbers &k, const std::string &row) {
    std::string text = "{" + row + ", ";
    if (k.size() == 3) return text + written(k[1]) + ", " + kInterpolations[(int)k[2] & 1] + "},";
    for (size_t i = 1; i < 7; i += 3)
        text += "{" + written(k[i]) + ", " + written(k[i + 1]) + ", " + written(k[i + 2]) + "}, ";
    return text + written(k[7]) + ", " + written(k[8]) + "},";
}

KeyNumbers KeyFile::Table::rounded(const KeyNumbers &key) const {
    return camera ? numbersOf(withBits(cameraKeyOf(key), bits)) : key;
}

KeyFile::KeyFile(const std::string &name, const std::string &text, const Events &rows) : events(rows) {
    std::istringstream in(text);
    bool open = false;
    for (std::string words; std::getline(in, words); lines.back().text = words) {
        Line &line = lines.emplace_back();
        size_t slashes = std::min(words.find("//"), words.size());
        line.comment = words.substr(slashes);
        std::string code = words.substr(0, slashes);
        Scanner s = {code.c_str()};
        try {
            if (s.atEnd()) continue;
            bool track = !open && s.take("TRACK("), path = !open && !track && s.take("PATH(");
            if (track || path) {
                Table &table = all.emplace_back(Table{s.name(), path});
                if (path) s.need(","), table.bits = (int)s.number();
                if (track && s.take(",")) s.row(events, line.event);
                s.need(")");
                open = true;
            } else if (!open) {
                throw std::runtime_error("expected TRACK(name) or PATH(name, bits)");
            } else if (s.take("END")) {
                if (all.back().keys.empty()) throw std::runtime_error("the table has no keys");
                open = false;
            } else {
                line.table = all.size() - 1;
                line.numbers = all.back().rounded(s.key(all.back().camera, events, line.event));
                std::vector<KeyNumbers> &keys = all.back().keys;
                if (!keys.empty() && keys.back()[0] > line.numbers[0])
                    throw std::runtime_error("rows must ascend");
                keys.push_back(line.numbers);
            }
            if (!s.atEnd()) throw std::runtime_error("unexpected '" + std::string(s.at) + "'");
        } catch (const std::runtime_error &e) {
            throw std::runtime_error(name + ":" + std::to_string(lines.size()) + ": " + e.what());
        }
    }
    if (open) throw std::runtime_error(name + ": END is missing");
}

// Rewrites a line, unless its numbers are the same.
void KeyFile::write(Line &line, const KeyNumbers &numbers) const {
    if (line.numbers == numbers) return;
    std::string row = written(numbers[0]);
    if (!line.event.empty()) {
        float offset = numbers[0] - events.at(line.event);
        row = "rowOf(" + line.event + ")";
        if (offset != 0) row += (offset < 0 ? " - " : " + ") + written(std::fabs(offset));
    }
    line.numbers = numbers;
    line.text = "    " + writtenKey(numbers, row) + (line.comment.empty() ? "" : " " + line.comment);
}

void KeyFile::set(size_t table, const std::vector<KeyNumbers> &keys) {
    std::vector<int> from = originsOf(all[table].keys, keys);
    std::vector<size_t> keyLines; // indices of the table's lines
    for (size_t i = 0; i < lines.size(); ++i)
        if (lines[i].table == table) keyLines.push_back(i);
    std::vector<Line> now;
    size_t done = 0;
    auto copyUpTo = [&](size_t end) { // copies lines, but only the comments of this table's keys
        for (; done < end; ++done) {
            const Line &line = lines[done];
            if (line.table != table)
                now.push_back(line);
            else if (!line.comment.empty())
                now.push_back({"    " + line.comment});
        }
    };
    copyUpTo(keyLines[0]);
    for (size_t j = 0; j < keys.size(); ++j) {
        if (from[j] >= 0) copyUpTo(keyLines[(size_t)from[j]]);
        Line line = from[j] >= 0 ? lines[done++] : Line{{}, table};
        write(line, keys[j]);
        now.push_back(line);
    }
    copyUpTo(lines.size());
    lines = std::move(now);
    all[table].keys = keys;
}

std::string KeyFile::text() const {
    std::string text;
    for (const Line &line : lines) text += line.text + "\n";
    return text;
}

} // namespace odraz::maker
