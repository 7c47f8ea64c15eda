#include "show/hemicube_view.h"

#include "base/maths.h"
#include "trace/picture/overlay.h"

namespace odraz {

namespace {

constexpr float kHalfSide = 1.5f;  // metres
constexpr float kUnfolded = 0.19f; // half the side of the cross's faces, as a share of the picture's height
// Factors on the patches' colours, which are dark: before their face is lit, and what light adds
constexpr float kDark = 5, kLit = 15;
constexpr Rgb kSky = {1.2f, 1.25f, 1.35f};   // colour of windows
constexpr Rgb kLine = {0.30f, 0.16f, 0.10f}; // colour between patches
constexpr Rgb kEdge = {1.6f, 0.7f, 0.34f};

// The faces from back to front: the far sides, the near ones, the top. `row`: its first row of pixels in
// units of half the top's size; u, v: the direction that it faces.
constexpr struct { int8_t row, u, v; } kFaces[] = {{4, -1, 0}, {5, 0, -1}, {2, 1, 0}, {3, 0, 1}, {0, 0, 0}};

} // namespace

void drawHemicube(const Hall &hall, float rise, float open, float found, const View &view, Frame &frame) {
    if (rise <= 0) return;
    const Model &m = hall.model;
    const Patch &patch = m.patches[hall.visited];
    const Chart &c = m.charts[patch.chart];
    float h = (float)frame.height, size = h * kUnfolded;
    // Compute the bottom's centre and half sides: over the patch (`on`), and on the way to the cross (`now`).
    // The lens is so long that parallel sides have equal lengths
    float on[4][2], now[4][2] = {{view.width - 0.51f * h, 0.5f * h}, {-size, 0}, {0, size}, {0, 0}};
    const Vec3 sides[4] = {{}, c.u, c.v, c.n};
    for (int i = 0; i < 4; ++i) view.project(patch.p + sides[i] * (kHalfSide * rise), on[i][0], on[i][1]);
    Stroke line = {on[0][0], on[0][1], 0, 0};
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 4; ++i) now[i][k] = lerp(i ? on[i][k] - on[0][k] : on[0][k], now[i][k], open);
    // Draw a line from the patch to the hemicube
    line.x1 = now[0][0], line.y1 = now[0][1];
    drawStrokes(frame, &line, 1, h * 0.0012f, kEdge, 0.5f * open);
    for (const auto &f : kFaces) {
        float lit = saturate(found--); // how much of its light the face shows
        // Compute the face's corner at its first pixel, and its sides along columns and rows. When it is
        // unfolded, its lower edge is the outer one
        float o[2], a[2], b[2], limits[2] = {view.width, h};
        int from[2], to[2];
        for (int k = 0; k < 2; ++k) {
            float u = now[1][k], v = now[2][k], n = now[3][k], out = u * f.u + v * f.v,
                  along = v * f.u - u * f.v;
            o[k] = now[0][k] + out * (1 + open) - along, a[k] = along * 2, b[k] = n - out * open;
            if (f.row == 0) o[k] += n - u - v, a[k] = u * 2, b[k] = v * 2;
            float centre = o[k] + (a[k] + b[k]) * 0.5f, reach = (abs(a[k]) + abs(b[k])) * 0.5f;
            from[k] = (int)clamp(centre - reach, 0.f, limits[k]);
            to[k] = (int)clamp(centre + reach + 1, 0.f, limits[k]);
        }
        float scale = kSeen / (a[0] * b[1] - a[1] * b[0]), rows = f.row ? 0.5f : 1;
        for (int y = from[1]; y < to[1]; ++y)
            for (int x = from[0]; x < to[0]; ++x) {
                float dx = (float)x + 0.5f - o[0], dy = (float)y + 0.5f - o[1];
                float s = (dx * b[1] - dy * b[0]) * scale, t = (dy * a[0] - dx * a[1]) * scale * rows;
                if (!(min(s, t) >= 0 && s < kSeen && t < rows * kSeen)) continue;
                const uint32_t *seen = hall.seen + (f.row * (kSeen / 2) + (int)t) * kSeen + (int)s;
                uint32_t id = *seen;
                Rgb colour = kLine;
                if (id == seen[1] && id == seen[kSeen] && id != kNothing && id != kBackSide)
                    colour = m.charts[m.patches[--id].chart].open
                                 ? kSky * lit
                                 : Rgb{hall.mosaic[0][id], hall.mosaic[1][id], hall.mosaic[2][id]} *
                                       fmadd(lit, kLit, kDark);
                size_t at = (size_t)y * (size_t)frame.stride + (size_t)x;
                float light[3] = {colour.x, colour.y, colour.z};
                for (int k = 0; k < 3; ++k) frame.plane[k][at] = lerp(frame.plane[k][at], light[k], rise);
            }
        Stroke edges[4];
        for (int k = 0; k < 4; ++k) {
            // two along columns, two along rows
            float *side = k & 1 ? a : b, *other = k & 1 ? b : a, end = k < 2 ? 0 : 1,
                  x = o[0] + other[0] * end, y = o[1] + other[1] * end;
            edges[k] = {x, y, x + side[0], y + side[1]};
        }
        drawStrokes(frame, edges, 4, h * 0.0016f, kEdge, rise);
    }
}

} // namespace odraz
