// Packs programs, and parts of programs, with some settings of the packer: sizes and speed.
#include "tools/common/clock.h"
#include "tools/common/command_line.h"

#include "packer/model/model_parameters.h"
#include "packer/model/search.h"
#include "packer/read/programs.h"
#include "packer/stub/stub.h"
#include "packer/write/packed_file.h"

#include <cstdio>
#include <cstring>

using namespace pack;

namespace {

struct Options {
    std::string file, model;
    int contexts = 0, slots = 0; // 0: the model's
    double search = 0;           // seconds
    bool arbitrary = false;
};

// A mask of two neighbouring fields for each i; once there are no more pairs, of three, and then of four.
uint32_t neighbours(int type, uint32_t i) {
    uint32_t first = type ? 0 : kCodeShift, pairs = (type ? kDataBits : kCodeBits) - 1;
    return ((4u << i / pairs) - 1) << (first + i % pairs) & kMayUse[type];
}

// The first contexts of the model, then arbitrary ones.
ModelParameters parametersOf(const Options &o) {
    ModelParameters model = o.model.empty() ? defaultParameters() : readParameters(o.model),
                    parameters = {o.contexts ? (uint32_t)o.contexts : model.contexts,
                                  o.slots ? (uint32_t)o.slots : model.slotBits,
                                  {}};
    if (o.arbitrary) model = {};
    for (int type = 0; type < 2; ++type) {
        for (uint32_t i = 0; i < parameters.contexts; ++i)
            parameters.masks[type][i] = i < model.contexts ? model.masks[type][i] : neighbours(type, i);
        for (uint32_t i = 0; i < kSets - 1; ++i)
            parameters.masks[type][parameters.contexts + i] = model.masks[type][model.contexts + i];
    }
    return parameters;
}

// A program, or the instructions that a file consists of.
Program programIn(const std::string &path) {
    Bytes file = readBytes(path);
    if (file.size() > 4 && !std::memcmp(file.data(),
                                        "\x7f"
                                        "ELF",
                                        4)) {
        Program program = common::inFile(path, [&] { return readProgram(file); });
        program.early = kNothingEarly;
        return program;
    }
    Program program = {};
    program.base = 0x400000;
    program.span = (uint32_t)wholePages(file.size());
    program.codeSize = (uint32_t)file.size();
    program.bytes = std::move(file);
    program.early = kNothingEarly;
    program.slots[1] = 8;
    return program;
}

// Packs the file, decodes it with the stub's code, and prints its row.
void packFile(const Options &o) {
    Workspace workspace;
    Program program = programIn(o.file);
    Layout layout = program.layout();
    ModelParameters parameters = parametersOf(o);
    double began = common::processorSeconds();
    if (o.search > 0)
        parameters = search(filter(program.bytes, layout), layout, parameters, o.search,
                            [](const Progress &) { return true; });
    Encoded e = encode(program.bytes, layout, parameters, workspace);
    double encoding = common::processorSeconds() - began;
    Bytes packed = kElf.write(program, parameters, e.payload, {});
    began = common::processorSeconds();
    bool whole = decodeWithStub(kElf, packed) == program.bytes;
    double decoding = common::processorSeconds() - began;
    if (!whole) throw std::runtime_error(o.file + " came back damaged");
    std::printf("bytes,payload,encode_s,decode_kb_s,memory_mb\n%zu,%zu,%.2f,%.0f,%.1f\n",
                program.bytes.size(), e.payload.size(), encoding,
                (double)program.bytes.size() / 1024 / decoding,
                stubMemory(parameters, layout.size) / 1048576.0);
}

int run(common::CommandLine &line) {
    Options o;
    line.about("Packs a program, or a file of instructions alone. Prints a CSV: sizes and speed.");
    line.argument("FILE", o.file, "a program that is not packed, like build/odraz-safe, or instructions");
    line.option("--model", "FILE", o.model, "take its contexts, as of intro/odraz.model");
    line.option("--contexts", "N", o.contexts, {4, kMostContexts}, "so many contexts, a multiple of 4");
    line.option("--slots", "BITS", o.slots, {kLeastSlotBits, kMostSlotBits}, "memory: 2^BITS slots");
    line.flag("--arbitrary", o.arbitrary, "begin with arbitrary contexts, not with those of a model");
    line.option("--search", "SECONDS", o.search, {0, 1e6}, "search for better contexts");
    line.parse();
    if (o.contexts % 4) line.refuse("--contexts: a multiple of 4");
    packFile(o);
    return 0;
}

} // namespace

int main(int argc, char **argv) { return common::runProgram("bench_pack", argc, argv, run); }
