// The film's font: a small geometric face of straight strokes and arcs, with lower-case letters and digits.
#pragma once

#include "trace/picture/overlay.h"
#include "trace/scene/scene.h"

namespace odraz {

enum class Align { Left, Centre, Right };

struct TextStyle {
    float size;   // height of a digit, in pixels
    float weight; // width of a stroke, as a share of the size
    Align align;
    Rgb radiance;
    float opacity = 1;
    float tracking = 1.6f; // extra space between letters, in twelfths of the size
};

// Draws text with its baseline at y and its start, centre or end at x (pixels). Skips unknown characters.
void drawText(Frame &frame, const char *text, float x, float y, const TextStyle &style);

// Adds a line of text to a scene, as tubes in the xy plane, with the foot of its first letter at `origin`.
// `unit`: a twelfth of a digit's height. A pen draws the text, and has drawn for `rows` rows. Each letter
// begins on a beat; within a letter, so does each line after an arc and each arc after a line. `next`: if
// 1, each stroke has a material of its own, after `material`. Returns the tip of the pen.
Vec3 addText(Scene &scene, const char *text, const Vec3 &origin, float unit, float rows, int material,
             int next = 0);

} // namespace odraz
