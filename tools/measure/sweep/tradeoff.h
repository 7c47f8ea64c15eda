// The sweeps of `tradeoff`: what each setting costs and what it gains. They throw Refused if their arguments
// are wrong, std::runtime_error if something fails.
#pragma once

#include "tools/picture/plot.h"

#include <vector>

namespace odraz {

struct Sweep {
    bool quick = false;
    bool named = false;    // trace: only the named qualities and plain grids
    std::string csv, plot; // files to write; empty for none
};

// A setting that a sweep tries: a point of its table and its plot.
template <class T> struct Setting {
    std::string name;
    T value;
    bool shipped = false;
    int series = 0; // of the plot
};

// The results of a sweep: lines of CSV, printed as they are found, and points of a plot.
class Table {
public:
    // `head`: the names of the columns.
    Table(const std::string &head, pictures::Plot plot);
    // Prints a line, formatted like printf.
    void row(const char *format, ...) __attribute__((format(printf, 2, 3)));
    // Writes the files that the sweep asks for.
    void save(const Sweep &sweep) const;

    pictures::Plot plot;

private:
    std::string csv;
};

struct TraceSweep : Sweep {
    std::vector<std::string>
        pictures; // names for findPicture(); a scene alone means all its cameras. Empty: all
    std::vector<std::string> settings; // in words (setting.h), instead of all
    int width = 1280;                  // of the pictures, in pixels; their height is 9/16 of it
    std::string references;            // a folder that keeps them for later runs; empty: none is kept
};
void tradeoffTrace(const TraceSweep &sweep);

// Compares solutions of generated models and of the film's hall with references by rays.
void tradeoffRadiosity(const Sweep &sweep);

// Compresses the hall's transfer in several ways.
void tradeoffTransfer(const Sweep &sweep);

// `model`: a file of contexts to start from, such as those that ship; empty: default contexts.
void tradeoffPack(const Sweep &sweep, const std::string &film, const std::string &model);

} // namespace odraz
