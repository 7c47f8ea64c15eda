#include "show/half_cube.h"

#include "base/maths.h"
#include "trace/picture/overlay.h"

namespace odraz {

namespace {

constexpr float kHalfSide = 1.5f;            // metres
constexpr float kUnfolded = 0.19f;           // half a side of the cross's faces, in heights of the picture
constexpr float kBrightened = 7;             // what it sees is dark
constexpr Rgb kSky = {0.30f, 0.34f, 0.40f};  // in windows
constexpr Rgb kLine = {0.30f, 0.16f, 0.10f}; // between the patches that it sees
constexpr Rgb kEdge = {1.6f, 0.7f, 0.34f};

// The faces in the order in which they hide each other: the far sides, the near ones, the top. Each has its
// first row of pixels, in halves of the top's, and the side of the patch, along u and v, that it looks to.
constexpr struct { int8_t row, u, v; } kFaces[] = {{4, -1, 0}, {5, 0, -1}, {2, 1, 0}, {3, 0, 1}, {0, 0, 0}};

struct Point {
    float x, y;
    Point operator+(Point b) const { return {x + b.x, y + b.y}; }
    Point operator-(Point b) const { return {x - b.x, y - b.y}; }
    Point operator*(float s) const { return {x * s, y * s}; }
};

} // namespace

void drawHalfCube(const Hall &hall, float rise, float open, const View &view, Frame &frame) {
    if (rise <= 0) return;
    const Model &m = hall.model;
    const Patch &patch = m.patches[hall.visited];
    const Chart &c = m.charts[patch.chart];
    float h = (float)frame.height, opacity = smoothstep(0.4f, 1.f, rise);
    auto project = [&](const Vec3 &way) {
        Point on;
        view.project(patch.p + way * (kHalfSide * rise), on.x, on.y);
        return on;
    };
    // The lens is so long that the half-cube's sides are parallel in the picture
    Point foot = project({}), alongU = project(c.u) - foot, alongV = project(c.v) - foot,
          upwards = project(c.n) - foot, middle = {view.width - 0.51f * h, 0.5f * h};
    // A point of the half-cube, in half sides. Unfolded, the lower points of the side towards (outU, outV)
    // lie further out.
    auto at = [&](float u, float v, float up, float outU, float outV) {
        Point on = foot + alongU * u + alongV * v + upwards * up;
        u += outU * (1 - up), v += outV * (1 - up);
        return on + (middle + Point{-u, v} * (kUnfolded * h) - on) * open;
    };
    if (open > 0) {
        // A line leads to it from its patch
        Stroke line = {foot.x, foot.y, lerp(foot.x, middle.x, open), lerp(foot.y, middle.y, open)};
        drawStrokes(frame, &line, 1, h * 0.0012f, kEdge, 0.5f);
    }
    for (const auto &f : kFaces) {
        // A parallelogram: its first pixel's corner, the last one's of the row, and the first one's of the
        // last row
        Point corner[3];
        for (int k = 0; k < 3; ++k) {
            float s = k == 1 ? 1 : -1, t = k == 2;
            corner[k] = f.row ? at(f.u - f.v * s, f.v + f.u * s, t, f.u, f.v) : at(s, 2 * t - 1, 1, 0, 0);
        }
        Point o = corner[0], a = corner[1] - o, b = corner[2] - o, last = corner[1] + b;
        float scale = kSeen / (a.x * b.y - a.y * b.x), rows = f.row ? kSeen / 2 : kSeen;
        int x0, x1, y0, y1;
        auto bound = [&](float Point::*axis, float limit, int &from, int &to) {
            float p = o.*axis, q = last.*axis, r = corner[1].*axis, t = corner[2].*axis;
            from = (int)clamp(min(min(p, q), min(r, t)), 0.f, limit);
            to = (int)clamp(max(max(p, q), max(r, t)) + 1, 0.f, limit);
        };
        bound(&Point::x, view.width, x0, x1), bound(&Point::y, h, y0, y1);
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                float dx = (float)x + 0.5f - o.x, dy = (float)y + 0.5f - o.y;
                float s = (dx * b.y - dy * b.x) * scale, t = (dy * a.x - dx * a.y) * scale * rows / kSeen;
                if (!(s >= 0 && s < kSeen && t >= 0 && t < rows)) continue;
                const uint32_t *seen = hall.seen + (f.row * (kSeen / 2) + (int)t) * kSeen + (int)s;
                uint32_t id = *seen;
                Rgb colour = {};
                if (id != kNothing && id != kBackSide)
                    colour =
                        m.charts[m.patches[id - 1].chart].open
                            ? kSky
                            : Rgb{hall.mosaic[0][id - 1], hall.mosaic[1][id - 1], hall.mosaic[2][id - 1]} *
                                  kBrightened;
                if ((s + 1 < kSeen && id != seen[1]) || (t + 1 < rows && id != seen[kSeen])) colour = kLine;
                size_t to = (size_t)y * (size_t)frame.stride + (size_t)x;
                float light[3] = {colour.x, colour.y, colour.z};
                for (int k = 0; k < 3; ++k) frame.plane[k][to] = lerp(frame.plane[k][to], light[k], opacity);
            }
        Stroke edges[] = {{o.x, o.y, corner[1].x, corner[1].y},
                          {o.x, o.y, corner[2].x, corner[2].y},
                          {last.x, last.y, corner[1].x, corner[1].y},
                          {last.x, last.y, corner[2].x, corner[2].y}};
        drawStrokes(frame, edges, 4, h * 0.0016f, kEdge, rise);
    }
}

} // namespace odraz
