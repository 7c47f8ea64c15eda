// The parts of reports that need libraries (nlohmann-json, zlib): a reader of earlier reports, and an HTML
// page of one file that shows the cost of each byte of a program; its scripts are in page/.
#pragma once

#include "packer/report/report.h"

namespace pack {

// In bytes. The page of a larger program has tables and treemap, but does not show its bytes.
inline constexpr size_t kMostShown = 16 << 20;

struct ReportPage {
    std::string name;               // name of the packed file
    std::string path;               // path of the program, for objdump
    long budget;                    // bytes; -1: none
    const Report *before = nullptr; // an earlier report after arrange(), or null
    std::string beforeName = {};
};

// The page has four elements with data, compressed by zlib and written in base64:
// - "tables": the report as JSON, with costs in units of 1 / kUnit bit (report_html.cpp);
// - "bytes": the program;
// - "costs": the cost of each byte, or 255 if it is in the list "high" of the tables;
// - "code": a line for each instruction: its number of bytes, one hexadecimal digit, then its text. A line
//   "@OFFSET" precedes an instruction that does not follow the previous one.
std::string printHtml(const ReportPage &page, const Report &report, const Program &program);

// Reads the output of printJson(). Sections are required, other parts are optional. The result has no
// stretches and no rooms, but the room of each object (roomOf). Throws common::Refused.
Report readJson(const std::string &text);

} // namespace pack
