#include "maker/panel/keys.h"

#include <algorithm>
#include <vector>

namespace odraz::maker {

Action actionOf(int key, bool shift) {
    for (const KeyRow &row : kKeys)
        if (row.action != Action::Count && row.key == key && row.shift == shift) return row.action;
    return Action::Count;
}

void drawHelp(Canvas &canvas) {
    float size = textSize(canvas.height()), keys = 0, what = 0;
    std::vector<const KeyRow *> rows;
    for (const KeyRow &row : kKeys) {
        if (!*row.what) continue;
        rows.push_back(&row);
        if (*row.shown) keys = std::max(keys, widthOf(row.shown, size));
        what = std::max(what, widthOf(row.what, size) - (*row.shown ? 0 : keys));
    }
    // Use one column, or two if the picture is too low. The second begins at a headline
    int count = (int)rows.size(), first = count;
    float room = (float)canvas.height() - size * 3;
    if ((float)count * size * 1.9f > room)
        for (first = count / 2; *rows[(size_t)first]->shown;) ++first;
    int columns = first < count ? 2 : 1, each = std::max(first, count - first);
    float step = std::min(size * 1.9f, room / (float)each), column = keys + what + size * 3,
          wide = column * (float)columns, tall = step * (float)each + size * 1.6f,
          x = ((float)canvas.width() - wide) * 0.5f, y = ((float)canvas.height() - tall) * 0.5f;
    canvas.fill({(int)x, (int)y, (int)wide, (int)tall}, kGround, 0.9f);
    for (int i = 0; i < count; ++i) {
        const KeyRow &row = *rows[(size_t)i];
        int line = i < first ? i : i - first;
        float left = x + size + (i < first ? 0 : column),
              base = y + size * 0.8f + step * ((float)line + 0.5f) + size * 0.4f;
        bool headline = !*row.shown;
        canvas.text(row.shown, left, base, size, kWarm);
        canvas.text(row.what, left + (headline ? 0 : keys + size), base, size, headline ? kCold : kInk);
    }
}

} // namespace odraz::maker
