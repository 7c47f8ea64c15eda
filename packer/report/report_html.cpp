#include "packer/report/report_html.h"

#include "report_page_body.h"
#include "report_page_script.h"
#include "report_page_style.h"
#include "tools/common/text.h"
#include "tools/common/whole_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <zlib.h>

namespace pack {

namespace {

using nlohmann::json;

// Returns the text in Intel's syntax; after " # " the address of an operand relative to rip. Removes the
// symbol and aligning spaces from "mov    eax,DWORD PTR [rip+0x10]        # 404010 <name>".
std::string tidy(const std::string &line) {
    std::istringstream words(line.substr(0, line.find('<')));
    std::string text;
    for (std::string word; words >> word;) text += (text.empty() ? "" : " ") + word;
    return text;
}

// Returns the program's instructions for the page's element "code"; none if objdump (binutils) is missing.
std::string readCode(const std::string &path, const Program &program) {
    std::map<uint64_t, std::string> all; // a line of each instruction, by offset
    std::istringstream lines(
        common::outputOf("objdump -d -w -z -M intel -- " + common::shellWord(path) + " 2>/dev/null"));
    // "  404a10:\t48 89 e5             \tmov    rbp,rsp"
    for (std::string line; std::getline(lines, line);) {
        size_t numbersAt = line.find(":\t"), text = line.find('\t', numbersAt + 2);
        if (line[0] != ' ' || numbersAt == line.npos) continue;
        Bytes bytes;
        std::istringstream numbers(line.substr(numbersAt + 2, text - numbersAt - 2));
        for (unsigned byte; numbers >> std::hex >> byte;) bytes.push_back((uint8_t)byte);
        uint64_t begin = std::strtoull(line.c_str(), nullptr, 16) - program.base, size = program.bytes.size();
        // Leave out instructions that are not in the program's memory
        if (!bytes.empty() && bytes.size() <= 15 && begin < size && size - begin >= bytes.size() &&
            std::equal(bytes.begin(), bytes.end(), &program.bytes[begin]))
            all.emplace(begin, common::format("%zx", bytes.size()) +
                                   (text == line.npos ? "" : tidy(line.substr(text))));
    }
    std::string code;
    uint64_t end = 0;
    for (auto &[begin, line] : all) {
        if (begin < end) continue; // sections overlap
        if (begin != end) common::append(code, "@%llx\n", (unsigned long long)begin);
        code += line + "\n";
        end = begin + std::stoul(line.substr(0, 1), nullptr, 16);
    }
    return code;
}

// Returns the size of an earlier report, and the units of each part; null for parts that it does not have.
json earlier(const ReportPage &page) {
    if (!page.before) return {};
    const Report &before = *page.before;
    json all = {{"name", page.beforeName}, {"file", before.fileSize}, {"overhead", before.overhead}};
    for (const PartKind &kind : kPartKinds) {
        json &units = all[kind.table] = nullptr;
        for (auto &[name, cost] : before.*kind.costs) units[name] = std::llround(cost.bits * kUnit);
    }
    return all;
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
    uLongf size = compressBound(data.size());
    Bytes packed(size);
    if (compress2(packed.data(), &size, data.data(), data.size(), Z_BEST_COMPRESSION) != Z_OK)
        throw std::runtime_error("zlib cannot pack the page's data");
    packed.resize(size);
    return std::string("<script type=\"application/octet-stream\" id=\"") + id + "\">" + base64(packed) +
           "</script>\n";
}
template <size_t N> std::string text(const unsigned char (&bytes)[N]) { return {bytes, bytes + N}; }

} // namespace

std::string printHtml(const ReportPage &page, const Report &report, const Program &program) {
    bool shown = program.bytes.size() <= kMostShown;
    json high = json::array(); // all costs of 255 or more: [[offset, units], ...]
    Bytes low;
    for (size_t i = 0; shown && i < report.sixteenths.size(); ++i) {
        uint16_t cost = report.sixteenths[i];
        low.push_back((uint8_t)std::min<uint16_t>(cost, 255));
        if (cost >= 255) high.push_back({i, cost});
    }
    json stretches = json::array();
    for (const Stretch &s : report.stretches)
        stretches.push_back({s.begin, s.size, s.units, s.section, s.object, s.room, s.symbol});
    std::string code = shown ? readCode(page.path, program) : "";
    json tables = {
        {"name", page.name},
        {"file", report.fileSize},
        {"overhead", report.overhead},
        {"budget", page.budget},
        {"base", program.base},
        {"size", program.bytes.size()},
        {"unit", kUnit},
        {"shown", shown},
        {"before", earlier(page)},
        {"shares", report.shares},
        {"stubRoom", report.stubRoom},
        {"stretches", stretches},
        {"high", high},
    };
    std::string printed = tables.dump(-1, ' ', false, json::error_handler_t::replace);
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>What it "
           "costs</title>\n"
           "<meta name=\"viewport\" content=\"width=device-width\">\n<style>\n" +
           text(kReportPageStyle) + "</style>\n</head>\n<body>\n" + text(kReportPageBody) +
           element("tables", {printed.begin(), printed.end()}) +
           element("bytes", shown ? program.bytes : Bytes()) + element("costs", low) +
           element("code", {code.begin(), code.end()}) + "<script>\n" + text(kReportPageScript) +
           "</script>\n</body>\n</html>\n";
}

Report readJson(const std::string &text) {
    constexpr char kNoReport[] = "not a report of pack: --report FILE writes one";
    constexpr double kMostBytes = 1e15;
    Report report;
    need(text.find('\0') == text.npos, kNoReport); // the parser would stop there
    try {
        json all = json::parse(text);
        double file = all.at("file"), overhead = all.at("overhead");
        report.rest = all.value("rest", 0.0);
        for (const PartKind &kind : kPartKinds) {
            if (kind.costs == &Report::rooms) continue;
            json parts = all.value(kind.table, json::object());
            for (auto &[name, given] : parts.items()) {
                Cost &cost = (report.*kind.costs)[isWholeProgram(name) ? kWholeProgram : name];
                cost.bytes = (uint64_t)std::clamp(given.value("bytes", 0.0), 0.0, kMostBytes);
                cost.bits = given.value("bits", 0.0);
                if (given.contains("room")) report.roomOf[name] = given["room"];
            }
        }
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
