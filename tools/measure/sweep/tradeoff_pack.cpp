#include "tools/common/clock.h"
#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/measure/bench/corpus.h"
#include "tools/measure/sweep/tradeoff.h"

#include "packer/model/model_parameters.h"
#include "packer/model/search.h"
#include "packer/stub/stub.h"
#include "packer/write/packed_file.h"

namespace odraz::measure {

using namespace pack;

namespace {

enum Series { kContexts, kMemory, kSearch };

struct PackSettings {
    uint32_t contexts, slotBits;
    double effort; // seconds of search
};
using PackSetting = Setting<PackSettings>;

// A mask of two neighbouring fields for each i; once there are no more pairs, of three, and then of four.
uint32_t neighbours(int type, uint32_t i) {
    uint32_t first = type ? 0 : pack::kCodeShift, pairs = (type ? pack::kDataBits : pack::kCodeBits) - 1;
    return ((4u << i / pairs) - 1) << (first + i % pairs) & pack::kMayUse[type];
}

// Parameters with the given number of contexts: the first of `ordinary`, then arbitrary ones.
ModelParameters parametersOf(const PackSettings &s, const ModelParameters &ordinary) {
    ModelParameters parameters = {s.contexts, s.slotBits, {}};
    for (int type = 0; type < 2; ++type) {
        for (uint32_t i = 0; i < s.contexts; ++i)
            parameters.masks[type][i] = i < ordinary.contexts ? ordinary.masks[type][i] : neighbours(type, i);
        for (uint32_t i = 0; i < kSets - 1; ++i)
            parameters.masks[type][s.contexts + i] = ordinary.masks[type][ordinary.contexts + i];
    }
    return parameters;
}

// Settings with fewer contexts, each with a short search to adapt; with less and more memory; with searches.
std::vector<PackSetting> settingsOf(const ModelParameters &ships, bool quick) {
    std::vector<PackSetting> all;
    for (uint32_t n : {4u, 8u, 12u, 16u}) {
        bool shipped = n == ships.contexts;
        if (!quick || n < 12 || shipped)
            all.push_back({std::to_string(n) + " contexts",
                           {n, ships.slotBits, shipped || quick ? 0. : 4.},
                           shipped,
                           kContexts});
    }
    for (uint32_t bits : {16u, 18u, 20u, 22u, 23u})
        if (bits != ships.slotBits && (!quick || bits < 20))
            all.push_back(
                {"2^" + std::to_string(bits) + " slots", {ships.contexts, bits, 0}, false, kMemory});
    if (!quick)
        for (int effort : {0, 10})
            all.push_back({std::to_string(effort) + " s of search",
                           {ships.contexts, ships.slotBits, (double)effort},
                           false,
                           kSearch});
    return all;
}

} // namespace

int tradeoffPack(common::CommandLine &line) {
    Sweep sweep;
    std::string film, model;
    line.about("A film packed with less and more search, contexts and memory: its size against how fast it "
               "is decoded.");
    line.argument("FILM", film, "a program, not packed: build/odraz-safe");
    line.option("--model", "FILE", model, "start from these contexts: intro/odraz.model");
    sweep.read(line);
    Program program = programIn(film);
    program.early = kNothingEarly;
    ModelParameters ships = model.empty() ? defaultParameters() : readParameters(model);

    std::vector<PackSetting> settings = settingsOf(ships, sweep.quick);
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
    for (const PackSetting &s : settings) {
        // Searches start from arbitrary contexts: those that ship, and the default ones, are results of
        // searches
        ModelParameters parameters = parametersOf(s.value, s.series == kSearch ? ModelParameters{} : ships);
        double began = common::processorSeconds();
        if (s.value.effort > 0)
            parameters = search(filter(program.bytes, layout), layout, parameters, s.value.effort,
                                [](const Progress &) { return true; });
        Encoded e = encode(program.bytes, layout, parameters, workspace);
        double encoding = common::processorSeconds() - began;
        Bytes packed = kElf.write(program, parameters, e.payload, {});
        began = common::processorSeconds();
        if (decodeWithStub(kElf, packed) != program.bytes)
            throw std::runtime_error(film + " came back damaged");
        double speed = (double)program.bytes.size() / 1024 / (common::processorSeconds() - began);
        table.row(common::format("%s,%s,%d,%zu,%.2f,%.0f,%.1f", name.c_str(), s.name.c_str(), s.shipped,
                                 e.payload.size(), encoding, speed,
                                 stubMemory(parameters, layout.size) / 1048576.0));
        table.plot.points.push_back({speed, (double)e.payload.size(), s.name, s.shipped, s.series});
    }
    table.save(sweep);
    return 0;
}

} // namespace odraz::measure
