// Reports that need libraries (nlohmann-json, zlib): a page for browsers that shows what each byte of a
// program costs, and the reader of earlier reports. The page needs no network: page/ and the data are in it.
#pragma once

#include "packer/report/report.h"

namespace pack {

// Bytes of a program; the page of a larger one has tables and treemap, but no bytes.
inline constexpr size_t kMostShown = 16 << 20;

struct Page {
    std::string name;               // of the packed file
    std::string path;               // of the program as it was read, for objdump
    long budget;                    // bytes; -1: none
    const Report *before = nullptr; // with the rooms of the report: arrange()
    std::string beforeName = {};
};

// The page has four elements of data, packed by zlib, in base64. "tables" is JSON: the report, in its units
// (report_html.cpp); "bytes": the program; "costs": what each byte costs, 255 for those listed in "high" of
// the tables; "code": a line for each instruction, its number of bytes, one hexadecimal digit, then its text.
// Where an instruction does not follow the one before, a line "@OFFSET" stands in front of it.
std::string printHtml(const Page &page, const Report &report, const Program &program);

// What printJson() printed, without stretches. Sections must be there, other parts may be missing. There
// are no rooms, but roomOf. Throws common::Refused.
Report readJson(const std::string &text);

} // namespace pack
