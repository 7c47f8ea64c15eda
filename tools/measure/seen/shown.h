// What a viewer was shown: the pictures that a player made, each with the moment when the screen began to
// show it. A list is recorded from a played film, or made up.
#pragma once

#include "trace/quality.h"

#include <string>
#include <vector>

namespace odraz {

struct Shown {
    double at;         // seconds of the film when it came on the screen; negative: it never did
    double time;       // seconds of the film that it shows
    bool between;      // made half-way between the traced ones before and after it in the list
    float level;       // of quality, if it was traced: 0 film, 1 play, 2 draft, and all between these
    int width, height; // pixels traced; an in-between has those of the picture behind it
};

// The quality of a level, as the governor blends it.
Quality qualityOf(float level);

// Lists as CSV: "at,time,kind,level,width,height", where the kind is "traced" or "between". parseShown()
// wants the columns in this order; what it returns is in order of time. Throws Refused with the line's
// number.
std::string printShown(const std::vector<Shown> &list);
std::vector<Shown> parseShown(const std::string &csv);

// Which picture of the list stands on the screen at a moment; -1 before the first one.
int standsAt(const std::vector<Shown> &list, double seconds);

// A player that never misses: `rate` pictures a second from one moment to another, each shown when its time
// comes, for as long as it lasts. In pairs every other one is made between.
std::vector<Shown> steady(double from, double to, double rate, bool pairs, float level, int width,
                          int height);

} // namespace odraz
