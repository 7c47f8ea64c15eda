// pack: makes a small self-unpacking executable of a program, and unpacks it again.
#include "packer/pack_program.h"
#include "packer/write/packed_file.h"

#include <cstdio>

namespace pack {

namespace {

void openPackedFile(const Options &o, const std::string &path, const Bytes &file) {
    const PackedKind &kind = kindOf(file);
    Program program = readPacked(kind, file);
    if (o.test.empty())
        writeBytes(o.out, kind.writePlain(program), modeOf(path));
    else
        std::printf("%s: whole; %zu bytes of a program of %u in memory\n", path.c_str(), program.bytes.size(),
                    program.span);
}

int runPack(common::CommandLine &line) {
    Options o = parseOptions(line);
    std::string path = o.test + o.unpack;
    if (path.empty()) {
        packProgram(o);
        return 0;
    }
    Bytes file = readBytes(path);
    common::inFile(path, [&] { openPackedFile(o, path, file); });
    return 0;
}

} // namespace

} // namespace pack

int main(int argc, char **argv) { return common::runProgram("pack", argc, argv, pack::runPack); }
