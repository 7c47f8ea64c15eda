#include "tools/common/arguments.h"
#include "tools/common/clock.h"
#include "tools/common/whole_file.h"
#include "tools/measure/corpus.h"
#include "tools/measure/tradeoff.h"

#include "elf_writer.h"
#include "search.h"
#include "shape.h"
#include "stub.h"

using namespace pack;
using odraz::processorSeconds;

namespace {

enum Series { kContexts, kMemory, kSearch };

struct Setting {
    std::string name;
    int series;
    uint32_t contexts, slotBits;
    double effort; // seconds
    bool shipped;
};

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

void odraz::tradeoffPack(const Sweep &sweep, const std::string &film, const std::string &model) {
    Program program = programIn(film);
    program.early = kNothingEarly;
    Shape ships = defaultShape();
    if (!model.empty())
        if (std::string wrong = parseShape(readWhole(model), ships); !wrong.empty())
            throw Refused(model + ": " + wrong);

    // Fewer and more contexts, each with a little search to settle in; less memory; more search
    std::vector<Setting> settings;
    double settle = sweep.quick ? 0 : 10;
    for (uint32_t n : {4u, 8u, 12u, 16u, 20u, 24u})
        if (!sweep.quick || n % 8 == 0)
            settings.push_back({std::to_string(n) + " contexts", kContexts, n, ships.slotBits,
                                n == ships.contexts ? 0 : settle, n == ships.contexts});
    for (uint32_t bits : {16u, 18u, 20u, 21u, 22u, 23u})
        if (bits != ships.slotBits && (!sweep.quick || bits == 18))
            settings.push_back(
                {"2^" + std::to_string(bits) + " slots", kMemory, ships.contexts, bits, 0, false});
    if (!sweep.quick)
        for (double effort : {0., 5., 20., 60.})
            settings.push_back({std::to_string((int)effort) + " s of search", kSearch, ships.contexts,
                                ships.slotBits, effort, false});

    std::string name = film.substr(film.rfind('/') + 1);
    Table table("file,setting,shipped,bytes,encode_s,decode_kb_s,memory_mb",
                {"pack: " + name,
                 "KB decoded in a second of processor time",
                 "payload, bytes",
                 {"contexts", "memory", "search"},
                 {},
                 true,
                 false,
                 false,
                 true});
    Layout layout = program.layout();
    Workspace workspace;
    for (const Setting &s : settings) {
        // The search shows from ordinary contexts; what ships has been searched for already
        Shape shape = shapeOf(s, s.series == kSearch ? defaultShape() : ships);
        double began = processorSeconds();
        if (s.effort > 0)
            shape = search(filter(program.bytes, layout), layout, shape, s.effort,
                           [](const Progress &) { return true; });
        Encoded e = encode(program.bytes, layout, shape, workspace);
        double encoding = processorSeconds() - began;
        std::vector<uint8_t> packed = writePacked(program, shape, e.payload);
        began = processorSeconds();
        if (decodeWithStub(packed) != program.bytes) throw std::runtime_error(film + " came back damaged");
        double speed = (double)program.bytes.size() / 1024 / (processorSeconds() - began);
        table.row("%s,%s,%d,%zu,%.2f,%.0f,%.1f", name.c_str(), s.name.c_str(), s.shipped, e.payload.size(),
                  encoding, speed, stubMemory(shape, layout.size) / 1048576.0);
        table.plot.points.push_back({speed, (double)e.payload.size(), s.name, s.shipped, s.series});
    }
    table.save(sweep);
}
