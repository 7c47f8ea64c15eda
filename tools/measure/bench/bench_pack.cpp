// bench_pack: measures the packer's compression and speed on a program or a part of one.
#include "tools/common/clock.h"
#include "tools/common/command_line.h"

#include "packer/model/model_parameters.h"
#include "packer/model/search.h"
#include "packer/read/program.h"
#include "packer/write/packed_file.h"

#include <cstdio>
#include <cstring>

using namespace pack;

namespace {

struct BenchOptions {
    std::string file, model;
    int contexts = 0, slots = 0; // 0: the model's
    double search = 0;           // seconds
    bool arbitrary = false;
};

// An arbitrary mask for each i: all pairs of neighbouring fields first, then triples, then fours.
uint32_t neighbours(int type, uint32_t i) {
    uint32_t first = type ? 0 : kCodeShift, pairs = (type ? kDataBits : kCodeBits) - 1;
    return ((4u << i / pairs) - 1) << (first + i % pairs) & kMayUse[type];
}

// The contexts of the model, followed by arbitrary ones.
ModelParameters parametersOf(const BenchOptions &o) {
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

// Reads an ELF program, or a file of instructions alone.
Program programIn(const std::string &path) {
    Bytes file = readBytes(path);
    if (file.size() > 4 && !std::memcmp(file.data(), "\177ELF", 4)) {
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

// Packs the file, decodes it with the stub's code, and prints the CSV.
void packFile(const BenchOptions &o) {
    Program program = programIn(o.file);
    Layout layout = program.layout();
    ModelParameters parameters = parametersOf(o);
    double began = common::processorSeconds();
    if (o.search > 0)
        parameters =
            search(program.bytes, layout, parameters, o.search, [](const Progress &) { return true; });
    Encoded e = encode(program.bytes, layout, parameters);
    double encoding = common::processorSeconds() - began;
    Bytes packed = kElf.write(program, parameters, e.payload, {});
    began = common::processorSeconds();
    bool same = decodeWithStub(kElf, packed) == program.bytes;
    double decoding = common::processorSeconds() - began;
    if (!same) throw std::runtime_error(o.file + ": verification failed: it was decoded to other bytes");
    std::printf("bytes,payload,encode_s,decode_kb_s,memory_mb\n%zu,%zu,%.2f,%.0f,%.1f\n",
                program.bytes.size(), e.payload.size(), encoding,
                (double)program.bytes.size() / 1024 / decoding,
                stubMemory(parameters, layout.size) / 1048576.0);
}

int run(common::CommandLine &line) {
    BenchOptions o;
    line.about("Packs a program, or a file of instructions alone. Prints sizes and speed as CSV.");
    line.argument("FILE", o.file, "an unpacked program, such as build/odraz-safe, or instructions");
    line.option("--model", "FILE", o.model, "use the contexts of this model, such as intro/odraz.model");
    line.option("--contexts", "N", o.contexts, {4, kMostContexts}, "use N contexts, a multiple of 4");
    line.option("--slots", "BITS", o.slots, {kLeastSlotBits, kMostSlotBits}, "use 2^BITS slots of memory");
    line.flag("--arbitrary", o.arbitrary, "start from arbitrary contexts instead of a model's");
    line.option("--search", "SECONDS", o.search, {0, 1e6}, "search for better contexts");
    line.parse();
    if (o.contexts % 4) line.refuse("--contexts needs a multiple of 4");
    packFile(o);
    return 0;
}

} // namespace

int main(int argc, char **argv) { return common::runProgram("bench_pack", argc, argv, run); }
