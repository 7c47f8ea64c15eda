// The packed size of each part of a program, and how it changed.
#pragma once

#include "packer/report/attribution.h"

#include <cmath>
#include <map>

namespace pack {

struct Cost {
    uint64_t bytes = 0; // size before packing
    double bits = 0;    // size after packing
};
using Costs = std::map<std::string, Cost>;

// Costs are multiples of a sixteenth of a bit, so they add up exactly: the sum of `overhead`, the costs of
// all sections and `rest` is `fileSize`. Symbols and, if there is a map, objects and rooms add up likewise.
struct Report {
    size_t fileSize = 0, overhead = 0; // bytes used of the packed file; how many of them are not payload
    double rest = 0;                   // bits at the payload's end and of the padding to whole bytes
    Costs sections, objects, symbols, rooms;
    std::map<std::string, std::string> roomOf = {}; // room of each object
    std::map<std::string, long> shares = {};        // bytes that each room may take, if given
    std::string stubRoom = {};                      // room of stub and headers, if given
    std::vector<Stretch> stretches = {};            // the whole program
    std::vector<uint16_t> sixteenths = {};          // cost of each byte of the program
};
inline constexpr int kUnit = 16; // units in a bit

// The kinds of parts, from the largest.
struct PartKind {
    const char *name, *table; // for one part, and for all in JSON
    Costs Report::*costs;
    std::string Stretch::*part;
};
inline constexpr PartKind kPartKinds[] = {{"room", "rooms", &Report::rooms, &Stretch::room},
                                          {"section", "sections", &Report::sections, &Stretch::section},
                                          {"object file", "objects", &Report::objects, &Stretch::object},
                                          {"symbol", "symbols", &Report::symbols, &Stretch::symbol}};

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

// A file of rooms, a line each: ROOM SHARE OBJECT..., the share in bytes or -. "(stub)" is stub and headers.
struct Rooms {
    std::map<std::string, std::string> of; // room of each object
    std::map<std::string, long> shares;
};
inline constexpr char kStub[] = "(stub)";

// Throws common::Refused, which names the wrong line.
Rooms readRooms(const std::string &text);

// `stretches`: the result of attribute(). `bits`: the cost of each byte of the program. Without `rooms`, the
// room of an object is its archive or folder. With `rooms`, an object that they do not name has no room.
Report makeReport(std::vector<Stretch> stretches, const std::vector<float> &bits, size_t fileSize,
                  size_t overhead, const Rooms *rooms = nullptr);

// Returns the report as text: the object files by cost, and the twenty costliest symbols.
std::string printReport(const Report &report);

// Returns the report as JSON, with one part per line, ordered by name. Costs are whole bits, which add up
// like the costs of the report. (It uses no library, since the film's build must not need one.)
std::string printJson(const Report &report);

// Moves the objects of an earlier report to the rooms that they have in a later report, so that the reports
// can be compared. An object that the later report lacks keeps its room.
void arrange(Report &before, const Report &now);

// Returns Markdown for a comment on a change, which is also readable as plain text: the total, its change,
// the bytes left of the budget (a negative budget means none), and the ten parts that changed most. Without
// an earlier report it lists the ten parts that cost most. The parts are symbols or, if one of the reports
// has no symbols, objects or sections.
std::string printMarkdown(const std::string &name, const Report &report, const Report *before, long budget);

} // namespace pack
