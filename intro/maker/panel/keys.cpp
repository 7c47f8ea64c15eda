#include "maker/panel/keys.h"

#include <algorithm>

namespace odraz {

Action actionOf(int key, bool shift) {
    for (const KeyRow &row : kKeys)
        if (row.action != Action::Count && row.key == key && row.shift == shift) return row.action;
    return Action::Count;
}

void drawHelp(Canvas &canvas) {
    float size = textSize(canvas.height()), keys = 0, what = 0;
    int rows = 0;
    for (const KeyRow &row : kKeys) {
        if (!*row.shown) continue;
        ++rows;
        keys = std::max(keys, widthOf(row.shown, size)), what = std::max(what, widthOf(row.what, size));
    }
    // In one column, or in two where the picture is too low for that
    float room = (float)canvas.height() - size * 3;
    int columns = (float)rows * size * 1.9f > room ? 2 : 1, each = (rows + columns - 1) / columns;
    float step = std::min(size * 1.9f, room / (float)each), column = keys + what + size * 3,
          wide = column * (float)columns, tall = step * (float)each + size * 1.6f,
          x = ((float)canvas.width() - wide) * 0.5f, y = ((float)canvas.height() - tall) * 0.5f;
    canvas.fill({(int)x, (int)y, (int)wide, (int)tall}, kGround, 0.9f);
    int i = 0;
    for (const KeyRow &row : kKeys) {
        if (!*row.shown) continue;
        float left = x + size + (float)(i / each) * column,
              base = y + size * 0.8f + step * ((float)(i % each) + 0.5f) + size * 0.4f;
        canvas.text(row.shown, left, base, size, kWarm);
        canvas.text(row.what, left + keys + size, base, size, kInk);
        ++i;
    }
}

} // namespace odraz
