// A page of a study: HTML with tables, plots and pictures, and a CSV for every table. All files are in one
// folder, and the page needs no other.
#pragma once

#include "tools/common/folders.h"
#include "tools/picture/plot.h"

#include <string>
#include <vector>

namespace odraz::radiosity {

// A number as text, with this number of significant digits; empty if it is not finite, that is, not measured.
std::string shown(double number, int digits = 3);

// A plot with logarithmic axes and a Pareto front for each series, without points.
pictures::Plot errorPlot(const std::string &title, const std::string &xName, const std::string &yName,
                         std::vector<std::string> series = {});

// Cells are text or numbers. `columns`: the names in the CSV; `heads`: those on the page.
struct PageTable {
    std::string file; // the CSV's name without ending
    std::vector<std::string> columns, heads;
    std::vector<std::vector<std::string>> rows = {};
};

struct PagePicture {
    std::string file, caption; // the file's name with its ending
};

class Page {
public:
    Page(const common::NewFolder &folder, const std::string &title) : folder(folder), title(title) {}

    void heading(const std::string &text);
    void text(const std::string &paragraph);
    // Writes its CSV. With `whole` false the page only has a link to it.
    void table(const PageTable &table, bool whole = true);
    // Writes an SVG. A plot without points is left out.
    void plot(const std::string &file, pictures::Plot plot);
    void pictures(const std::vector<PagePicture> &pictures);
    void list(const std::vector<std::string> &items);
    // The path for a new picture.
    std::string path(const std::string &file) {
        fresh.push_back(folder / file);
        return fresh.back();
    }
    // Ends a chapter: drop() removes everything added after this, files too.
    void keep() { kept = body.size(), fresh.clear(); }
    void drop();
    bool empty() const { return body.empty(); }
    // Puts all text that is added from here on before the earlier text; call it once.
    void toFront() { rest = std::move(body), body.clear(); }
    // Writes index.html.
    void finish();

private:
    const common::NewFolder &folder;
    std::string title, body, rest;
    size_t kept = 0;
    std::vector<std::string> fresh; // files since keep()

    void write(const std::string &file, const std::string &content);
};

} // namespace odraz::radiosity
