#include "tools/radiosity/export/export_command.h"

#include "tools/engine/machine.h"
#include "tools/radiosity/export/atlas.h"
#include "tools/radiosity/export/points_export.h"
#include "tools/radiosity/transfer/relight_options.h"

#include <cstdio>

namespace odraz::radiosity {

int runExport(common::Arguments &words) {
    std::string in, kind, out, ofAtlas;
    AtlasSettings s;
    RelightOptions relight;
    while (const char *word = words.next()) {
        std::string w = word;
        if (w == "--csv" || w == "--ply" || w == "--obj" || w == "--atlas") {
            if (!out.empty()) throw common::Refused("export writes one thing at a time");
            kind = w, out = words.value(w);
        } else if (word[0] != '-' && in.empty()) {
            in = w;
            continue;
        } else if (relight.take(w, words))
            continue;
        else if (w == "--map")
            s.radiosity = words.choice(w, "radiosity", "light");
        else if (w == "--texels")
            s.texels = words.number(w, 1e-9, 1e9);
        else if (w == "--padding")
            s.padding = words.whole(w, 1, 64);
        else if (w == "--page")
            s.page = words.whole(w, 256, 16384);
        else
            words.refuse(w);
        if (w != kind) ofAtlas = w;
    }
    if (in.empty() || out.empty())
        throw common::Refused("export needs a solution and a file: radiosity export OUT --csv FILE");
    if (!ofAtlas.empty() && kind != "--atlas") throw common::Refused(ofAtlas + " belongs to --atlas DIR");
    Workers workers = allProcessors();
    Solution solution = readLit(in, relight, workers);
    if (kind == "--atlas") {
        std::vector<std::string> notes;
        exportAtlas(solution, s, out, notes);
        for (const std::string &note : notes) std::printf("%s\n", note.c_str());
        return 0;
    }
    kind == "--csv"   ? exportCsv(solution, out)
    : kind == "--ply" ? exportPly(solution, out)
                      : exportObj(solution, out);
    return 0;
}

} // namespace odraz::radiosity
