// tradeoff: measures speed against accuracy or size, as a table and a plot.
#include "tradeoff.h"

#include <cstdio>
#include <cstring>

static constexpr char kUsage[] =
    "usage: tradeoff pack [--quick] [--csv FILE] [--plot FILE] [FILM]\n"
    "pack: how small the packer makes FILM (build/odraz-safe) with less and "
    "more search, contexts and memory,\n"
    "      against how fast that is decoded; --quick leaves out most; --model: the contexts that ship, like\n"
    "      tests/odraz.model\n";

int main(int argc, char **argv) {
    Sweep sweep;
    std::string what, film = "build/odraz-safe", model;
    for (int i = 1; i < argc; ++i) {
        if (!std::strcmp(argv[i], "--help")) {
            std::fputs(kUsage, stdout);
            return 0;
        }
        if (!std::strcmp(argv[i], "--quick"))
            sweep.quick = true;
        else if (!std::strcmp(argv[i], "--csv") && i + 1 < argc)
            sweep.csv = argv[++i];
        else if (!std::strcmp(argv[i], "--plot") && i + 1 < argc)
            sweep.plot = argv[++i];
        else if (!std::strcmp(argv[i], "--model") && i + 1 < argc)
            model = argv[++i];
        else if (argv[i][0] != '-' && what.empty())
            what = argv[i];
        else if (argv[i][0] != '-' && what == "pack")
            film = argv[i];
        else {
            std::fprintf(stderr, "tradeoff: cannot use '%s'; see tradeoff --help\n", argv[i]);
            return 2;
        }
    }
    if (what == "pack") return tradeoffPack(sweep, film, model);
    std::fprintf(stderr, "tradeoff: name what to measure: pack\n");
    return 2;
}
