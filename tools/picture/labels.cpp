#include "tools/picture/labels.h"

#include <algorithm>
#include <cmath>

namespace pictures {

namespace {

constexpr double kGap = 2;       // around a mark and a name
constexpr double kDetour = 30;   // a label may be this much further away to avoid a line
constexpr double kBelowMark = 6; // ... or to keep its leader from passing below another mark
constexpr double kFurthest = 260;

Box around(const NamedPoint &p) {
    double r = p.radius + 1;
    return {p.x - r, p.y - r, p.x + r, p.y + r};
}

// The box whose side or corner facing the point is at this distance and angle
Box boxAt(const NamedPoint &p, double distance, double angle, double height) {
    double cx = std::cos(angle), cy = std::sin(angle), r = p.radius + kGap + distance;
    // The box's middle moves from one side of the anchor to the other
    double x = p.x + cx * r + cx * p.width / 2, y = p.y + cy * r + cy * height / 2;
    return {x - p.width / 2, y - height / 2, x + p.width / 2, y + height / 2};
}

// The line from the mark to the nearest point of the box
Line leaderTo(const NamedPoint &p, const Box &box) {
    double x = std::clamp(p.x, box.x0, box.x1), y = std::clamp(p.y, box.y0, box.y1);
    double length = std::hypot(x - p.x, y - p.y), from = length > 0 ? (p.radius + 1) / length : 0;
    return {p.x + (x - p.x) * from, p.y + (y - p.y) * from, x, y};
}

double reach(const Line &l) { return std::hypot(l.x1 - l.x0, l.y1 - l.y0); }

} // namespace

bool overlap(const Box &a, const Box &b) { return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1; }

// Clips the line to the box
bool crosses(const Line &line, const Box &box) {
    double from = 0, to = 1;
    auto clip = [&](double at, double along, double low, double high) {
        if (along == 0) return at > low && at < high;
        double a = (low - at) / along, b = (high - at) / along;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
        return true;
    };
    return clip(line.x0, line.x1 - line.x0, box.x0, box.x1) &&
           clip(line.y0, line.y1 - line.y0, box.y0, box.y1) && from < to;
}

std::vector<Label> placeLabels(const std::vector<NamedPoint> &points, const std::vector<Line> &avoid,
                               const Box &within, double height) {
    size_t count = points.size();
    std::vector<size_t> order(count);
    std::vector<double> crowd(count);
    for (size_t i = 0; i < count; ++i) {
        order[i] = i;
        for (const NamedPoint &q : points) crowd[i] += std::hypot(q.x - points[i].x, q.y - points[i].y) < 50;
    }
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
        return points[a].first != points[b].first ? points[a].first : crowd[a] > crowd[b];
    });

    std::vector<Label> labels(count);
    std::vector<size_t> placed;
    auto free = [&](const Label &l) {
        if (l.box.x0 < within.x0 || l.box.y0 < within.y0 || l.box.x1 > within.x1 || l.box.y1 > within.y1)
            return false;
        for (size_t k = 0; k < count; ++k)
            if (overlap(l.box, around(points[k]))) return false;
        for (size_t k : placed)
            if (overlap(l.box, labels[k].box) || (l.led && crosses(l.leader, labels[k].box)) ||
                (labels[k].led && crosses(labels[k].leader, l.box)))
                return false;
        return true;
    };
    for (size_t i : order) {
        const NamedPoint &p = points[i];
        double best = 1e300;
        for (double distance = 0; distance < std::min(best, kFurthest); distance += distance < 16 ? 2 : 6)
            for (int turn = 0; turn < 32; ++turn) {
                Box box = boxAt(p, distance, turn * 3.14159265358979 / 16, height);
                Line leader = leaderTo(p, box);
                Label l = {box, reach(leader) > 3 * kGap, leader};
                double cost = distance;
                for (const Line &a : avoid) cost += crosses(a, box) ? kDetour : 0;
                for (size_t k = 0; k < count && l.led; ++k)
                    cost += k != i && crosses(leader, around(points[k])) ? kBelowMark : 0;
                if (cost < best && free(l)) best = cost, labels[i] = l;
            }
        if (best == 1e300) return {};
        placed.push_back(i);
    }
    return labels;
}

} // namespace pictures
