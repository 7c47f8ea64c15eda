// The film's lettering: a small geometric face of straight strokes and arcs, lower case and figures.
#pragma once

#include "trace/picture/overlay.h"
#include "trace/scene/scene.h"

namespace odraz {

enum class Align { Left, Centre, Right };

struct TextStyle {
    float size;   // height of a figure, in pixels
    float weight; // width of a stroke, as a share of the size
    Align align;
    Rgb radiance;
    float opacity = 1;
    float tracking = 1.6f; // extra space between letters, in twelfths of the size
};

// Draws a line of text with its baseline at y and its start, middle or end at x (pixels). Unknown characters
// are left out.
void drawText(Frame &frame, const char *text, float x, float y, const TextStyle &style);

// Stands a line of text in a scene, as tubes in the plane of x and y with the foot of its first letter at a
// place; `unit` is a twelfth of a figure's height. A pen draws it, and has done so for `rows` rows. Every
// letter begins on a beat; within a letter, so does a line after an arc and an arc after a line.
void standText(Scene &scene, const char *text, const Vec3 &place, float unit, float rows, int material);

} // namespace odraz
