#include "packer/report/report_html.h"

#include "packer/report/disassembly.h"
#include "report_page_body.h"
#include "report_page_script.h"
#include "report_page_style.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <zlib.h>

namespace pack {

namespace {

using nlohmann::json;

int64_t units(double bits) { return std::llround(bits * kUnit); }

// --- Tables: arrays of [name, bytes, units, units before or null, share in bytes or null] ---

class Table {
public:
    Table(const Page &page, const Report &report, Costs Report::*costs)
        : before(page.before && !(page.before->*costs).empty() ? page.before : nullptr) {
        const Costs &all = report.*costs;
        bool rooms = costs == &Report::rooms;
        auto old = [&](const std::string &name) {
            auto was = (before->*costs).find(name);
            return was == (before->*costs).end() ? 0 : was->second.bits;
        };
        auto share = [&](const std::string &name) {
            auto found = report.shares.find(name);
            return rooms && found != report.shares.end() ? json(found->second) : json();
        };
        for (auto &[name, cost] : all) {
            numbers[name] = numbers.size();
            add(name, cost.bytes, cost.bits, before ? old(name) : 0, share(name));
        }
        if (all.empty()) return;
        if (before)
            for (auto &[name, cost] : before->*costs)
                if (!all.count(name)) add(name, 0, 0, cost.bits, share(name));
        const std::string &room = report.stubRoom;
        std::string stub = rooms && !room.empty() && !all.count(room) ? room : kStub;
        add(stub, 0, 8.0 * (double)report.overhead, before ? 8.0 * (double)before->overhead : 0, share(stub));
        add("(end of the payload)", 0, report.rest, before ? restOf(costs) : 0, json());
    }
    // A name's row, or -1
    long number(const std::string &name) const {
        auto found = numbers.find(name);
        return found == numbers.end() ? -1 : (long)found->second;
    }
    json rows = json::array();

private:
    // Makes the earlier costs add up, even if parts overlapped in them
    double restOf(Costs Report::*costs) const {
        double bits = 8.0 * (double)(before->fileSize - before->overhead);
        for (auto &[name, cost] : before->*costs) bits -= cost.bits;
        return bits;
    }
    void add(const std::string &name, uint64_t bytes, double bits, double was, const json &share) {
        rows.push_back({name, bytes, units(bits), before ? json(units(was)) : json(), share});
    }
    const Report *before;
    std::unordered_map<std::string, size_t> numbers;
};

// --- Bytes and instructions ---

// Costs as bytes, and those that do not fit as [[offset, units], ...].
Bytes lowCosts(const Report &report, json &high) {
    Bytes low;
    for (size_t i = 0; i < report.sixteenths.size(); ++i) {
        uint16_t cost = report.sixteenths[i];
        low.push_back((uint8_t)std::min<uint16_t>(cost, 255));
        if (cost >= 255) high.push_back({i, cost});
    }
    return low;
}

// The program's instructions, by objdump: the number of each one's form, the forms, and the runs of
// instructions without gaps as [[offset, number of instructions], ...].
struct Code {
    Bytes numbers;
    json forms = json::array(), runs = json::array();
    size_t instructions = 0;
};
Code readCode(const char *path, const Program &program) {
    struct Place {
        uint32_t begin, size, form;
    };
    std::vector<Place> places;
    std::unordered_map<std::string, uint32_t> known;
    std::vector<std::pair<uint32_t, const std::string *>> forms; // count, form
    disassemble(path, [&](const Instruction &i) {
        uint64_t begin = i.address - program.base, all = program.bytes.size();
        // Leave out what is not part of the program in memory
        if (begin >= all || all - begin < i.bytes.size() ||
            std::memcmp(&program.bytes[begin], i.bytes.data(), i.bytes.size()))
            return;
        auto [form, added] = known.try_emplace(formOf(i), (uint32_t)forms.size());
        if (added) forms.push_back({0, &form->first});
        ++forms[form->second].first;
        places.push_back({(uint32_t)begin, (uint32_t)i.bytes.size(), form->second});
    });
    std::stable_sort(places.begin(), places.end(),
                     [](const Place &a, const Place &b) { return a.begin < b.begin; });
    // The most frequent forms get the lowest numbers
    std::vector<uint32_t> order(forms.size()), numbers(forms.size());
    for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](uint32_t a, uint32_t b) { return forms[a].first > forms[b].first; });
    Code code;
    for (uint32_t i = 0; i < order.size(); ++i) {
        numbers[order[i]] = i;
        code.forms.push_back(*forms[order[i]].second);
    }
    uint32_t end = 0, run = 0, count = 0;
    auto endRun = [&] {
        if (count) code.runs.push_back({run, count});
        count = 0;
    };
    for (const Place &p : places) {
        if (p.begin < end) continue; // sections that overlap
        if (p.begin != end || !count) {
            endRun();
            run = p.begin;
        }
        end = p.begin + p.size;
        ++count;
        ++code.instructions;
        uint32_t number = numbers[p.form];
        for (; number > 127; number >>= 7) code.numbers.push_back((uint8_t)(number | 128));
        code.numbers.push_back((uint8_t)number);
    }
    endRun();
    return code;
}

// [begin, bytes, units, and the rows of the tables: section, object or -1, room or -1, symbol]
json stretches(const Report &report, const Table &sections, const Table &objects, const Table &rooms,
               const Table &symbols) {
    json all = json::array();
    for (const Stretch &s : report.stretches) {
        uint64_t cost = 0;
        for (uint32_t i = s.begin; i < s.begin + s.size; ++i) cost += report.sixteenths[i];
        all.push_back({s.begin, s.size, cost, sections.number(s.section), objects.number(s.object),
                       rooms.number(s.room), symbols.number(s.symbol)});
    }
    return all;
}

Bytes deflate(const Bytes &bytes) {
    uLongf size = compressBound(bytes.size());
    Bytes packed(size);
    if (compress(packed.data(), &size, bytes.data(), bytes.size()) != Z_OK)
        throw std::runtime_error("zlib cannot pack the page's data");
    packed.resize(size);
    return packed;
}

std::string base64(const Bytes &bytes) {
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t three = 0;
        for (size_t k = 0; k < 3; ++k) three = three << 8 | (i + k < bytes.size() ? bytes[i + k] : 0);
        for (size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? kDigits[three >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::string element(const char *id, const Bytes &data) {
    return std::string("<script type=\"application/octet-stream\" id=\"") + id + "\">" +
           base64(deflate(data)) + "</script>\n";
}
template <size_t N> std::string text(const unsigned char (&bytes)[N]) { return {bytes, bytes + N}; }

} // namespace

std::string printHtml(const Page &page, const Report &report, const Program &program) {
    Table sections(page, report, &Report::sections), objects(page, report, &Report::objects),
        rooms(page, report, &Report::rooms), symbols(page, report, &Report::symbols);
    bool shown = program.bytes.size() <= kMostShown;
    json high = json::array();
    Bytes low = lowCosts(report, high);
    Code code;
    if (shown) code = readCode(page.path.c_str(), program);
    json tables = {
        {"name", page.name},
        {"file", report.fileSize},
        {"budget", page.budget},
        {"base", program.base},
        {"size", program.bytes.size()},
        {"unit", kUnit},
        {"shown", shown},
        {"before", page.before ? json{{"name", page.beforeName}, {"file", page.before->fileSize}} : json()},
        {"rooms", rooms.rows},
        {"objects", objects.rows},
        {"sections", sections.rows},
        {"symbols", symbols.rows},
        {"stretches", stretches(report, sections, objects, rooms, symbols)},
        {"high", shown ? high : json::array()},
        {"forms", code.forms},
        {"runs", code.runs},
        {"instructions", code.instructions},
    };
    std::string printed = tables.dump(-1, ' ', false, json::error_handler_t::replace);
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>What it "
           "costs</title>\n"
           "<meta name=\"viewport\" content=\"width=device-width\">\n<style>\n" +
           text(kReportPageStyle) + "</style>\n</head>\n<body>\n" + text(kReportPageBody) +
           element("tables", {printed.begin(), printed.end()}) +
           element("bytes", shown ? program.bytes : Bytes()) + element("costs", shown ? low : Bytes()) +
           element("code", code.numbers) + "<script>\n" + text(kReportPageScript) +
           "</script>\n</body>\n</html>\n";
}

} // namespace pack
