#include "tools/radiosity/study/page.h"

#include "tools/common/text.h"
#include "tools/radiosity/export/points_export.h"

#include <cmath>
#include <cstdio>

namespace odraz::radiosity {

namespace {

constexpr char kStyle[] =
    "body{font:16px/1.45 sans-serif;max-width:62em;margin:1.5em auto;padding:0 1em;color:#222;"
    "background:#fff}"
    "h1{font-size:1.6em}h2{font-size:1.25em;margin-top:2em;border-top:1px solid #ccc;padding-top:.8em}"
    "table{border-collapse:collapse;margin:.8em 0;font-variant-numeric:tabular-nums}"
    "th,td{padding:.15em .7em;text-align:right;border-bottom:1px solid #e4e4e4}th{vertical-align:bottom}"
    "th:first-child,td:first-child,.words{text-align:left}"
    "figure{display:inline-block;margin:.4em .6em .4em 0;vertical-align:top}"
    "figcaption{font-size:.85em;color:#555;max-width:26em}"
    "img{max-width:100%;height:auto}.plot{display:block;width:100%}.csv{font-size:.85em}";

std::string lineOf(const std::vector<std::string> &cells, auto &&each, const char *between) {
    std::string line;
    for (const std::string &cell : cells) line += (&cell == &cells[0] ? "" : between) + each(cell);
    return line;
}

} // namespace

std::string shown(double number, int digits) {
    if (!std::isfinite(number)) return "";
    // Write large numbers in full instead of with an exponent
    bool inFull = std::fabs(number) >= std::pow(10, digits - 1) && std::fabs(number) < 1e12;
    return inFull ? common::format("%.0f", number) : common::format("%.*g", digits, number);
}

pictures::Plot errorPlot(const std::string &title, const std::string &xName, const std::string &yName,
                         std::vector<std::string> series) {
    return {title, xName, yName, std::move(series), {}, true, true};
}

void Page::write(const std::string &file, const std::string &content) {
    folder.write(file, content);
    newFiles.push_back(folder / file);
}

void Page::drop() {
    body.resize(kept);
    for (const std::string &file : newFiles) std::remove(file.c_str());
    newFiles.clear();
}

void Page::heading(const std::string &what) { body += "<h2>" + common::htmlText(what) + "</h2>\n"; }

void Page::text(const std::string &paragraph) { body += "<p>" + common::htmlText(paragraph) + "</p>\n"; }

void Page::list(const std::vector<std::string> &items) {
    if (items.empty()) return;
    body += "<ul>\n";
    for (const std::string &item : items) body += "<li>" + common::htmlText(item) + "</li>\n";
    body += "</ul>\n";
}

void Page::table(const PageTable &t, bool inPage) {
    std::string csv = lineOf(t.columns, csvField, ",") + "\n", rows;
    auto row = [&](const std::vector<std::string> &cells, const char *kind) {
        // Align words left, numbers right
        auto cell = [&](const std::string &c) {
            bool words = c.find_first_not_of("0123456789.e+-") != std::string::npos;
            return std::string("<") + kind + (words && kind[1] == 'd' ? " class=\"words\">" : ">") +
                   common::htmlText(c) + "</" + kind + ">";
        };
        rows += "<tr>" + lineOf(cells, cell, "") + "</tr>\n";
    };
    row(t.heads, "th");
    for (const auto &cells : t.rows) {
        csv += lineOf(cells, csvField, ",") + "\n";
        row(cells, "td");
    }
    write(t.file + ".csv", csv);
    if (inPage) body += "<table>\n" + rows + "</table>\n";
    body += "<p class=\"csv\"><a href=\"" + t.file + ".csv\">" + t.file + ".csv</a></p>\n";
}

void Page::plot(const std::string &file, pictures::Plot plot) {
    // Leave out points that were not measured, or are not positive on a logarithmic axis
    std::erase_if(plot.points, [&](const pictures::PlotPoint &p) {
        return !std::isfinite(p.x) || !std::isfinite(p.y) || (plot.logarithmicX && p.x <= 0) ||
               (plot.logarithmicY && p.y <= 0);
    });
    if (plot.points.empty()) return;
    write(file + ".svg", pictures::svg(plot));
    body += "<p><img class=\"plot\" src=\"" + file + ".svg\" alt=\"" + common::htmlText(plot.title) +
            "\"/></p>\n";
}

void Page::pictures(const std::vector<PagePicture> &pictures) {
    body += "<div>\n";
    for (const PagePicture &p : pictures)
        body += "<figure><img src=\"" + p.file + "\" alt=\"" + common::htmlText(p.caption) +
                "\"/><figcaption>" + common::htmlText(p.caption) + "</figcaption></figure>\n";
    body += "</div>\n";
}

void Page::finish() {
    folder.write("index.html", "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
                               "<meta name=\"viewport\" content=\"width=device-width\"/>\n<title>" +
                                   common::htmlText(title) + "</title>\n<style>" + kStyle +
                                   "</style>\n</head>\n<body>\n<h1>" + common::htmlText(title) + "</h1>\n" +
                                   body + rest + "</body>\n</html>\n");
}

} // namespace odraz::radiosity
