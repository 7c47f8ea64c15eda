// Lists of shown pictures: the pictures that a player made, each with the moment when the screen began to
// show it. A list is recorded while the film plays, or simulated.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace odraz::measure {

struct ShownPicture {
    double at;          // seconds of the film at which the screen began to show it; negative: never
    double time;        // seconds of the film that it shows
    bool between;       // made from the traced pictures before and after it in the list
    float level;        // quality, if it was traced: 0 film, 1 play, 2 draft, or between these
    int width, height;  // pixels traced; an in-between has the size of the next traced picture
    double seconds = 0; // that making it took
};

// Calls `row` for each row of a CSV after its first line, which must be `head`. Throws Refused; if `row`
// does, it adds the line's number.
void forRows(const std::string &csv, const std::string &head,
             const std::function<void(const std::string &line)> &row);

// A list as CSV, in order of time: "at,time,kind,level,width,height,seconds", where the kind is "traced" or
// "between". parseShown() throws Refused with the line's number.
std::string printShown(const std::vector<ShownPicture> &list);
std::vector<ShownPicture> parseShown(const std::string &csv);

// The two traced pictures from which an in-between was made: the last one before it and the first one after
// it. For a traced picture both are the picture itself.
struct MadeFrom {
    const ShownPicture &earlier, &later;
    double gap() const; // in sixtieths of a second
};
MadeFrom madeFrom(const std::vector<ShownPicture> &list, size_t i);

// Index of the picture on the screen at a moment; -1 before the first one.
int onScreenAt(const std::vector<ShownPicture> &list, double seconds);

} // namespace odraz::measure
