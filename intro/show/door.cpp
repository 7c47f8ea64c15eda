#include "show/door.h"

#include "base/maths.h"
#include "show/score.h"

namespace odraz {

// Returns the strip that a tone lights: D to d.
static constexpr int stripOf(char tone) { return stepOf(tone) + (stepOf(tone) < 0 ? 7 : 0); }
static_assert(stripOf('D') == 0 && stripOf('A') == stripOf('a') && stripOf('C') == 6 &&
              stripOf('d') == kStrips - 1);

void playDoor(HallLight &light, const char *line, float row, float every, float full) {
    constexpr float kDead = 4; // rows after which a flare is dead
    for (; *line && row >= 0; ++line, row -= every)
        if (*line >= 'A' && row < kDead) {
            float dead = row * (1 / kDead);
            light.strips[stripOf(*line)] += full * (1 - dead * dead);
        }
}

constexpr float kEmber = 0.1f; // share of a flare

void balanceDoor(HallLight &light, float level) {
    // Strips in the middle count more. (0.07: rests are a little darker than flares)
    float all = 0.07f, side = -1;
    for (float &on : light.strips) {
        on += kEmber;
        all += on * fmadd(side * side, -0.4f, 1.f);
        side += 2.f / (kStrips - 1);
    }
    for (float &on : light.strips) on *= level / all;
}

} // namespace odraz
