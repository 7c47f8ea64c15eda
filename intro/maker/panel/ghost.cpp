#include "maker/panel/ghost.h"

#include <algorithm>
#include <cmath>

namespace odraz::maker {

namespace {

constexpr float kFov = 40, kPi = 3.14159265f;

struct Ball {
    Vec3 middle;
    float radius;
};

// Around the box of all that must be visible
Ball ballOf(const ShotInfo &shot, const CameraKey &now) {
    Vec3 lo = now.eye, hi = now.eye;
    auto take = [&](const Vec3 &p) {
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    };
    take(now.target);
    constexpr int kPlaces = 24;
    for (int i = 0; i <= kPlaces; ++i) {
        double t = shot.from + (shot.to - shot.from) * i / kPlaces;
        CameraKey key = shot.at(t);
        take(key.eye), take(key.target);
    }
    return {(lo + hi) * 0.5f, std::max(length(hi - lo) * 0.5f, 0.5f)};
}

void drawSegment(Canvas &canvas, const Projection &project, const Vec3 &a, const Vec3 &b, float width,
                 Colour colour, float opacity) {
    float x0, y0, x1, y1;
    if (!project(a, x0, y0) || !project(b, x1, y1)) return;
    // A line that leaves the inset is drawn up to its edge
    const Rect &r = project.where;
    float from = 0, to = 1;
    auto clip = [&](float p, float q) { // Liang and Barsky: p * share <= q
        if (p < 0) from = std::max(from, q / p);
        if (p > 0) to = std::min(to, q / p);
        if (p == 0 && q < 0) to = -1;
    };
    float dx = x1 - x0, dy = y1 - y0;
    clip(-dx, x0 - (float)r.x), clip(dx, (float)r.right() - x0);
    clip(-dy, y0 - (float)r.y), clip(dy, (float)r.bottom() - y0);
    if (from < to)
        canvas.line(x0 + from * dx, y0 + from * dy, x0 + to * dx, y0 + to * dy, width, colour, opacity);
}

void drawDot(Canvas &canvas, const Projection &project, const Vec3 &p, float radius, Colour colour) {
    float x, y;
    if (project(p, x, y) && project.where.holds(x, y)) {
        canvas.dot(x, y, radius + 1, kGround, 0.8f);
        canvas.dot(x, y, radius, colour);
    }
}

} // namespace

void GhostPlace::orbit(float degreesAround, float degreesUp) {
    turn = std::fmod(turn + degreesAround, 360.f);
    rise = std::clamp(rise + degreesUp, 4.f, 85.f);
}
void GhostPlace::zoom(float factor) { nearness = std::clamp(nearness * factor, 0.3f, 5.f); }

CameraKey outside(const ShotInfo &shot, const CameraKey &now, const GhostPlace &place) {
    Ball ball = ballOf(shot, now);
    float around = place.turn * (kPi / 180), up = place.rise * (kPi / 180),
          away = ball.radius / std::sin(kFov * (kPi / 360)) / place.nearness;
    Vec3 way = {std::cos(up) * std::sin(around), std::sin(up), std::cos(up) * std::cos(around)};
    return {now.row, ball.middle + way * away, ball.middle, 0, kFov};
}

bool Projection::operator()(const Vec3 &p, float &x, float &y) const {
    if (view.ahead(p) < 1e-3f) return false;
    view.project(p, x, y);
    x += (float)where.x, y += (float)where.y;
    return true;
}

Projection projectionOf(const CameraKey &c, Rect where) {
    return {lookAt(c.eye, c.target, c.roll, c.fov, where.width, where.height), where};
}

void cornersOf(const CameraKey &c, float aspect, float distance, Vec3 corners[4]) {
    constexpr int kTall = 1000; // in which View counts pixels; only the ratio matters
    View view = lookAt(c.eye, c.target, c.roll, c.fov, std::max((int)(kTall * aspect), 1), kTall);
    for (int i = 0; i < 4; ++i) {
        float right = i == 1 || i == 2 ? 0.5f : -0.5f, down = i < 2 ? -0.5f : 0.5f;
        corners[i] = c.eye + (view.forward + view.right * right + view.down * down) * distance;
    }
}

void drawGhost(Canvas &canvas, const Projection &project, const ShotInfo &shot, const CameraKey &now,
               float aspect) {
    CameraPath path = *shot.path;
    if (path.count > 0) {
        // The path from the first key, or the cut, to the last
        double first = std::min(shot.from, timeOf(shot, path.keys[0])),
               last = std::max(shot.to, timeOf(shot, path.keys[path.count - 1]));
        constexpr double kStep = 1 / 16.;
        auto at = [&](double t) { return shot.at(t).eye; };
        for (double t = first; t < last; t += kStep) {
            bool seen = t >= shot.from && t < shot.to;
            if (seen) drawSegment(canvas, project, at(t), at(std::min(t + kStep, last)), 4.5f, kGround, 0.5f);
            drawSegment(canvas, project, at(t), at(std::min(t + kStep, last)), seen ? 2.2f : 1.2f, kWarm,
                        seen ? 1 : 0.45f);
        }
    }
    Vec3 corners[4], to = now.target - now.eye;
    drawSegment(canvas, project, now.eye, now.target, 1, kCold, 0.7f);
    cornersOf(now, aspect, length(to) * 0.5f, corners);
    for (int i = 0; i < 4; ++i) {
        drawSegment(canvas, project, now.eye, corners[i], 1.3f, kInk, 0.9f);
        drawSegment(canvas, project, corners[i], corners[(i + 1) % 4], 1.3f, kInk, 0.9f);
    }
    for (int i = 0; i < path.count; ++i)
        drawDot(canvas, project, shot.at(timeOf(shot, path.keys[i])).eye, 3, kWarm);
    drawDot(canvas, project, now.eye, 3.5f, kInk);
}

} // namespace odraz::maker
