#include "packer/report/report.h"

#include "tools/common/text.h"

#include <algorithm>
#include <sstream>

namespace pack {

bool hasNames(const Costs &costs) {
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
        uint64_t units = 0;
        for (uint32_t i = s.begin; i < s.begin + s.size; ++i) units += report.sixteenths[i];
        auto count = [&](Costs &costs, const std::string &name) {
            if (name.empty()) return;
            costs[name].bytes += s.size;
            costs[name].bits += (double)units / kUnit;
        };
        count(report.sections, s.section);
        count(report.objects, s.object);
        count(report.rooms, s.room);
        count(report.symbols, s.symbol);
        all += (double)units / kUnit;
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

namespace {

std::string quote(const std::string &text) {
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

} // namespace

std::string printJson(const Report &report) {
    double payload = 8.0 * (double)(report.fileSize - report.overhead);
    std::string text =
        common::format("{\n\"file\": %zu,\n\"overhead\": %zu,\n\"rest\": %.0f", report.fileSize,
                       report.overhead, payload - std::round(payload - report.rest));
    auto part = [&](const char *name, const Costs &costs, bool withRooms) {
        Rounding rounding;
        common::append(text, ",\n\"%s\": {", name);
        const char *separator = "\n";
        for (auto &[key, cost] : costs) {
            text += separator + quote(key);
            common::append(text, ": {\"bytes\": %llu, \"bits\": %.0f", (unsigned long long)cost.bytes,
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

} // namespace pack
