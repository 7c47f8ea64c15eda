// The sweeps of `tradeoff`: what each setting costs and what it gains. Each is a command of the program.
#pragma once

#include "tools/common/command_line.h"
#include "tools/picture/plot.h"

namespace odraz::measure {

// The options of all sweeps.
struct Sweep {
    bool quick = false;
    std::string csv, plot; // files to write; empty for none
    // Adds the options and reads the command line. Throws Refused if a file cannot be written.
    void read(common::CommandLine &line);
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
    // Prints a line.
    void row(const std::string &line);
    // Writes the files that the sweep asks for.
    void save(const Sweep &sweep) const;

    pictures::Plot plot;

private:
    std::string csv;
};

// Settings of the tracer: time against FLIP and PSNR.
int tradeoffTrace(common::CommandLine &line);
// A film packed with less and more search, contexts and memory: size against the speed of decoding.
int tradeoffPack(common::CommandLine &line);

} // namespace odraz::measure
