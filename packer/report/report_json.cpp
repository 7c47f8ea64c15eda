// Reports as JSON, written without a library, because the film's build needs none. read_report.cpp reads
// them.
#include "packer/report/report.h"
#include "tools/common/text.h"

namespace pack {

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
