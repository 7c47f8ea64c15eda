// tradeoff: measures speed against accuracy or size, as a table and a plot.
#include "tools/measure/sweep/tradeoff.h"

#include "tools/common/arguments.h"
#include "tools/common/whole_file.h"

#include <cstdarg>
#include <cstdio>

namespace odraz {

Table::Table(const std::string &head, pictures::Plot plot) : plot(std::move(plot)) {
    row("%s", head.c_str());
}

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
    if (!sweep.csv.empty()) common::writeWhole(sweep.csv, csv);
    if (!sweep.plot.empty()) common::writeWhole(sweep.plot, pictures::svg(plot));
}

} // namespace odraz

using namespace odraz;

static constexpr char kUsage[] =
    "usage: tradeoff trace [--quick] [--named] [--scene NAME]... [--setting WORDS]...\n"
    "                      [--references FOLDER] [--width PX] [--csv FILE] [--plot FILE]\n"
    "       tradeoff radiosity [--quick] [--csv FILE] [--plot FILE]\n"
    "       tradeoff transfer [--quick] [--csv FILE] [--plot FILE]\n"
    "       tradeoff pack [--quick] [--model FILE] [--csv FILE] [--plot FILE] [FILM]\n"
    "Each measures several settings and prints a CSV: what a setting costs and what it yields.\n"
    "trace:     the tracer's settings: processor time against mean FLIP and PSNR (in linear light and in\n"
    "           sRGB), compared with 256 samples a pixel.\n"
    "           --quick      few settings, small pictures, one camera of each scene\n"
    "           --scene      only this scene (A: all its cameras) or this picture (A/0)\n"
    "           --named      only the named qualities and plain grids\n"
    "           --setting    only this setting, as play or draft,threshold=0.02,cutoff=1/64\n"
    "           --width      of the pictures, in pixels (default 1280)\n"
    "           --references keep the pictures that are compared with in FOLDER, for runs of one commit\n"
    "radiosity: solutions: processor time against the error, compared with rays\n"
    "transfer:  the hall's transfer, compressed: time of relighting against the error of the rows (pca,\n"
    "           blocks, cpca: Frobenius), of the floor's gloss (rms of what the eye sees) and of the day's\n"
    "           light by fewer bands (rms)\n"
    "pack:      FILM (build/odraz-safe) packed with less and more search, contexts and memory: its size\n"
    "           against how fast it is decoded. --model: the contexts that ship (intro/odraz.model)\n"
    "--csv and --plot write the table, and a plot of it as SVG.\n";

static int run(common::Arguments &words) {
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
            common::checkWritable(to);
        } else if (w == "--model" && what == "pack")
            model = words.value(w);
        else if (w == "--scene" && what == "trace")
            sweep.pictures.push_back(words.value(w));
        else if (w == "--setting" && what == "trace")
            sweep.settings.push_back(words.value(w));
        else if (w == "--width" && what == "trace")
            sweep.width = words.whole("--width", 64, 3840) / 16 * 16;
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
        throw common::Refused("name what to measure: trace, radiosity, transfer or pack");
    return 0;
}

int main(int argc, char **argv) { return common::runProgram("tradeoff", kUsage, argc, argv, run); }
