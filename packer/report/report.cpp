#include "packer/report/report.h"

#include "tools/common/text.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pack {

// Whether any part has a name of its own.
static bool hasNames(const Costs &costs) {
    return std::any_of(costs.begin(), costs.end(),
                       [](auto &cost) { return cost.first.rfind("(nothing named", 0) != 0; });
}

Rooms readRooms(const std::string &text) {
    constexpr long kMostBytes = 1L << 40;
    Rooms rooms;
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::istringstream words(line);
        std::string room, share, object;
        if (!(words >> room) || room[0] == '#') continue;
        words >> share;
        char *end;
        long bytes = std::strtol(share.c_str(), &end, 10);
        need(share == "-" || (!share.empty() && !*end && bytes >= 0 && bytes <= kMostBytes),
             "line " + std::to_string(number) + ": it needs ROOM SHARE OBJECT..., SHARE in bytes or -");
        if (share != "-") rooms.shares[room] = bytes;
        while (words >> object) rooms.of[object] = room;
    }
    need(!rooms.of.empty(), "no room has an object file: write lines ROOM SHARE OBJECT...");
    return rooms;
}

Report makeReport(std::vector<Stretch> stretches, const std::vector<float> &bits, size_t fileSize,
                  size_t overhead, const Rooms *rooms) {
    Report report;
    report.fileSize = fileSize;
    report.overhead = overhead;
    Rounding rounding;
    for (float b : bits) report.sixteenths.push_back((uint16_t)rounding(b * kUnit));
    if (rooms) {
        report.shares = rooms->shares;
        report.roomOf = rooms->of; // includes objects of earlier builds
        auto stub = rooms->of.find(kStub);
        if (stub != rooms->of.end()) report.stubRoom = stub->second;
    }
    double all = 0;
    for (Stretch &s : stretches) {
        if (rooms) {
            auto room = rooms->of.find(s.object);
            s.room = room == rooms->of.end() ? kNothingNamed : room->second;
        }
        if (!s.object.empty()) report.roomOf.emplace(s.object, s.room);
        for (uint32_t i = s.begin; i < s.begin + s.size; ++i) s.units += report.sixteenths[i];
        for (const PartKind &kind : kPartKinds) {
            if ((s.*kind.part).empty()) continue;
            Cost &cost = (report.*kind.costs)[s.*kind.part];
            cost.bytes += s.size;
            cost.bits += (double)s.units / kUnit;
        }
        all += (double)s.units / kUnit;
    }
    report.rest = 8.0 * (double)(fileSize - overhead) - all;
    report.stretches = std::move(stretches);
    return report;
}

void arrange(Report &before, const Report &now) {
    before.rooms.clear();
    for (auto &[object, cost] : before.objects) {
        const auto &roomOf = now.roomOf.count(object) ? now.roomOf : before.roomOf;
        Cost &room = before.rooms[roomOf.count(object) ? roomOf.at(object) : kNothingNamed];
        room.bytes += cost.bytes;
        room.bits += cost.bits;
    }
}

static std::string quote(const std::string &text) {
    std::string quoted = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        if ((unsigned char)c < ' ')
            common::append(quoted, "\\u%04x", (unsigned)c);
        else
            quoted += c;
    }
    return quoted + "\"";
}

std::string printJson(const Report &report) {
    double payload = 8.0 * (double)(report.fileSize - report.overhead);
    std::string text =
        common::format("{\n\"file\": %zu,\n\"overhead\": %zu,\n\"rest\": %.0f", report.fileSize,
                       report.overhead, payload - std::round(payload - report.rest));
    for (const PartKind &kind : kPartKinds) {
        if (kind.costs == &Report::rooms) continue; // objects have them
        Rounding rounding;
        common::append(text, ",\n\"%s\": {", kind.table);
        const char *separator = "\n";
        for (auto &[key, cost] : report.*kind.costs) {
            text += separator + quote(key);
            common::append(text, ": {\"bytes\": %llu, \"bits\": %.0f", (unsigned long long)cost.bytes,
                           rounding(cost.bits));
            if (kind.costs == &Report::objects) text += ", \"room\": " + quote(report.roomOf.at(key));
            text += "}";
            separator = ",\n";
        }
        text += "\n}";
    }
    return text + "\n}\n";
}

namespace {

constexpr size_t kMost = 10;
constexpr double kLeastChange = 4; // bytes

using common::thousands;

std::string change(double value) { return (std::round(value) >= 0 ? "+" : "") + thousands(value); }

// The cost of a part in the new report and in the earlier one.
struct CostChange {
    std::string name;
    double now, was; // packed bytes
};
std::vector<CostChange> compare(const Costs &now, const Costs &was) {
    std::map<std::string, CostChange> all;
    for (auto &[name, cost] : now) all[name] = {name, cost.bits / 8, 0};
    for (auto &[name, cost] : was) {
        all[name].name = name;
        all[name].was = cost.bits / 8;
    }
    std::vector<CostChange> changes;
    for (auto &[name, c] : all) changes.push_back(c);
    std::stable_sort(changes.begin(), changes.end(), [](const CostChange &a, const CostChange &b) {
        return std::abs(a.now - a.was) > std::abs(b.now - b.was);
    });
    return changes;
}

std::string shorten(std::string text, size_t width) {
    if (text.size() > width) text.replace(width - 3, std::string::npos, "...");
    return text;
}

std::string printCosts(const Costs &all, const char *title, size_t most) {
    if (!hasNames(all)) return "";
    std::vector<CostChange> parts = compare(all, {});
    parts.resize(std::min(parts.size(), most));
    std::string text = common::format("%-60s %7s %7s\n", title, "packed", "before");
    for (const CostChange &part : parts)
        common::append(text, "%-60s %7.0f %7llu\n", shorten(part.name, 60).c_str(), part.now,
                       (unsigned long long)all.at(part.name).bytes);
    return text;
}

// Returns a text as code in a cell of a Markdown table. Replaces | and `, which a cell must not contain.
std::string cell(std::string text) {
    text = shorten(text, 90);
    std::replace(text.begin(), text.end(), '|', '/');
    std::replace(text.begin(), text.end(), '`', '\'');
    return "`" + text + "`";
}

std::string headline(const std::string &name, double now, const Report *before, double budget) {
    std::string text = "**" + cell(name) + ": " + thousands(now) + " bytes**";
    if (before) {
        auto was = (double)before->fileSize;
        text +=
            ", " + change(now - was) + common::format(" (%+.2f %%)", was > 0 ? 100 * (now - was) / was : 0);
    }
    if (budget >= 0)
        text += (now > budget ? ", **over budget by " + thousands(now - budget) + "**"
                              : ", " + thousands(budget - now) + " left") +
                " of " + thousands(budget);
    return text + "\n\n";
}

// Returns the smallest kind of parts that both reports have.
const PartKind &finest(const Report &report, const Report *before) {
    const PartKind *kind = std::end(kPartKinds) - 1;
    auto named = [&](const Report &r) { return hasNames(r.*kind->costs); };
    while (kind->costs != &Report::sections && !(named(report) && (!before || named(*before)))) --kind;
    return *kind;
}

} // namespace

std::string printReport(const Report &report) {
    return printCosts(report.objects, "object", SIZE_MAX) +
           printCosts(report.symbols, "the 20 costliest symbols", 20);
}

std::string printMarkdown(const std::string &name, const Report &report, const Report *before, long budget) {
    std::string text = headline(name, (double)report.fileSize, before, (double)budget);
    const PartKind &kind = finest(report, before);
    Costs now = report.*kind.costs, was = before ? before->*kind.costs : Costs();
    now[kStub].bits = 8.0 * (double)report.overhead;
    if (before) was[kStub].bits = 8.0 * (double)before->overhead;
    std::vector<CostChange> changes = compare(now, was);
    // A changed byte slightly changes the costs of other bytes, so changes below kLeastChange mean nothing
    double least = before ? kLeastChange : 0.5;
    std::erase_if(changes, [&](const CostChange &c) { return std::abs(c.now - c.was) < least; });
    if (changes.empty()) return text + "No " + kind.name + " changed by four bytes or more.\n";
    if (changes.size() > kMost) changes.resize(kMost);
    text += before ? "|   change |      now |      was | " : "|   packed | ";
    text += kind.name;
    text += before ? " |\n|---------:|---------:|---------:|---|\n" : " |\n|---------:|---|\n";
    for (const CostChange &c : changes) {
        if (before)
            text += common::format("| %8s | %8s | %8s | ", change(c.now - c.was).c_str(),
                                   thousands(c.now).c_str(), thousands(c.was).c_str());
        else
            text += common::format("| %8s | ", thousands(c.now).c_str());
        text += cell(c.name) + " |\n";
    }
    return text;
}

} // namespace pack
