#include "timeline/shot.h"

namespace odraz {

static float ramp(float rows, float over) {
    if (over <= 0 || rows >= over) return 1;
    return rows <= 0 ? 0 : rows / over;
}

Moment momentAt(ShotList list, double at) {
    float row = (float)at;
    if (row < list.shots[0].row) row = list.shots[0].row;
    if (row > list.endRow) row = list.endRow;
    int i = 0;
    while (i + 1 < list.count && list.shots[i + 1].row <= row) ++i;
    const Shot &shot = list.shots[i];
    float end = i + 1 < list.count ? list.shots[i + 1].row : list.endRow;
    float in = ramp(row - shot.row, shot.fadeIn), out = ramp(end - row, shot.fadeOut);
    return {&shot, row - shot.storyRow, in < out ? in : out};
}

} // namespace odraz
