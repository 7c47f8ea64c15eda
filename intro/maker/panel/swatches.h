// The scene's materials: a numbered ball of each, traced by the film's own tracer.
#pragma once

#include "maker/panel/canvas.h"
#include "maker/panel/inspector.h"

#include <vector>

namespace odraz::maker {

class Swatches {
public:
    // Reads the materials of the last picture, and traces the balls again if a material has changed.
    void look(const Inspector &inspector, Intro &intro, int side);
    int count() const { return (int)known.size(); }
    int rows() const { return (count() + kAcross - 1) / kAcross; }
    // The number of times that they were traced.
    int traced() const { return times; }

    // Draws them from (x, y) on; returns the rectangle that it took.
    Rect draw(Canvas &canvas, int x, int y) const;

    static constexpr int kAcross = 8;

private:
    std::vector<MaterialInfo> known;
    std::vector<uint8_t> rgba;
    int side = 0, times = 0;
};

} // namespace odraz::maker
