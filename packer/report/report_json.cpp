// Reports as JSON, written and read.
#include "packer/report/report.h"

#include <cmath>
#include <cstdlib>

namespace pack {

namespace {

// Rounds numbers so that their sum is rounded, too: what one gains, another loses.
class Rounding {
public:
    double operator()(double value) {
        double before = std::round(sum);
        sum += value;
        return std::round(sum) - before;
    }

private:
    double sum = 0;
};

// Reads JSON of objects, strings and numbers, which is all that a report has.
class Reader {
public:
    explicit Reader(const std::string &text) : at(text.c_str()), end(at + text.size()) {}
    // Calls read(key) for each member; it must read the value.
    template <class Read> void object(Read read) {
        take('{');
        if (next() == '}') return take('}');
        for (;;) {
            std::string key = string();
            take(':');
            read(key);
            if (next() != ',') break;
            take(',');
        }
        take('}');
    }
    std::string string() {
        take('"');
        std::string text;
        for (; at < end && *at != '"'; ++at) {
            need(*at != '\\' || at + 1 < end, kForeign);
            if (*at == '\\' && *++at == 'u') {
                need(end - at > 4, kForeign);
                text +=
                    (char)std::strtol(std::string(at + 1, 4).c_str(), nullptr, 16); // quote() makes no others
                at += 4;
            } else
                text += *at;
        }
        take('"');
        return text;
    }
    double number() {
        next();
        char *after;
        double value = std::strtod(at, &after);
        need(after != at && std::abs(value) < 1e15, kForeign);
        at = after;
        return value;
    }
    // Whatever it is: what later reports may have.
    void skip(int depth = 0) {
        need(depth < 10, kForeign);
        if (next() == '"')
            string();
        else if (*at == '{')
            object([&](const std::string &) { skip(depth + 1); });
        else
            number();
    }
    void finish() { need(next() == 0 && at == end, kForeign); }

    static constexpr char kForeign[] = "not a report of pack: --report FILE writes one";

private:
    char next() {
        while (at < end && (*at == ' ' || *at == '\n' || *at == '\t' || *at == '\r')) ++at;
        return *at; // a string ends with a 0
    }
    void take(char c) {
        if (c != '"' || at >= end || *at != '"') next();
        need(at < end && *at == c, kForeign);
        ++at;
    }
    const char *at, *end;
};

} // namespace

std::string quote(const std::string &text) {
    std::string quoted = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        if ((unsigned char)c < ' ')
            quoted += format("\\u%04x", (unsigned)c);
        else
            quoted += c;
    }
    return quoted + "\"";
}

std::string printJson(const Report &report) {
    double payload = 8.0 * (double)(report.fileSize - report.overhead);
    std::string text = format("{\n\"file\": %zu,\n\"overhead\": %zu,\n\"rest\": %.0f", report.fileSize,
                              report.overhead, payload - std::round(payload - report.rest));
    auto part = [&](const char *name, const Costs &costs, bool withRooms) {
        Rounding rounding;
        text += format(",\n\"%s\": {", name);
        const char *separator = "\n";
        for (auto &[key, cost] : costs) {
            text += separator + quote(key) +
                    format(": {\"bytes\": %llu, \"bits\": %.0f", (unsigned long long)cost.bytes,
                           rounding(cost.bits));
            if (withRooms) text += ", \"room\": " + quote(report.roomOf.at(key));
            text += "}";
            separator = ",\n";
        }
        text += "\n}";
    };
    part("sections", report.sections, false);
    part("objects", report.objects, true);
    part("symbols", report.symbols, false);
    return text + "\n}\n";
}

Report readJson(const std::string &text) {
    Report report;
    Reader reader(text);
    double file = -1, overhead = -1;
    auto costs = [&](Costs &all) {
        reader.object([&](const std::string &name) {
            Cost &cost = all[isWholeProgram(name) ? kWholeProgram : name];
            reader.object([&](const std::string &key) {
                if (key == "bytes")
                    cost.bytes = (uint64_t)std::max(0.0, reader.number());
                else if (key == "bits")
                    cost.bits = reader.number();
                else if (key == "room")
                    report.roomOf[name] = reader.string();
                else
                    reader.skip();
            });
        });
    };
    reader.object([&](const std::string &key) {
        if (key == "file")
            file = reader.number();
        else if (key == "overhead")
            overhead = reader.number();
        else if (key == "rest")
            report.rest = reader.number();
        else if (key == "sections")
            costs(report.sections);
        else if (key == "objects")
            costs(report.objects);
        else if (key == "symbols")
            costs(report.symbols);
        else
            reader.skip();
    });
    reader.finish();
    need(file > 0 && overhead >= 0 && overhead <= file && !report.sections.empty(), Reader::kForeign);
    report.fileSize = (size_t)file;
    report.overhead = (size_t)overhead;
    return report;
}

} // namespace pack
