// Clips a convex polygon by a line or a plane (Sutherland and Hodgman, 1974).
#pragma once

#include <cstddef>
#include <vector>

namespace odraz {

// Returns the part of `in` where distance(point) >= 0. between(p, q, t) interpolates from p (t = 0) to q.
template <class Point, class Distance, class Between>
std::vector<Point> clip(const std::vector<Point> &in, Distance distance, Between between) {
    std::vector<Point> out;
    out.reserve(in.size() + 2);
    for (size_t i = 0; i < in.size(); ++i) {
        const Point &p = in[i], &q = in[i + 1 < in.size() ? i + 1 : 0];
        auto dp = distance(p), dq = distance(q);
        if (dp >= 0) out.push_back(p);
        if ((dp >= 0) != (dq >= 0)) out.push_back(between(p, q, dp / (dp - dq)));
    }
    return out;
}

} // namespace odraz
