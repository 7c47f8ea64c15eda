// Compares the packer with general packers that are installed, on machine code.
#include "tools/common/clock.h"
#include "tools/common/command_line.h"
#include "tools/common/folders.h"
#include "tools/common/whole_file.h"
#include "tools/measure/bench/corpus.h"

#include "packer/model/model_parameters.h"
#include "packer/model/search.h"
#include "packer/write/packed_file.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

using namespace pack;
using common::processorSeconds;

namespace {

struct Peer {
    const char *name, *program, *command; // packs the file %s to standard output
    bool there;
};

Peer thePeers[] = {
    {"xz -9e --x86", "xz", "xz --x86 --lzma2=preset=9e -k -c %s", false},
    {"zstd --ultra -22", "zstd", "zstd --ultra -22 -q -c %s", false},
    {"brotli -q 11", "brotli", "brotli -q 11 -w 24 -c %s", false},
    {"zpaq -m5", "zpaq", "zpaq a %s.zpaq %s -m5 >/dev/null 2>&1; cat %s.zpaq; rm -f %s.zpaq", false},
};

std::string replaced(std::string text, const std::string &by) {
    for (size_t at; (at = text.find("%s")) != std::string::npos;) text.replace(at, 2, by);
    return text;
}

// The size that a peer packs a file to, in bytes; negative if it fails.
long packedSize(const Peer &peer, const std::string &path) {
    std::string out = path + ".out";
    if (std::system((replaced("{ " + std::string(peer.command) + "; } > ", path) + out).c_str())) return -1;
    return (long)std::filesystem::file_size(out);
}

// Packs the sample, decodes it with the stub's code, and prints the rest of the sample's line.
void packSample(const Sample &s, ModelParameters parameters, double effort, const long (&sizes)[4]) {
    static Workspace workspace;
    const Layout &layout = s.layout;
    if (effort > 0)
        parameters = search(filter(s.bytes, layout), layout, parameters, effort,
                            [](const Progress &) { return true; });
    double began = common::processorSeconds();
    Encoded e = encode(s.bytes, layout, parameters, workspace);
    double encoding = common::processorSeconds() - began;
    Program program = {};
    program.base = 0x400000;
    program.span = (uint32_t)wholePages(s.bytes.size());
    program.bytes = s.bytes;
    program.codeBegin = layout.codeBegin;
    program.codeSize = layout.codeSize;
    program.early = kNothingEarly;
    program.slots[1] = 8;
    Bytes packed = kElf.write(program, parameters, e.payload, {});
    began = common::processorSeconds();
    bool whole = decodeWithStub(kElf, packed) == s.bytes;
    double decoding = common::processorSeconds() - began;
    if (!whole) throw std::runtime_error(s.name + " came back damaged");
    double size = (double)e.payload.size();
    std::printf(" %.0f |", size);
    for (int peer : {0, 3}) {
        if (sizes[peer] > 0)
            std::printf(" %.2f |", size / (double)sizes[peer]);
        else
            std::printf(" |");
    }
    std::printf(" %.2f | %.0f |\n", encoding, (double)s.bytes.size() / 1024 / decoding);
    std::fflush(stdout);
}

int run(common::CommandLine &line) {
    double effort = 0;
    std::string film = "build/odraz-safe", only, model;
    line.about("Compares the packer with general packers that are installed, on machine code.");
    line.argument("FILM", film, "a path of odraz-safe", false);
    line.option("--effort", "SECONDS", effort, {0, 1e6}, "search on each sample");
    line.option("--model", "FILE", model, "pack the film once more, with the contexts in FILE");
    line.option("--only", "SAMPLE", only, "pack one sample, without the other packers");
    line.parse();
    common::TemporaryFolder folder;
    for (Peer &peer : thePeers) {
        peer.there =
            only.empty() && !std::system(("command -v " + std::string(peer.program) + " >/dev/null").c_str());
        if (!peer.there && only.empty()) std::printf("(%s is not installed: skipped)\n", peer.program);
    }
    std::vector<std::string> missing;
    std::vector<Sample> samples = corpus(film, missing);
    for (auto &name : missing) std::printf("(%s is not there: skipped)\n", name.c_str());
    std::printf("\n| code | bytes |");
    for (Peer &p : thePeers)
        if (p.there) std::printf(" %s |", p.name);
    std::printf(" odraz's pack | to xz | to zpaq | encode s | decode KB/s |\n|---|---|");
    for (Peer &p : thePeers)
        if (p.there) std::printf("---|");
    std::printf("---|---|---|---|---|\n");
    for (const Sample &s : samples) {
        if (!only.empty() && s.name != only) continue;
        std::string path = folder / "sample";
        writeBytes(path, s.bytes);
        std::printf("| %s | %zu |", s.name.c_str(), s.bytes.size());
        long sizes[4] = {-1, -1, -1, -1};
        for (int i = 0; i < 4; ++i)
            if (thePeers[i].there) std::printf(" %ld |", sizes[i] = packedSize(thePeers[i], path));
        packSample(s, defaultParameters(), effort, sizes);
        if (s.name != kWholeFilm || model.empty()) continue;
        ModelParameters itsOwn = readParameters(model);
        std::printf("| ... with its own contexts | %zu |", s.bytes.size());
        for (int i = 0; i < 4; ++i)
            if (thePeers[i].there) std::printf(" %ld |", sizes[i]);
        packSample(s, itsOwn, 0, sizes);
    }
    return 0;
}

} // namespace

int main(int argc, char **argv) { return common::runProgram("bench_pack", argc, argv, run); }
