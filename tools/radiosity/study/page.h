// The page of a study in one folder: HTML with tables, plots and pictures, and a CSV for every table.
#pragma once

#include "tools/common/folders.h"
#include "tools/picture/plot.h"

#include <string>
#include <vector>

namespace odraz::radiosity {

// A number as text with `digits` significant digits; empty if it is not finite, which means not measured.
std::string shown(double number, int digits = 3);

// An empty plot with logarithmic axes, which draws a Pareto front for each series.
pictures::Plot errorPlot(const std::string &title, const std::string &xName, const std::string &yName,
                         std::vector<std::string> series = {});

// Cells are text or numbers. `columns`: the headings in the CSV; `heads`: the headings on the page.
struct PageTable {
    std::string file; // name of the CSV without its ending
    std::vector<std::string> columns, heads;
    std::vector<std::vector<std::string>> rows = {};
};

struct PagePicture {
    std::string file, caption; // `file` with its ending
};

class Page {
public:
    Page(const common::NewFolder &folder, const std::string &title) : folder(folder), title(title) {}

    void heading(const std::string &text);
    void text(const std::string &paragraph);
    // Writes the CSV. With `inPage` false the page has only a link to it.
    void table(const PageTable &table, bool inPage = true);
    // Writes an SVG. A plot without points is left out.
    void plot(const std::string &file, pictures::Plot plot);
    void pictures(const std::vector<PagePicture> &pictures);
    void list(const std::vector<std::string> &items);
    // The path for a new picture.
    std::string path(const std::string &file) {
        newFiles.push_back(folder / file);
        return newFiles.back();
    }
    // Ends a chapter: drop() keeps everything added so far.
    void keep() { kept = body.size(), newFiles.clear(); }
    // Removes everything added since keep(), files too.
    void drop();
    bool empty() const { return body.empty(); }
    // Puts all text that is added from now on before the earlier text. Call it once.
    void toFront() { rest = std::move(body), body.clear(); }
    // Writes index.html.
    void finish();

private:
    const common::NewFolder &folder;
    std::string title, body, rest;
    size_t kept = 0;
    std::vector<std::string> newFiles; // files written since keep()

    void write(const std::string &file, const std::string &content);
};

} // namespace odraz::radiosity
