#include "tools/radiosity/read/obj_text.h"

#include "tools/radiosity/read/mesh.h"

#include <cmath>
#include <cstring>
#include <unordered_map>

namespace odraz::radiosity {

static bool blank(char c) { return c == ' ' || c == '\t'; }

std::string plainText(std::string text) {
    if (!text.compare(0, 3, "\xef\xbb\xbf")) text.erase(0, 3);
    size_t to = 0, joined = 0; // the number of lines joined to the current one
    bool comment = false, begun = false;
    for (size_t i = 0; i < text.size(); ++i) {
        char c = text[i];
        if (c == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
        if (c == '\r') c = '\n';
        if (c == 0) c = ' ';
        if (c == '\n' && !comment && to > 0 && text[to - 1] == '\\') {
            text[to - 1] = ' ';
            ++joined;
            continue;
        }
        if (!begun && !blank(c)) begun = true, comment = c == '#';
        if (c == '\n') {
            // There is room: one blank replaced a backslash and a line end
            for (; joined; --joined) text[to++] = '\n';
            begun = comment = false;
        }
        text[to++] = c;
    }
    text.resize(to);
    return text;
}

bool isLine(const std::string &line, const char *word, std::string &rest) {
    size_t begin = line.find_first_not_of(" \t"), length = std::strlen(word);
    if (begin == std::string::npos || line.compare(begin, length, word)) return false;
    begin += length;
    if (begin < line.size() && !blank(line[begin])) return false;
    begin = line.find_first_not_of(" \t", begin);
    rest = begin == std::string::npos ? "" : line.substr(begin, line.find_last_not_of(" \t") + 1 - begin);
    return true;
}

ObjText::ObjText(const std::string &path, std::string given) {
    given = plainText(std::move(given));
    size_t number = 0, farthestLine = 0;
    long points = 0, farthest = 0;
    auto refuse = [&](size_t line, const std::string &what) {
        throw ModelError(path + ":" + std::to_string(line) + ": " + what);
    };
    std::unordered_map<std::string, size_t> known;
    all.reserve(given.size() + 100);
    all = "mtllib all\n";
    std::string line, rest;
    for (size_t at = 0; at < given.size();) {
        size_t end = std::min(given.find('\n', at), given.size());
        line.assign(given, at, end - at);
        at = end + 1;
        ++number;
        const char *p = line.c_str();
        while (blank(*p)) ++p;
        // Only names may contain a #
        if (std::strchr("vflp", *p) && *p) line.resize(std::min(line.size(), line.find('#')));
        if (p[0] == 'v' && blank(p[1])) {
            ++points;
            ++p;
            for (int k = 0; k < 3; ++k) {
                char *stop;
                double x = std::strtod(p, &stop);
                if (stop == p) refuse(number, "a point needs three coordinates");
                if (!(std::fabs(x) < 1e18)) refuse(number, "a coordinate is not a number below 1e18");
                p = stop;
            }
        } else if (p[0] == 'f' && (!p[1] || blank(p[1]) || (p[1] == 'o' && blank(p[2])))) {
            if (p[1] == 'o') line[(size_t)(p - line.c_str()) + 1] = ' '; // the older keyword for a polygon
            int corners = 0;
            for (p = line.c_str() + line.find('f') + 1;; ++corners) {
                char *stop;
                long index = std::strtol(p, &stop, 10);
                if (stop == p) break;
                if (index == 0 || index < -points)
                    refuse(number, "there is no point " + std::to_string(index) + " before this polygon");
                if (index > farthest) farthest = index, farthestLine = number;
                for (p = stop; *p && !blank(*p); ++p) {
                }
            }
            while (blank(*p)) ++p;
            if (*p) refuse(number, "a polygon's points are numbers");
            if (corners < 3) ++shortPolygons, line.clear();
        } else if (isLine(line, "mtllib", rest)) {
            if (!rest.empty()) libraries.push_back(rest);
            line.clear();
        } else if (isLine(line, "usemtl", rest)) {
            auto [entry, added] = known.try_emplace(rest, used.size());
            if (added) used.push_back(rest);
            line = "usemtl " + std::to_string(entry->second);
        }
        all += line;
        all += '\n';
    }
    if (farthest > points)
        refuse(farthestLine,
               "there is no point " + std::to_string(farthest) + ": there are " + std::to_string(points));
}

} // namespace odraz::radiosity
