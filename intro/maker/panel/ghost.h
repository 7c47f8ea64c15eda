// The shot from outside: a camera that sees the film's camera, its path and its keys.
#pragma once

#include "maker/panel/canvas.h"
#include "maker/panel/strip.h"
#include "trace/rays/view.h"

namespace odraz::maker {

// How the maker looks at it: degrees around the path's middle and above it, and how near.
struct GhostPlace {
    float turn = 35, rise = 32, nearness = 1;

    void orbit(float degreesAround, float degreesUp); // rise stays within 4 .. 85
    void zoom(float factor);                          // nearness stays within 0.3 .. 5
};

// The camera that looks at a shot from a place outside, so that all of its path and targets, and the camera
// now, are in the picture.
CameraKey outside(const ShotInfo &shot, const CameraKey &now, const GhostPlace &place);

// A point of the world in a rectangle of the canvas, as that camera sees it; false if it lies behind it.
struct Projection {
    View view;
    Rect where;

    bool operator()(const Vec3 &p, float &x, float &y) const;
};
Projection projectionOf(const CameraKey &from, Rect where);

// The corners of what a camera sees at a distance: upper left, upper right, lower right, lower left.
void cornersOf(const CameraKey &camera, float aspect, float distance, Vec3 corners[4]);

// Draws the path of a shot's camera over a picture that outside() sees: what the shot shows, what lies beyond
// its cuts (faint), the keys as dots, the camera's frustum now, and the line to its target.
void drawGhost(Canvas &canvas, const Projection &project, const ShotInfo &shot, const CameraKey &now,
               float aspect);

} // namespace odraz::maker
