#include "trace/picture/hidden.h"

namespace odraz {

// A ball projects to an ellipse. For a ball of radius r whose middle is (x, y, z) in the camera's frame, at
// distance d, the ellipse's centre is z (x, y) / (z^2 - r^2). Its half axes are r sqrt(d^2 - r^2) / (z^2 -
// r^2) and r / sqrt(z^2 - r^2). Balls that cross the plane of the eye do not project to ellipses; corners
// find those.
static void addDisc(Tile &t, int index) {
    const Shape &s = t.scene.shapes[index];
    const View &v = t.view;
    Discs &d = t.s.discs;
    float r = s.half.x * 1.0001f, z = v.ahead(s.centre), below = z * z - r * r;
    Vec3 to = s.centre - v.eye;
    float square = dot(to, to);
    if (z <= 0 || !(below > r * r * 1e-3f) || d.count == kDiscs) return;
    float x = dot(to, v.right) * v.width / dot(v.right, v.right), // in pixels, at distance z
        y = dot(to, v.down) * v.height / dot(v.down, v.down), away = sqrt(x * x + y * y);
    float pixel = 1 / v.spread, longer = r * sqrt(square - r * r) / below * pixel,
          shorter = r / sqrt(below) * pixel;
    bool turned = away > 1e-3f * abs(z);
    int i = d.count;
    d.x[i] = fmadd(x, z / below, v.width * 0.5f - (float)t.x0);
    d.y[i] = fmadd(y, z / below, v.height * 0.5f - (float)t.y0);
    if (d.x[i] + longer < 0 || d.y[i] + longer < 0 || d.x[i] - longer > kTile || d.y[i] - longer > kTile)
        return;
    d.alongX[i] = (turned ? x / away : 1) / longer;
    d.alongY[i] = (turned ? y / away : 0) / longer;
    d.acrossX[i] = d.alongX[i] * longer / shorter;
    d.acrossY[i] = d.alongY[i] * longer / shorter;
    d.perHalf[i] = 1 / shorter;
    d.near[i] = sqrt(square) - r;
    d.shape[i] = index;
    ++d.count;
}

// Adds a line along a shape's longest side, as thick as its second longest is seen, if that is thin.
static void addThinShape(Tile &t, int index) {
    TileScratch &s = t.s;
    const View &v = t.view;
    const Shape &shape = t.scene.shapes[index];
    if (s.thinCount == kThinShapes) return;
    float widest = (float)t.quality.coarse * 0.375f, pixel = 1 / v.spread;
    auto place = [&](Vec3 p, float &x, float &y) {
        v.project(p, x, y);
        x -= (float)t.x0, y -= (float)t.y0;
    };
    const Bounds &b = t.scene.box[index];
    Vec3 middle = (b.lo + b.hi) * 0.5f;
    float r = length(b.hi - b.lo) * 0.5f, far = v.ahead(middle);
    if (far <= r * 1.1f) return;
    ThinShape line = {0, 0, 0, 0, r / far * pixel * 1.1f};
    place(middle, line.x, line.y);
    float x = line.x, y = line.y;
    if (line.radius > widest) {
        if (!shape.traits().extents) return;
        const float half[3] = {shape.half.x, shape.half.y, shape.half.z};
        int longest = half[0] >= half[1] && half[0] >= half[2] ? 0 : half[1] >= half[2] ? 1 : 2;
        float thick = max(half[(longest + 1) % 3], half[(longest + 2) % 3]);
        Vec3 axis = (longest == 0   ? shape.frame.u
                     : longest == 1 ? shape.frame.v
                                    : shape.frame.w) *
                    half[longest];
        if (shape.isRectangle()) {
            // It is seen from the side. How much narrower this makes it is the same all along it
            Vec3 aside = cross(axis, middle - v.eye);
            thick *= abs(dot(longest ? shape.frame.u : shape.frame.w, aside)) / max(length(aside), 1e-6f);
        }
        float nearest = min(v.ahead(middle - axis), v.ahead(middle + axis));
        line.radius = thick / nearest * pixel * 1.1f;
        if (nearest <= r * 0.1f || line.radius > widest) return;
        place(middle - axis, line.x, line.y);
        place(middle + axis, x, y);
    }
    line.alongX = x - line.x, line.alongY = y - line.y;
    if (max(line.x, x) + line.radius < 0 || max(line.y, y) + line.radius < 0 ||
        min(line.x, x) - line.radius > kTile || min(line.y, y) - line.radius > kTile)
        return;
    s.thin[s.thinCount++] = line;
}

void findBallsAndThinShapes(Tile &t) {
    TileScratch &s = t.s;
    s.discs.count = s.thinCount = 0;
    auto add = [&](int shape) {
        const Shape &s = t.scene.shapes[shape];
        if (s.isBall())
            addDisc(t, shape);
        else if (s.traits().bounded)
            addThinShape(t, shape);
    };
    if (s.among.count >= 0)
        for (int i = 0; i < s.among.count; ++i) add(s.among.shape[i]);
    else
        for (int i = 0; i < t.scene.shapeCount; ++i) add(i);
}

static bool mayHideBall(const Tile &t, float x, float y, float half, int shape) {
    const Discs &d = t.s.discs;
    for (int i = 0; i < d.count; i += 8) {
        Float8 dx = x - load(d.x + i), dy = y - load(d.y + i), perHalf = load(d.perHalf + i);
        Float8 along = fmadd(dx, load(d.alongX + i), dy * load(d.alongY + i));
        Float8 across = fmadd(dy, load(d.acrossX + i), -dx * load(d.acrossY + i));
        Float8 square = fmadd(along, along, across * across), reach = perHalf * (half * 1.4143f);
        Float8 outer = reach + 1.f, inner = max(1.f - reach, 0.f);
        Int8 crosses = (square <= outer * outer) & (square >= inner * inner);
        crosses &= (loadInts(d.shape + i) != shape) & (kLanes < d.count - i);
        if (!any(crosses)) continue;
        // The greatest distance of what the corners show; for a ball, that of its horizon
        float far = kInfinity;
        if (shape >= 0 && t.scene.shapes[shape].isBall()) {
            const Shape &s = t.scene.shapes[shape];
            Vec3 to = s.centre - t.view.eye;
            far = sqrt(max(dot(to, to) - s.half.x * s.half.x, 0.f)) + s.half.x * 1e-3f;
        }
        if (any(crosses & (load(d.near + i) <= far))) return true;
    }
    return false;
}

bool mayHideSome(const Tile &t, Square q, int size, int shape) {
    const TileScratch &s = t.s;
    float half = (float)size * 0.5f, x = (float)q.x + half, y = (float)q.y + half;
    if (mayHideBall(t, x, y, half, shape)) return true;
    for (int i = 0; i < s.thinCount; ++i) {
        const ThinShape &line = s.thin[i];
        if ((float)size <= line.radius) continue;
        // Find the line's point nearest to the square's middle, then the square's point nearest to that
        float along = fmadd(x - line.x, line.alongX, (y - line.y) * line.alongY),
              square = fmadd(line.alongX, line.alongX, line.alongY * line.alongY);
        float share = saturate(along / max(square, 1e-12f));
        float dx = max(abs(fmadd(share, line.alongX, line.x) - x) - half, 0.f),
              dy = max(abs(fmadd(share, line.alongY, line.y) - y) - half, 0.f);
        if (fmadd(dx, dx, dy * dy) <= line.radius * line.radius) return true;
    }
    return false;
}

} // namespace odraz
