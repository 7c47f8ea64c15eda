// What the packer makes of machine code, against general packers that are installed.
//   bench_pack [--effort SECONDS] [FILM]     a search for each sample; FILM: a path of odraz-safe
#include "tools/measure/corpus.h"
#include "files.h"
#include "program.h"
#include "search.h"
#include "shape.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <unistd.h>

using namespace pack;

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

long packedSize(const Peer &peer, const std::string &path) {
    std::string out = path + ".out";
    if (std::system((replaced("{ " + std::string(peer.command) + "; } > ", path) + out).c_str())) return -1;
    long size = fileSize(out.c_str());
    unlink(out.c_str());
    return size;
}

double now() { return (double)std::clock() / CLOCKS_PER_SEC; }

} // namespace

int main(int argc, char **argv) {
    double effort = 0;
    std::string film = "build/odraz-safe";
    for (int i = 1; i < argc; ++i) {
        if (!std::strcmp(argv[i], "--effort") && i + 1 < argc)
            effort = std::atof(argv[++i]);
        else if (argv[i][0] != '-')
            film = argv[i];
        else {
            std::fprintf(stderr, "usage: bench_pack [--effort SECONDS] [FILM]\n");
            return 2;
        }
    }
    char folder[] = "/tmp/bench_pack.XXXXXX";
    if (!mkdtemp(folder)) {
        std::perror("bench_pack: /tmp");
        return 1;
    }
    for (Peer &peer : thePeers) {
        peer.there = !std::system(("command -v " + std::string(peer.program) + " >/dev/null").c_str());
        if (!peer.there) std::printf("(%s is not installed: skipped)\n", peer.program);
    }
    std::vector<std::string> missing;
    std::vector<Sample> samples;
    try {
        samples = corpus(film, missing);
    } catch (const Unsuitable &e) {
        std::fprintf(stderr, "bench_pack: %s: %s\n", film.c_str(), e.what());
        return 2;
    }
    for (auto &name : missing) std::printf("(%s is not there: skipped)\n", name.c_str());

    std::printf("| code | bytes |");
    for (Peer &p : thePeers)
        if (p.there) std::printf(" %s |", p.name);
    std::printf(" odraz's pack | to xz | to zpaq | encode s | decode KB/s |\n|---|---|");
    for (Peer &p : thePeers)
        if (p.there) std::printf("---|");
    std::printf("---|---|---|---|---|\n");
    Workspace workspace;
    for (const Sample &s : samples) {
        std::string path = std::string(folder) + "/sample";
        if (!writeFile(path, s.bytes.data(), s.bytes.size(), false)) {
            std::perror("bench_pack: /tmp");
            return 1;
        }
        std::printf("| %s | %zu |", s.name.c_str(), s.bytes.size());
        long sizes[4] = {-1, -1, -1, -1};
        for (int i = 0; i < 4; ++i)
            if (thePeers[i].there) std::printf(" %ld |", sizes[i] = packedSize(thePeers[i], path));
        unlink(path.c_str());

        const Layout &layout = s.layout;
        Shape shape = defaultShape();
        if (effort > 0)
            shape =
                search(filter(s.bytes, layout), layout, shape, effort, [](const Progress &) { return true; });
        double began = now();
        Encoded e = encode(s.bytes, layout, shape, workspace);
        double encoding = now() - began;
        // By the stub's own code, in a program
        Program program = {};
        program.base = 0x400000;
        program.span = (uint32_t)wholePages(s.bytes.size());
        program.bytes = s.bytes;
        program.codeBegin = layout.codeBegin;
        program.codeSize = layout.codeSize;
        program.early = kNothingEarly;
        program.slots[1] = 8;
        std::vector<uint8_t> packed = writePacked(program, shape, e.payload);
        began = now();
        bool whole = decodeWithStub(packed) == s.bytes;
        double decoding = now() - began;
        if (!whole) {
            std::fprintf(stderr, "bench_pack: %s came back damaged\n", s.name.c_str());
            return 1;
        }
        double size = (double)e.payload.size();
        std::printf(" %.0f | %.3f | %.3f | %.2f | %.0f |\n", size, sizes[0] > 0 ? size / (double)sizes[0] : 0,
                    sizes[3] > 0 ? size / (double)sizes[3] : 0, encoding,
                    (double)s.bytes.size() / 1024 / decoding);
        std::fflush(stdout);
    }
    rmdir(folder);
}
