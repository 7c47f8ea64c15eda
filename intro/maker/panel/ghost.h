// The shot from outside: a camera that sees the film's camera, its path and its keys.
#pragma once

#include "maker/panel/canvas.h"
#include "maker/panel/strip.h"
#include "trace/rays/view.h"

namespace odraz::maker {

// The maker's point of view: degrees around the path's middle and above it, and a factor of nearness.
struct GhostPlace {
    float turn = 35, rise = 32, nearness = 1;

    void orbit(float degreesAround, float degreesUp); // rise stays within 4 .. 85
    void zoom(float factor);                          // nearness stays within 0.3 .. 5
};

// The camera that looks at a shot from outside. The whole path, its targets and the current camera are in the
// picture.
CameraKey outside(const ShotInfo &shot, const CameraKey &now, const GhostPlace &place);

// Projects a point of the world into a rectangle of the canvas; false if it is behind the camera.
struct Projection {
    View view;
    Rect where;

    bool operator()(const Vec3 &p, float &x, float &y) const;
};
Projection projectionOf(const CameraKey &from, Rect where);

// The corners of the camera's frustum at a distance: upper left, upper right, lower right, lower left.
void cornersOf(const CameraKey &camera, float aspect, float distance, Vec3 corners[4]);

// Draws the path of a shot's camera over the picture from outside(): the part within the shot, the rest
// (faint), the keys as dots, the current frustum, and the line to the target.
void drawGhost(Canvas &canvas, const Projection &project, const ShotInfo &shot, const CameraKey &now,
               float aspect);

} // namespace odraz::maker
