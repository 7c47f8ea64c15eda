// What each part of a program costs, packed, and how that changed.
#pragma once

#include "packer/report/attribution.h"

#include <cmath>
#include <map>

namespace pack {

struct Cost {
    uint64_t bytes = 0; // not packed
    double bits = 0;    // packed
};
using Costs = std::map<std::string, Cost>;

// Whether any part is named.
bool hasNames(const Costs &costs);

// Costs are multiples of a sixteenth of a bit, so that they add up: the file's bits are those of `overhead`,
// the costs of all sections, and `rest`. Objects, rooms and symbols add up in the same way. (Without a map
// there are no objects and no rooms.)
struct Report {
    size_t fileSize = 0, overhead = 0; // of the packed file; overhead: what is not payload
    double rest = 0;                   // bits: the payload's end, and zeros up to a multiple of bytes
    Costs sections, objects, symbols, rooms;
    std::map<std::string, std::string> roomOf = {}; // an object's
    std::map<std::string, long> shares = {};        // bytes that a room may take, if they were given
    std::string stubRoom = {};                      // the room of stub and headers, if one was given
    std::vector<Stretch> stretches = {};            // of the program, all of it
    std::vector<uint16_t> sixteenths = {};          // the cost of each byte of the program
};
inline constexpr int kUnit = 16; // units in a bit

// Rounds numbers so that the results add up to the rounded sum.
class Rounding {
public:
    double operator()(double value) {
        double before = std::round(sum);
        sum += value;
        return std::round(sum) - before;
    }

private:
    double sum = 0;
};

// A file of rooms, a line each: ROOM SHARE OBJECT..., the share in bytes or -. The room of "(stub)"
// is that of stub and headers.
struct Rooms {
    std::map<std::string, std::string> of; // an object's
    std::map<std::string, long> shares;
};
inline constexpr char kStub[] = "(stub)";

// Throws common::Refused with the line that is wrong.
Rooms readRooms(const std::string &text);

// `bits`: the cost of each byte of the program; `stretches`: what attribute() makes. With `rooms`, an object
// that they do not name has none; without, its room is its archive or folder.
Report makeReport(std::vector<Stretch> stretches, const std::vector<float> &bits, size_t fileSize,
                  size_t overhead, const Rooms *rooms = nullptr);

// As text: the object files by their cost, and the twenty costliest symbols.
std::string printReport(const Report &report);

// As JSON (without a library, because the film's build has none), one part a line, ordered by name, costs in
// whole bits, which add up like those of the report.
std::string printJson(const Report &report);

// Gives an earlier report the rooms of a later one, so that they can be compared: an object is where it is
// now or, if it is gone, where it was.
void arrange(Report &before, const Report &now);

// For a comment on a change, in Markdown that can be read as it stands: the total, how it changed, what is
// left of the budget (if there is one: >= 0), and the ten parts that changed most; if there is nothing to
// compare with, the ten that cost most. Parts are symbols, or objects or sections if one of the two reports
// has no symbols.
std::string printMarkdown(const std::string &name, const Report &report, const Report *before, long budget);

} // namespace pack
