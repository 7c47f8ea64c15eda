// tradeoff: measures speed against accuracy or size, as a table and a plot.
#include "tools/measure/sweep/tradeoff.h"

#include "tools/common/whole_file.h"

#include <cstdio>

namespace odraz::measure {

void Sweep::read(common::CommandLine &line) {
    line.flag("--quick", quick, "measure few settings, small pictures");
    line.option("--csv", "FILE", csv, "write the table there, too");
    line.option("--plot", "FILE", plot, "write a plot of it, as SVG");
    line.parse();
    for (const std::string &file : {csv, plot})
        if (!file.empty()) common::claimOutput(file);
}

Table::Table(const std::string &head, pictures::Plot plot) : plot(std::move(plot)) { row(head); }

void Table::row(const std::string &line) {
    std::puts(line.c_str());
    std::fflush(stdout);
    csv += line + "\n";
}

void Table::save(const Sweep &sweep) const {
    if (!sweep.csv.empty()) common::writeWhole(sweep.csv, csv);
    if (!sweep.plot.empty()) common::writeWhole(sweep.plot, pictures::svg(plot));
}

static int run(common::CommandLine &line) {
    line.about("Tries several settings and prints a CSV: what each costs and what it yields.");
    return line.run({{"trace", "the tracer: processor time against FLIP and PSNR", tradeoffTrace},
                     {"pack", "the packer: size against the speed of decoding", tradeoffPack}});
}

} // namespace odraz::measure

int main(int argc, char **argv) { return common::runProgram("tradeoff", argc, argv, odraz::measure::run); }
