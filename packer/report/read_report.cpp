// Reads reports from JSON.
#include "packer/report/report_html.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace pack {

using nlohmann::json;

Report readJson(const std::string &text) {
    constexpr char kNoReport[] = "not a report of pack: --report FILE writes one";
    constexpr double kMostBytes = 1e15;
    Report report;
    need(text.find('\0') == text.npos, kNoReport); // the parser would stop there
    try {
        json all = json::parse(text);
        auto read = [&](const char *part, Costs &costs) {
            json parts = all.value(part, json::object());
            for (auto &[name, given] : parts.items()) {
                Cost &cost = costs[isWholeProgram(name) ? kWholeProgram : name];
                cost.bytes = (uint64_t)std::clamp(given.value("bytes", 0.0), 0.0, kMostBytes);
                cost.bits = given.value("bits", 0.0);
                if (given.contains("room")) report.roomOf[name] = given["room"];
            }
        };
        double file = all.at("file"), overhead = all.at("overhead");
        report.rest = all.value("rest", 0.0);
        read("sections", report.sections);
        read("objects", report.objects);
        read("symbols", report.symbols);
        need(file > 0 && file < kMostBytes && overhead >= 0 && overhead <= file && !report.sections.empty(),
             kNoReport);
        report.fileSize = (size_t)file;
        report.overhead = (size_t)overhead;
    } catch (const json::exception &) {
        throw common::Refused(kNoReport);
    }
    return report;
}

} // namespace pack
