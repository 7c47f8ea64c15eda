#include "tools/radiosity/divide/rectangles.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

std::vector<Rectangle> rectanglesOf(const std::vector<std::array<Vec2d, 2>> &borders, double tiny) {
    struct Upright {
        double u, v0, v1;
    };
    std::vector<Upright> uprights;
    for (const auto &[a, b] : borders) {
        if (std::fabs(a[0] - b[0]) <= tiny)
            uprights.push_back({a[0], std::min(a[1], b[1]), std::max(a[1], b[1])});
        else if (std::fabs(a[1] - b[1]) > tiny)
            return {};
    }
    // Join adjacent pieces of a line
    std::sort(uprights.begin(), uprights.end(), [&](const Upright &a, const Upright &b) {
        return std::fabs(a.u - b.u) > tiny ? a.u < b.u : a.v0 < b.v0;
    });
    std::vector<Upright> lines;
    for (const Upright &s : uprights) {
        if (!lines.empty() && std::fabs(lines.back().u - s.u) <= tiny &&
            std::fabs(lines.back().v1 - s.v0) <= tiny)
            lines.back().v1 = s.v1;
        else
            lines.push_back(s);
    }
    std::vector<double> heights;
    for (const Upright &s : lines) heights.push_back(s.v0), heights.push_back(s.v1);
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end(),
                              [&](double a, double b) { return std::fabs(a - b) <= tiny; }),
                  heights.end());
    std::vector<Rectangle> done, open;
    for (size_t i = 0; i + 1 < heights.size(); ++i) {
        double middle = (heights[i] + heights[i + 1]) / 2;
        std::vector<double> crossed;
        for (const Upright &s : lines)
            if (s.v0 < middle && s.v1 > middle) crossed.push_back(s.u);
        if (crossed.size() % 2) return {};
        std::sort(crossed.begin(), crossed.end());
        std::vector<Rectangle> now;
        for (size_t k = 0; k < crossed.size(); k += 2)
            now.push_back({crossed[k], heights[i], crossed[k + 1], heights[i + 1]});
        // Extend a rectangle that continues upwards
        for (const Rectangle &was : open) {
            auto same = std::find_if(now.begin(), now.end(), [&](const Rectangle &r) {
                return std::fabs(r.u0 - was.u0) <= tiny && std::fabs(r.u1 - was.u1) <= tiny;
            });
            if (same == now.end())
                done.push_back(was);
            else
                same->v0 = was.v0;
        }
        open = now;
    }
    done.insert(done.end(), open.begin(), open.end());
    return done;
}

} // namespace odraz::radiosity
