#include "timeline/shot.h"

namespace odraz {

static float ramp(float rows, float over) { return rows >= over ? 1 : rows / over; }

Moment momentAt(ShotList list, double at) {
    float row = (float)at;
    if (row < list.shots[0].row) row = list.shots[0].row;
    if (row > list.endRow) row = list.endRow;
    const Shot *shot = list.shots + list.count - 1;
    float end = list.endRow;
    for (; shot->row > row; --shot) end = shot->row;
    float in = ramp(row - shot->row, shot->fadeIn), out = ramp(end - row, shot->fadeOut);
    return {shot, row - shot->storyRow, in < out ? in : out};
}

} // namespace odraz
