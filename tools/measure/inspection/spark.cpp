#include "tools/measure/inspection/spark.h"

#include <algorithm>
#include <cstdlib>

namespace odraz::measure {

Grey greyOf(int width, int height, const uint8_t *rgba) {
    Grey g = {width, height, std::vector<uint8_t>((size_t)width * (size_t)height)};
    for (uint8_t &level : g.level) level = (uint8_t)((rgba[0] + rgba[1] + rgba[2] + 1) / 3), rgba += 4;
    return g;
}

// Calls f(i, j) for the pixels whose distance from (x, y) is more than `inner` and at most `reach`. The
// distance is the larger one of the differences in x and in y.
template <class F> static void around(const Grey &g, int x, int y, int inner, int reach, F &&f) {
    for (int j = std::max(y - reach, 0); j <= std::min(y + reach, g.height - 1); ++j)
        for (int i = std::max(x - reach, 0); i <= std::min(x + reach, g.width - 1); ++i)
            if (std::max(std::abs(i - x), std::abs(j - y)) > inner) f(i, j);
}

std::vector<Spark> pointsOf(const Grey &g, int least) {
    std::vector<Spark> found;
    for (int y = 1; y < g.height - 1; ++y)
        for (int x = 1; x < g.width - 1; ++x) {
            int level = g.at(x, y);
            if (level < least) continue;
            // Rule out most pixels by two neighbours
            if (x >= 3 && x < g.width - 3 && std::max(g.at(x - 3, y), g.at(x + 3, y)) > level - least)
                continue;
            // Take the brightest pixel of a point, the first if several are equal
            bool brightest = true;
            around(g, x, y, 0, 2, [&](int i, int j) {
                int other = g.at(i, j);
                brightest &= other < level || (other == level && (j > y || (j == y && i > x)));
            });
            if (!brightest) continue;
            int surround = 0, high = 1;
            around(g, x, y, 2, 3, [&](int i, int j) { surround = std::max(surround, g.at(i, j)); });
            if (level - surround < least) continue;
            around(g, x, y, 0, 2, [&](int i, int j) { high += 2 * g.at(i, j) > level + surround; });
            if (high <= 3) found.push_back({x, y, surround, level - surround});
        }
    return found;
}

static bool isMissing(const Spark &s, const Grey &neighbour, int reach) {
    bool found = false;
    around(neighbour, s.x, s.y, -1, reach,
           [&](int i, int j) { found |= 2 * (neighbour.at(i, j) - s.surround) >= s.over; });
    return !found;
}

// Whether the pictures differ so little, in the mean, that they must be from one shot.
static bool areOfOneShot(const Grey &a, const Grey &b) {
    if (a.width != b.width || a.height != b.height) return false;
    int64_t sum = 0;
    for (size_t i = 0; i < a.level.size(); ++i) sum += std::abs(a.level[i] - b.level[i]);
    return sum < (int64_t)a.level.size() * 12;
}

std::vector<Spark> sparksOf(const std::vector<Spark> &points, const Grey &picture, const Grey *before,
                            const Grey *after, int reach) {
    std::vector<Spark> found;
    for (const Grey **neighbour : {&before, &after})
        if (*neighbour && !areOfOneShot(picture, **neighbour)) *neighbour = nullptr;
    for (const Spark &s : points)
        if ((before && isMissing(s, *before, reach)) || (after && isMissing(s, *after, reach)))
            found.push_back(s);
    return found;
}

} // namespace odraz::measure
