// What a viewer was shown: the pictures that a player made, each with the moment when the screen began to
// show it. A list is recorded from a played film, or made up.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace odraz::measure {

struct Shown {
    double at;         // seconds of the film when it came on the screen; negative: it never did
    double time;       // seconds of the film that it shows
    bool between;      // made from the traced ones before and after it in the list, by its time
    float level;       // of quality, if it was traced: 0 film, 1 play, 2 draft, and all between these
    int width, height; // pixels traced; an in-between has those of the picture behind it
};

// Calls `row` for each row of a CSV below its first line, which must be `head`. Throws Refused, with the
// line's number where `row` does.
void forRows(const std::string &csv, const std::string &head,
             const std::function<void(const std::string &line)> &row);

// Lists as CSV: "at,time,kind,level,width,height", where the kind is "traced" or "between"; in order of time.
// parseShown() throws Refused with the line's number.
std::string printShown(const std::vector<Shown> &list);
std::vector<Shown> parseShown(const std::string &csv);

// The traced pictures that a picture of the list was made from: the last one before it and the first one
// after it. Of a traced one both are itself.
struct MadeFrom {
    const Shown &earlier, &later;
    double gap() const; // in sixtieths of a second
};
MadeFrom madeFrom(const std::vector<Shown> &list, size_t i);

// Which picture of the list is on the screen at a moment; -1 before the first one.
int onScreenAt(const std::vector<Shown> &list, double seconds);

} // namespace odraz::measure
