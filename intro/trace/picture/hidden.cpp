#include "trace/picture/hidden.h"

namespace odraz {

// Adds the ellipse to which a ball projects (I. Quilez, "Sphere projection"). For a ball of radius r with
// centre (x, y, z) in the camera's frame, at distance d, it has the centre z (x, y) / (z^2 - r^2), and the
// half axes r sqrt(d^2 - r^2) / (z^2 - r^2), away from the middle of the picture, and r / sqrt(z^2 - r^2). A
// ball that crosses the plane of the eye has no such ellipse; corners hit it.
static void addDisc(Tile &t, int index) {
    const Shape &s = t.scene.shapes[index];
    const View &v = t.view;
    Discs &d = t.s.discs;
    float r = s.half.x * 1.0001f, z = v.ahead(s.centre), denominator = z * z - r * r;
    Vec3 to = s.centre - v.eye;
    float distance2 = dot(to, to);
    if (z <= 0 || !(denominator > r * r * 1e-3f) || d.count == kDiscs) return;
    float x = dot(to, v.right) * v.width / dot(v.right, v.right), // in pixels, at distance z
        y = dot(to, v.down) * v.height / dot(v.down, v.down), offAxis = sqrt(x * x + y * y);
    float pixel = 1 / v.spread, majorAxis = r * sqrt(distance2 - r * r) / denominator * pixel,
          minorAxis = r / sqrt(denominator) * pixel;
    bool turned = offAxis > 1e-3f * abs(z);
    int i = d.count;
    d.x[i] = fmadd(x, z / denominator, v.width * 0.5f - (float)t.x0);
    d.y[i] = fmadd(y, z / denominator, v.height * 0.5f - (float)t.y0);
    if (d.x[i] + majorAxis < 0 || d.y[i] + majorAxis < 0 || d.x[i] - majorAxis > kTile ||
        d.y[i] - majorAxis > kTile)
        return;
    d.alongX[i] = (turned ? x / offAxis : 1) / majorAxis;
    d.alongY[i] = (turned ? y / offAxis : 0) / majorAxis;
    d.acrossX[i] = d.alongX[i] * majorAxis / minorAxis;
    d.acrossY[i] = d.alongY[i] * majorAxis / minorAxis;
    d.perHalf[i] = 1 / minorAxis;
    d.near[i] = sqrt(distance2) - r;
    d.shape[i] = index;
    ++d.count;
}

// Returns a point in whose direction the eye sees p: p itself or, in a mirror, its image. In a flat shape
// this is the reflected p; on a ball, the point where the normal bisects the directions to eye and p. (The
// search for it begins with a normal that points to the eye.)
[[gnu::noinline]] static Vec3 imageOf(const Shape *mirror, const Vec3 &eye, const Vec3 &p) {
    if (!mirror) return p;
    if (!mirror->isBall()) return p - mirror->frame.v * (dot(p - mirror->centre, mirror->frame.v) * 2);
    Vec3 n = normalize(eye - mirror->centre), at = {};
    for (int i = 0; i < 8; ++i) {
        at = fmadd(n, mirror->half.x, mirror->centre);
        n = normalize(n + n + normalize(eye - at) + normalize(p - at));
    }
    return at;
}

// Adds a line along a shape's longest side if its width, the projected second longest side, is small. With a
// mirror: a line along the shape's image in that flat shape or ball.
static void addThinShape(Tile &t, int index, const Shape *mirror = nullptr) {
    ThinShapes &to = t.s.thin;
    const View &v = t.view;
    const Shape &shape = t.scene.shapes[index];
    if (to.count == kThinShapes) return;
    float maxRadius = (float)t.quality.coarse * 0.125f, pixel = 1 / v.spread;
    // Projects a point, or its image, to the tile's pixels; returns its distance ahead of the eye
    auto project = [&](Vec3 p, float &x, float &y) {
        p = imageOf(mirror, v.eye, p);
        v.project(p, x, y);
        x -= (float)t.x0, y -= (float)t.y0;
        return v.ahead(p);
    };
    const Bounds &b = t.scene.box[index];
    Vec3 middle = (b.lo + b.hi) * 0.5f;
    // Images in a ball are smaller: its focal length is half its radius
    if (mirror && mirror->isBall())
        pixel *= mirror->half.x / fmadd(length(middle - mirror->centre), 2.f, -mirror->half.x);
    float x0, y0, r = length(b.hi - b.lo) * 0.5f, ahead = project(middle, x0, y0), x = x0, y = y0;
    if (ahead <= r * 1.1f) return;
    float radius = r / ahead * pixel * 1.1f;
    auto outside = [&] {
        return max(x0, x) + radius < 0 || max(y0, y) + radius < 0 || min(x0, x) - radius > kTile ||
               min(y0, y) - radius > kTile;
    };
    if (mirror && outside()) return; // as most images are
    if (shape.traits().extents && radius > 1) {
        const float half[3] = {shape.half.x, shape.half.y, shape.half.z};
        int longest = half[0] >= half[1] && half[0] >= half[2] ? 0 : half[1] >= half[2] ? 1 : 2;
        float thick = max(half[(longest + 1) % 3], half[(longest + 2) % 3]);
        Vec3 axis = (longest == 0   ? shape.frame.u
                     : longest == 1 ? shape.frame.v
                                    : shape.frame.w) *
                    half[longest];
        if (shape.isRectangle()) {
            // Project its width: the eye sees it at an angle that is the same along the whole axis
            Vec3 across = cross(axis, middle - v.eye);
            thick *= abs(dot(longest ? shape.frame.u : shape.frame.w, across)) / max(length(across), 1e-6f);
        }
        float a = project(middle - axis, x0, y0), c = project(middle + axis, x, y), nearest = min(a, c);
        // Skip it if it comes too near the eye, or is too wide even at its far end
        if (nearest <= r * 0.1f || thick / max(a, c) * pixel > maxRadius) return;
        radius = min(thick / nearest * pixel * 1.1f, maxRadius * 0.99f);
    } else if (radius > maxRadius)
        return;
    if (outside()) return;
    int i = to.count++;
    to.x[i] = x0, to.y[i] = y0, to.alongX[i] = x - x0, to.alongY[i] = y - y0, to.radius[i] = radius;
}

void findBallsAndThinShapes(Tile &t) {
    TileScratch &s = t.s;
    s.discs.count = s.thin.count = 0;
    auto add = [&](int shape) {
        const Shape &s = t.scene.shapes[shape];
        if (s.isBall())
            addDisc(t, shape);
        else if (s.traits().bounded)
            addThinShape(t, shape);
    };
    if (s.candidates.count >= 0)
        for (int i = 0; i < s.candidates.count; ++i) add(s.candidates.shape[i]);
    else
        for (int i = 0; i < t.scene.shapeCount; ++i) add(i);
    // Add the images of glowing shapes in flat mirrors and balls
    for (int k = -t.scene.shapeCount; k < s.discs.count; ++k) {
        const Shape &mirror = t.scene.shapes[k < 0 ? ~k : s.discs.shape[k]];
        float reflect = t.scene.materials[mirror.material].reflect;
        if (k < 0 ? mirror.traits().solid || reflect == 0 : reflect < 0.5f) continue;
        for (int i = 0; i < t.scene.shapeCount; ++i) {
            const Shape &s = t.scene.shapes[i];
            if (!s.isBall() && s.traits().bounded && maxComponent(t.scene.materials[s.material].emit) > 0.5f)
                addThinShape(t, i, &mirror);
        }
    }
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
        // The greatest distance at which the corners' shape is seen: on a ball, its horizon
        float farthest = kInfinity;
        if (shape >= 0 && t.scene.shapes[shape].isBall()) {
            const Shape &s = t.scene.shapes[shape];
            Vec3 to = s.centre - t.view.eye;
            farthest = sqrt(max(dot(to, to) - s.half.x * s.half.x, 0.f)) + s.half.x * 1e-3f;
        }
        if (any(crosses & (load(d.near + i) <= farthest))) return true;
    }
    return false;
}

// Whether a square may show a thin shape.
static bool mayHideThin(const Tile &t, Square q, int size) {
    const ThinShapes &s = t.s.thin;
    float half = (float)size * 0.5f, x = (float)q.x + half, y = (float)q.y + half;
    for (int i = 0; i < s.count; i += 8) {
        // Find the line's point nearest to the square's centre, then the square's point nearest to that
        Float8 dx = x - load(s.x + i), dy = y - load(s.y + i), alongX = load(s.alongX + i),
               alongY = load(s.alongY + i), radius = load(s.radius + i);
        Float8 along = fmadd(dx, alongX, dy * alongY), square = fmadd(alongX, alongX, alongY * alongY);
        Float8 share = saturate(along / max(square, 1e-12f));
        dx = max(abs(fmadd(share, -alongX, dx)) - half, 0.f),
        dy = max(abs(fmadd(share, -alongY, dy)) - half, 0.f);
        if (any((fmadd(dx, dx, dy * dy) <= radius * radius) & (radius < half * 1.1f) &
                (kLanes < s.count - i)))
            return true;
    }
    return false;
}

bool mayHideShape(const Tile &t, Square q, int size, int shape) {
    float half = (float)size * 0.5f;
    return mayHideBall(t, (float)q.x + half, (float)q.y + half, half, shape) || mayHideThin(t, q, size);
}

} // namespace odraz
