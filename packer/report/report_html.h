// A page for browsers that shows what each byte of a program costs. It needs no network: the parts of
// report_page/ are in it, and the data, packed by deflate().
#pragma once

#include "packer/report/report.h"

namespace pack {

// A page of a program that is larger has tables and treemap, but not its bytes.
inline constexpr size_t kMostShown = 16 << 20;

struct Page {
    std::string name;               // of the packed file
    const char *path;               // of the program as it was read, for objdump
    long budget;                    // bytes; -1: none
    const Report *before = nullptr; // with the rooms of the report: arrange()
    std::string beforeName = {};
};

// The page has four elements of data, packed and in base64. "tables" is JSON: what the report says, in its
// units (report_html.cpp says how); "bytes": the program; "costs": what each byte costs, 255 for what stands
// in "high" of the tables; "code": for each instruction of which the tables have "forms" (disassembly.h), the
// form's number, seven bits a byte, low ones first.
std::string printHtml(const Page &page, const Report &report, const Program &program);

} // namespace pack
