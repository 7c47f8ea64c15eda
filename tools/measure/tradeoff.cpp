// tradeoff: measures speed against accuracy or size, as a table and a plot.
#include "tools/measure/tradeoff.h"

#include "tools/common/arguments.h"
#include "tools/common/whole_file.h"

#include <cstdarg>
#include <cstdio>

namespace odraz {

Table::Table(const std::string &head, Plot plot) : plot(std::move(plot)) { row("%s", head.c_str()); }

void Table::row(const char *format, ...) {
    char line[400];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    std::puts(line);
    std::fflush(stdout);
    csv += std::string(line) + "\n";
}

void Table::save(const Sweep &sweep) const {
    if (!sweep.csv.empty()) writeWhole(sweep.csv, csv);
    if (!sweep.plot.empty()) writeWhole(sweep.plot, svg(plot));
}

} // namespace odraz

using namespace odraz;

static constexpr char kUsage[] =
    "usage: tradeoff trace [--quick] [--named] [--scene NAME]... [--setting WORDS]... [--references FOLDER]\n"
    "                      [--csv FILE] [--plot FILE]\n"
    "       tradeoff radiosity [--quick] [--csv FILE] [--plot FILE]\n"
    "       tradeoff transfer [--quick] [--csv FILE] [--plot FILE]\n"
    "       tradeoff pack [--quick] [--model FILE] [--csv FILE] [--plot FILE] [FILM]\n"
    "trace: how near to 256 samples a pixel the tracer's settings come, against processor time: mean FLIP, "
    "and\n"
    "       PSNR in linear light and in sRGB. --quick leaves out most settings, traces small pictures, and "
    "of "
    "each\n"
    "       scene one; --scene: all cameras of one alone (A) or one picture (A/0), all knobs; --named: the "
    "named\n"
    "       qualities and plain grids alone; --setting: those given, as play or "
    "draft,threshold=0.02,cutoff=1/64;\n"
    "       --references: keeps what is compared with in a folder, for runs of one commit\n"
    "radiosity: how near to references by rays solutions come, against processor time\n"
    "transfer: how near the hall's transfer is when it is compressed, against the time of relighting: of "
    "rows of\n"
    "       texels (pca, blocks, cpca: Frobenius error of the matrix), of the floor's gloss (rms of what "
    "the eye\n"
    "       gets), of fewer bands (rms of the day's light)\n"
    "pack:  how small the packer makes FILM (build/odraz-safe) with less and more search, contexts,\n"
    "       and memory, against how fast that is decoded; --model: the contexts that ship "
    "(intro/odraz.model)\n"
    "--csv and --plot write the table and a picture of it as SVG.\n";

static int run(Arguments &words) {
    TraceSweep sweep;
    std::string what, film = "build/odraz-safe", model;
    while (const char *word = words.next()) {
        std::string w = word;
        if (w == "--quick")
            sweep.quick = true;
        else if (w == "--named" && what == "trace")
            sweep.named = true;
        else if (w == "--csv" || w == "--plot") {
            std::string &to = w == "--csv" ? sweep.csv : sweep.plot;
            to = words.value(w);
            checkWritable(to);
        } else if (w == "--model" && what == "pack")
            model = words.value(w);
        else if (w == "--scene" && what == "trace")
            sweep.pictures.push_back(words.value(w));
        else if (w == "--setting" && what == "trace")
            sweep.settings.push_back(words.value(w));
        else if (w == "--references" && what == "trace")
            sweep.references = words.value(w);
        else if (word[0] != '-' && what.empty())
            what = w;
        else if (word[0] != '-' && what == "pack")
            film = w;
        else
            words.refuse(w);
    }
    if (what == "trace")
        tradeoffTrace(sweep);
    else if (what == "radiosity")
        tradeoffRadiosity(sweep);
    else if (what == "transfer")
        tradeoffTransfer(sweep);
    else if (what == "pack")
        tradeoffPack(sweep, film, model);
    else
        throw Refused("name what to measure: trace, radiosity, transfer or pack");
    return 0;
}

int main(int argc, char **argv) { return runProgram("tradeoff", kUsage, argc, argv, run); }
