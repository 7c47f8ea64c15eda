#include "packer/report/report_html.h"

#include "report_page_body.h"
#include "report_page_script.h"
#include "report_page_style.h"
#include "tools/common/text.h"

#include <algorithm>
#include <cerrno>
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

// Returns the costs as bytes, limited to 255. `high` gets all costs of 255 or more: [[offset, units], ...].
Bytes lowCosts(const Report &report, json &high) {
    Bytes low;
    for (size_t i = 0; i < report.sixteenths.size(); ++i) {
        uint16_t cost = report.sixteenths[i];
        low.push_back((uint8_t)std::min<uint16_t>(cost, 255));
        if (cost >= 255) high.push_back({i, cost});
    }
    return low;
}

// Returns the output of a command. Throws std::runtime_error if it cannot be started.
std::string outputOf(const std::string &command) {
    std::FILE *printed = popen(command.c_str(), "r");
    if (!printed) throw std::runtime_error("cannot run " + command + ": " + std::strerror(errno));
    std::string output;
    char buffer[1 << 16];
    while (size_t size = std::fread(buffer, 1, sizeof buffer, printed)) output.append(buffer, size);
    pclose(printed);
    return output;
}

// Removes the symbol and aligning spaces from "mov    eax,DWORD PTR [rip+0x10]        # 404010 <name>".
std::string tidy(const std::string &line) {
    std::istringstream words(line.substr(0, line.find('<')));
    std::string text;
    for (std::string word; words >> word;) text += (text.empty() ? "" : " ") + word;
    return text;
}

struct Instruction {
    uint64_t address;
    Bytes bytes;
    std::string text; // in Intel's syntax; after " # " the address of an operand relative to rip
};

// Returns the instructions in the order of the sections. Returns none if objdump (binutils) is missing.
std::vector<Instruction> disassemble(const std::string &path) {
    std::vector<Instruction> all;
    std::istringstream lines(
        outputOf("objdump -d -w -z -M intel -- " + common::shellWord(path) + " 2>/dev/null"));
    // "  404a10:\t48 89 e5             \tmov    rbp,rsp"
    for (std::string line; std::getline(lines, line);) {
        size_t bytes = line.find(":\t"), text = line.find('\t', bytes + 2);
        if (line[0] != ' ' || bytes == line.npos) continue;
        Instruction i = {std::strtoull(line.c_str(), nullptr, 16), {}, ""};
        std::istringstream numbers(line.substr(bytes + 2, text - bytes - 2));
        for (unsigned byte; numbers >> std::hex >> byte;) i.bytes.push_back((uint8_t)byte);
        if (text != line.npos) i.text = tidy(line.substr(text));
        if (!i.bytes.empty() && i.bytes.size() <= 15) all.push_back(std::move(i));
    }
    return all;
}

// Returns the program's instructions for the page's element "code".
std::string readCode(const std::string &path, const Program &program) {
    std::map<uint64_t, Instruction> all; // by offset
    for (Instruction &i : disassemble(path)) {
        uint64_t begin = i.address - program.base, size = program.bytes.size();
        // Leave out instructions that are not in the program's memory
        if (begin < size && size - begin >= i.bytes.size() &&
            !std::memcmp(&program.bytes[begin], i.bytes.data(), i.bytes.size()))
            all.emplace(begin, std::move(i));
    }
    std::string code;
    uint64_t end = 0;
    for (auto &[begin, i] : all) {
        if (begin < end) continue; // sections overlap
        if (begin != end) common::append(code, "@%llx\n", (unsigned long long)begin);
        common::append(code, "%zx%s\n", i.bytes.size(), i.text.c_str());
        end = begin + i.bytes.size();
    }
    return code;
}

// Returns [begin, bytes, units, section, object, room, symbol] of each stretch.
json stretches(const Report &report) {
    json all = json::array();
    for (const Stretch &s : report.stretches) {
        uint64_t cost = 0;
        for (uint32_t i = s.begin; i < s.begin + s.size; ++i) cost += report.sixteenths[i];
        all.push_back({s.begin, s.size, cost, s.section, s.object, s.room, s.symbol});
    }
    return all;
}

// Returns the units of each part of an earlier report, or null if it has no such parts.
json unitsOf(const Costs &costs) {
    json all;
    for (auto &[name, cost] : costs) all[name] = std::llround(cost.bits * kUnit);
    return all;
}
json earlier(const ReportPage &page) {
    if (!page.before) return {};
    return {{"name", page.beforeName},
            {"file", page.before->fileSize},
            {"overhead", page.before->overhead},
            {"rooms", unitsOf(page.before->rooms)},
            {"objects", unitsOf(page.before->objects)},
            {"sections", unitsOf(page.before->sections)},
            {"symbols", unitsOf(page.before->symbols)}};
}

Bytes deflate(const Bytes &bytes) {
    uLongf size = compressBound(bytes.size());
    Bytes packed(size);
    if (compress2(packed.data(), &size, bytes.data(), bytes.size(), Z_BEST_COMPRESSION) != Z_OK)
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

std::string printHtml(const ReportPage &page, const Report &report, const Program &program) {
    bool shown = program.bytes.size() <= kMostShown;
    json high = json::array();
    Bytes low = lowCosts(report, high);
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
        {"stretches", stretches(report)},
        {"high", shown ? high : json::array()},
    };
    std::string printed = tables.dump(-1, ' ', false, json::error_handler_t::replace);
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>What it "
           "costs</title>\n"
           "<meta name=\"viewport\" content=\"width=device-width\">\n<style>\n" +
           text(kReportPageStyle) + "</style>\n</head>\n<body>\n" + text(kReportPageBody) +
           element("tables", {printed.begin(), printed.end()}) +
           element("bytes", shown ? program.bytes : Bytes()) + element("costs", shown ? low : Bytes()) +
           element("code", {code.begin(), code.end()}) + "<script>\n" + text(kReportPageScript) +
           "</script>\n</body>\n</html>\n";
}

} // namespace pack
