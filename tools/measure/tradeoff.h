// The sweeps of `tradeoff`: what is paid, and what is had for it. They throw Refused where what they were
// given is wrong, std::runtime_error where something fails.
#pragma once

#include "tools/measure/plot.h"

#include <vector>

namespace odraz {

struct Sweep {
    bool quick = false;
    bool named = false;    // trace: the named qualities and plain grids alone
    std::string csv, plot; // files to write; empty for none
};

// What a sweep finds: lines of CSV, printed while they are found, and points of a plot.
class Table {
public:
    // `head`: the columns' names.
    Table(const std::string &head, Plot plot);
    // A line, as printf has it.
    void row(const char *format, ...) __attribute__((format(printf, 2, 3)));
    // Writes what the sweep asks for.
    void save(const Sweep &sweep) const;

    Plot plot;

private:
    std::string csv;
};

struct TraceSweep : Sweep {
    std::vector<std::string>
        pictures; // names for findPicture(); a scene alone means all its cameras. Empty: all
    std::vector<std::string> settings; // in words (setting.h), instead of all
    std::string references;            // a folder that keeps them from run to run; empty: none does
};
void tradeoffTrace(const TraceSweep &sweep);

// Solutions of generated models and of the film's hall, against references by rays.
void tradeoffRadiosity(const Sweep &sweep);

// The hall's transfer compressed in several ways.
void tradeoffTransfer(const Sweep &sweep);

// `model`: a file of contexts to start from, those that ship; empty for ordinary ones.
void tradeoffPack(const Sweep &sweep, const std::string &film, const std::string &model);

} // namespace odraz
