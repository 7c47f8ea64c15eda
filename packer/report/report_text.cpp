// Two reports as text: the costs of the parts, and a summary of a change (the total and the largest changes).
#include "packer/report/report.h"
#include "tools/common/text.h"

#include <algorithm>
#include <cmath>

namespace pack {

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

struct PartKind {
    const char *name;
    Costs Report::*costs;
};
// Returns the smallest kind of parts that both reports have.
PartKind finest(const Report &report, const Report *before) {
    for (PartKind kind : {PartKind{"symbol", &Report::symbols}, PartKind{"object file", &Report::objects}})
        if (hasNames(report.*kind.costs) && (!before || hasNames(before->*kind.costs))) return kind;
    return {"section", &Report::sections};
}

} // namespace

std::string printReport(const Report &report) {
    return printCosts(report.objects, "object", SIZE_MAX) +
           printCosts(report.symbols, "the 20 costliest symbols", 20);
}

std::string printMarkdown(const std::string &name, const Report &report, const Report *before, long budget) {
    std::string text = headline(name, (double)report.fileSize, before, (double)budget);
    PartKind kind = finest(report, before);
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
