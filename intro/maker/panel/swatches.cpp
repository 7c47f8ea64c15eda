#include "maker/panel/swatches.h"

#include "maker/panel/mapped_arena.h"

#include <algorithm>

namespace odraz::maker {

void Swatches::look(const Inspector &inspector, Intro &intro, int wide) {
    MaterialInfo now[kMostMaterials];
    int n = inspector.materials(intro, now);
    bool same = side == wide && n == count() &&
                std::equal(now, now + n, known.begin(), [](auto &a, auto &b) { return a.hash == b.hash; });
    known.assign(now, now + n);
    side = wide;
    if (same) return;
    ++times;
    rgba.assign((size_t)(kAcross * side * std::max(rows(), 1) * side * 4), 0);
    MappedArena memory(inspector.swatchMemory(kAcross, side));
    if (memory.arena.base) inspector.swatches(intro, memory.arena, kAcross, side, rgba.data());
}

Rect Swatches::draw(Canvas &canvas, int x, int y) const {
    float size = textSize(canvas.height());
    int label = (int)(size * 1.5f), gap = 3, across = std::min(std::max(count(), 1), kAcross);
    Rect r = {x, y, across * (side + gap) + gap, rows() * (side + label + gap) + gap};
    canvas.fill(r, kGround, 0.78f);
    for (int i = 0; i < count(); ++i) {
        int left = x + gap + i % kAcross * (side + gap), top = y + gap + i / kAcross * (side + label + gap);
        for (int row = 0; row < side; ++row) {
            int from = ((i / kAcross * side + row) * kAcross + i % kAcross) * side;
            canvas.put(left, top + row, rgba.data() + (size_t)from * 4, side, 1);
        }
        // A material without a shape is faint
        canvas.text(std::to_string(i), (float)left + (float)side * 0.5f, (float)(top + side) + size * 1.15f,
                    size * 0.8f, known[(size_t)i].shapes ? kInk : kFaint, Align::Centre);
        if (!known[(size_t)i].shapes) canvas.fill({left, top, side, side}, kGround, 0.6f);
    }
    return r;
}

} // namespace odraz::maker
