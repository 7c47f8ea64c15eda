#include "trace/picture/overlay.h"

namespace odraz {

void drawStrokes(Frame &frame, const Stroke *strokes, int count, float halfWidth, const Rgb &radiance,
                 float opacity) {
    // Find the figure's bounds
    float lo[2] = {kInfinity, kInfinity}, hi[2] = {-kInfinity, -kInfinity};
    for (int i = 0; i < count; ++i) {
        const Stroke &s = strokes[i];
        lo[0] = min(lo[0], min(s.x0, s.x1)), hi[0] = max(hi[0], max(s.x0, s.x1));
        lo[1] = min(lo[1], min(s.y0, s.y1)), hi[1] = max(hi[1], max(s.y0, s.y1));
    }
    float margin = halfWidth + 1;
    float limitX = (float)frame.width, limitY = (float)frame.height;
    int x0 = (int)clamp(lo[0] - margin, 0.f, limitX) & ~7, x1 = (int)clamp(hi[0] + margin + 1, 0.f, limitX);
    int y0 = (int)clamp(lo[1] - margin, 0.f, limitY), y1 = (int)clamp(hi[1] + margin + 1, 0.f, limitY);

    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; x += 8) {
            // Compute the coverage from the distance to the nearest stroke
            Float8 px = toFloat(kLanes) + ((float)x + 0.5f), py = broadcast((float)y + 0.5f);
            Float8 nearest = broadcast(kInfinity);
            for (int i = 0; i < count; ++i) {
                const Stroke &s = strokes[i];
                float dx = s.x1 - s.x0, dy = s.y1 - s.y0, square = dx * dx + dy * dy;
                Float8 ax = px - s.x0, ay = py - s.y0;
                Float8 along = square > 0 ? saturate((ax * dx + ay * dy) * (1.f / square)) : Float8{};
                Float8 ex = ax - along * dx, ey = ay - along * dy;
                nearest = min(nearest, fmadd(ex, ex, ey * ey));
            }
            Float8 cover = saturate(halfWidth + 0.5f - sqrt(nearest)) * opacity;
            if (!any(cover > 0.f)) continue;
            size_t at = (size_t)y * (size_t)frame.stride + (size_t)x;
            float light[3] = {radiance.x, radiance.y, radiance.z};
            for (int c = 0; c < 3; ++c) {
                Float8 under = load(frame.plane[c] + at);
                store(frame.plane[c] + at, fmadd(cover, light[c] - under, under));
            }
        }
}

} // namespace odraz
