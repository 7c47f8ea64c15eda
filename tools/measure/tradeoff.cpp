// tradeoff: measures speed against accuracy or size, as a table and a plot.
#include "tools/measure/tradeoff.h"

#include "files.h"

#include <cstdio>
#include <cstring>
#include <unistd.h>

static constexpr char kUsage[] =
    "usage: tradeoff trace [--quick] [--scene NAME] [--csv FILE] [--plot FILE]\n"
    "       tradeoff radiosity [--quick] [--csv FILE] [--plot FILE]\n"
    "       tradeoff transfer [--quick] [--csv FILE] [--plot FILE]\n"
    "       tradeoff pack [--quick] [--model FILE] [--csv FILE] [--plot FILE] [FILM]\n"
    "trace: how near to 256 samples a pixel the tracer's settings come, against processor time;\n"
    "       --quick leaves out most settings and traces small pictures; --scene: one alone, all its knobs\n"
    "radiosity: how near to references by rays solutions come, against processor time\n"
    "transfer: how near the hall's transfer is when it is compressed, against the time of relighting: of "
    "rows of\n"
    "       elements (pca, blocks, cpca: Frobenius error of the matrix), of the floor's gloss (rms of what "
    "the eye\n"
    "       gets), of fewer bands (rms of the day's light)\n"
    "pack:  how small the packer makes FILM (build/odraz-safe) with less and more search, contexts,\n"
    "       and memory, against how fast that is decoded; --model: the contexts that ship "
    "(intro/odraz.model)\n"
    "--csv and --plot write the table and a picture of it as SVG.\n";

bool saveText(const std::string &path, const std::string &text) {
    if (path.empty() || pack::writeFile(path, text.data(), text.size(), false)) return true;
    std::perror(("tradeoff: cannot write " + path).c_str());
    return false;
}

// Better said before minutes of measuring than after.
static bool mayWrite(const std::string &path) {
    size_t slash = path.rfind('/');
    std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
    if (path.empty() || access(folder.c_str(), W_OK) == 0) return true;
    std::perror(("tradeoff: cannot write " + path).c_str());
    return false;
}

int main(int argc, char **argv) {
    Sweep sweep;
    std::string what, film = "build/odraz-safe", model, scene;
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
        else if (!std::strcmp(argv[i], "--model") && i + 1 < argc && what == "pack")
            model = argv[++i];
        else if (!std::strcmp(argv[i], "--scene") && i + 1 < argc && what == "trace")
            scene = argv[++i];
        else if (argv[i][0] != '-' && what.empty())
            what = argv[i];
        else if (argv[i][0] != '-' && what == "pack")
            film = argv[i];
        else {
            std::fprintf(stderr, "tradeoff: cannot use '%s'; see tradeoff --help\n", argv[i]);
            return 2;
        }
    }
    if (!mayWrite(sweep.csv) || !mayWrite(sweep.plot)) return 2;
    if (what == "trace") return tradeoffTrace(sweep, scene);
    if (what == "radiosity") return tradeoffRadiosity(sweep);
    if (what == "transfer") return tradeoffTransfer(sweep);
    if (what == "pack") return tradeoffPack(sweep, film, model);
    std::fprintf(stderr, "tradeoff: name what to measure: trace, radiosity, transfer or pack\n");
    return 2;
}
