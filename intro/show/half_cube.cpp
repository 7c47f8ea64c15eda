#include "show/half_cube.h"

#include "base/maths.h"
#include "trace/picture/overlay.h"

namespace odraz {

static void drawEdges(const Hall &hall, float rise, const View &view, Frame &frame) {
    const Patch &patch = hall.model.patches[hall.visited];
    const Chart &chart = hall.model.charts[patch.chart];
    float size = 1.5f * rise;
    Vec3 corner[8];
    Vec3 u = chart.u * size, v = chart.v * size;
    for (int i = 0; i < 8; ++i)
        corner[i] =
            patch.p + u * (i & 1 ? 1.f : -1.f) + v * (i & 2 ? 1.f : -1.f) + chart.n * (i & 4 ? size : 0.f);
    Stroke edges[12];
    int count = 0;
    for (int i = 0; i < 8; ++i)
        for (int bit = 1; bit < 8; bit *= 2)
            if (!(i & bit)) {
                Stroke &s = edges[count++];
                view.project(corner[i], s.x0, s.y0);
                view.project(corner[i | bit], s.x1, s.y1);
            }
    drawStrokes(frame, edges, count, (float)frame.height * 0.0016f, Rgb{1.6f, 0.7f, 0.34f}, rise);
}

static void drawUnfolded(const Hall &hall, float open, const View &view, Frame &frame) {
    const Model &m = hall.model;
    float h = (float)frame.height, size = h * 0.14f * open; // half a face
    // A line leads from the patch to the cross
    float px, py;
    view.project(m.patches[hall.visited].p, px, py);
    float x0 = lerp(px, view.width - h * 0.33f, open), y0 = lerp(py, h * 0.6f, open);
    Stroke line = {px, py, lerp(px, x0, open), lerp(py, y0, open)};
    drawStrokes(frame, &line, 1, h * 0.0012f, {0.8f, 0.35f, 0.17f}, 0.8f * open);

    float folded = smoothstep(0.35f, 1.f, open), limit = (1 + folded) * size;
    for (int y = max((int)(y0 - limit), 0); y < min((int)(y0 + limit), frame.height); ++y)
        for (int x = max((int)(x0 - limit), 0); x < min((int)(x0 + limit), frame.width); ++x) {
            int pixel =
                unfoldedPixel(((float)x + 0.5f - x0) / size, ((float)y + 0.5f - y0) / size, folded, kSeen);
            if (pixel < 0) continue;
            uint32_t id = hall.seen[pixel];
            Rgb colour = {};
            if (id != kNothing && id != kBackSide) {
                const Chart &c = m.charts[m.patches[id - 1].chart];
                colour = c.open ? Rgb{0.8f, 0.9f, 1.05f}
                                : Rgb{hall.mosaic[0][id - 1], hall.mosaic[1][id - 1], hall.mosaic[2][id - 1]};
            }
            size_t at = (size_t)y * (size_t)frame.stride + (size_t)x;
            frame.plane[0][at] = colour.x, frame.plane[1][at] = colour.y, frame.plane[2][at] = colour.z;
        }
}

void drawHalfCube(const Hall &hall, float rise, float open, const View &view, Frame &frame) {
    if (rise > 0) drawEdges(hall, rise, view, frame);
    if (open > 0) drawUnfolded(hall, open, view, frame);
}

} // namespace odraz
