#include "files.h"
#include "tools/measure/plot.h"
#include "program.h"
#include "search.h"
#include "shape.h"
#include "tools/measure/tradeoff.h"

#include <cstdio>
#include <cstring>
#include <ctime>

using namespace pack;

namespace {

enum Series { kContexts, kMemory, kSearch };

struct Setting {
    std::string name;
    int series;
    uint32_t contexts, slotBits;
    double effort; // seconds
    bool shipped;
};

double now() { return (double)std::clock() / CLOCKS_PER_SEC; }

// The shape that ships with another number of contexts: the first ones, or more, of two fields each.
Shape shapeOf(const Setting &s, const Shape &ordinary) {
    Shape shape = {s.contexts, s.slotBits, {}};
    for (int type = 0; type < 2; ++type) {
        for (uint32_t i = 0; i < s.contexts; ++i)
            shape.masks[type][i] = i < ordinary.contexts ? ordinary.masks[type][i] : (uint16_t)(3 << i % 15);
        for (uint32_t i = 0; i < kSets - 1; ++i)
            shape.masks[type][s.contexts + i] = ordinary.masks[type][ordinary.contexts + i];
    }
    return shape;
}

} // namespace

int tradeoffPack(const Sweep &sweep, const std::string &film, const std::string &model) {
    std::vector<uint8_t> file;
    if (!readFile(film.c_str(), file)) {
        std::perror(("tradeoff: cannot read " + film).c_str());
        return 2;
    }
    Program program;
    try {
        program = readProgram(file);
    } catch (const Unsuitable &e) {
        std::fprintf(stderr, "tradeoff: %s: %s\n", film.c_str(), e.what());
        return 2;
    }
    program.early = kNothingEarly;
    Shape ships = defaultShape();
    if (!model.empty()) {
        std::vector<uint8_t> text;
        std::string wrong;
        if (!readFile(model.c_str(), text))
            wrong = "cannot be read";
        else
            wrong = parseShape({text.begin(), text.end()}, ships);
        if (!wrong.empty()) {
            std::fprintf(stderr, "tradeoff: %s: %s\n", model.c_str(), wrong.c_str());
            return 2;
        }
    }

    // Fewer and more contexts, each with a little search to settle in; less memory; more search
    std::vector<Setting> settings;
    double settle = sweep.quick ? 0 : 10;
    for (uint32_t n : {4u, 8u, 12u, 16u, 20u, 24u})
        if (!sweep.quick || n % 8 == 0)
            settings.push_back({std::to_string(n) + " contexts", kContexts, n, 22,
                                n == ships.contexts ? 0 : settle, n == ships.contexts});
    for (uint32_t bits : {16u, 18u, 19u, 20u, 21u, 23u})
        if (!sweep.quick || bits == 18)
            settings.push_back(
                {"2^" + std::to_string(bits) + " slots", kMemory, ships.contexts, bits, 0, false});
    if (!sweep.quick)
        for (double effort : {0., 5., 20., 60.})
            settings.push_back(
                {std::to_string((int)effort) + " s of search", kSearch, ships.contexts, 22, effort, false});

    std::string csv = "file,setting,shipped,bytes,encode_s,decode_kb_s,memory_mb\n";
    Plot plot = {"pack: " + film.substr(film.rfind('/') + 1),
                 "KB decoded in a second of processor time",
                 "payload, bytes",
                 {"contexts", "memory", "search"},
                 {},
                 true,
                 false,
                 false,
                 true};
    std::fputs(csv.c_str(), stdout);
    Layout layout = program.layout();
    Workspace workspace;
    for (const Setting &s : settings) {
        // The search shows from ordinary contexts; what ships has been searched for already
        Shape shape = shapeOf(s, s.series == kSearch ? defaultShape() : ships);
        double began = now();
        if (s.effort > 0)
            shape = search(filter(program.bytes, layout), layout, shape, s.effort,
                           [](const Progress &) { return true; });
        Encoded e = encode(program.bytes, layout, shape, workspace);
        double encoding = now() - began;
        std::vector<uint8_t> packed = writePacked(program, shape, e.payload);
        began = now();
        if (decodeWithStub(packed) != program.bytes) {
            std::fprintf(stderr, "tradeoff: %s came back damaged\n", film.c_str());
            return 1;
        }
        double speed = (double)program.bytes.size() / 1024 / (now() - began);
        char line[300];
        std::snprintf(line, sizeof line, "%s,%s,%d,%zu,%.2f,%.0f,%.1f\n", plot.title.c_str() + 6,
                      s.name.c_str(), s.shipped, e.payload.size(), encoding, speed,
                      stubMemory(shape, layout.size) / 1048576.0);
        std::fputs(line, stdout);
        std::fflush(stdout);
        csv += line;
        plot.points.push_back({speed, (double)e.payload.size(), s.name, s.shipped, s.series});
    }
    return saveText(sweep.csv, csv) && saveText(sweep.plot, svg(plot)) ? 0 : 1;
}
