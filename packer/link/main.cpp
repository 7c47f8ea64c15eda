// pack-link: links a program for the packer, in the ways that are possible, and keeps the smallest.
#include "packer/link/options.h"
#include "packer/link/tries.h"

#include "packer/read/program.h"
#include "tools/common/arguments.h"
#include "tools/common/temporary_folder.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace {

namespace linking = pack::linking;

std::string findPacker() {
    std::string beside = linking::ownFolder() + "/pack";
    if (std::filesystem::exists(beside)) return beside;
    throw common::Refused("there is no " + beside + ": pack must lie beside pack-link");
}

int packLink(common::Arguments &arguments) {
    setenv("LC_ALL", "C", 1); // what the linker says is read
    try {
        linking::Options options = linking::parseOptions(arguments);
        linking::catchSignals();
        common::TemporaryFolder folder;
        std::string path = folder / "";
        path.pop_back();
        linking::Tries tries(options, path, findPacker());
        tries.run();
        std::fputs(tries.print().c_str(), stdout);
        return tries.finish();
    } catch (const std::filesystem::filesystem_error &e) {
        throw common::Refused("cannot write " + e.path2().string() + e.path1().string() + ": " +
                              e.code().message());
    }
}

} // namespace

int main(int argc, char **argv) {
    return common::runProgram("pack-link", linking::kUsage, argc, argv, packLink);
}
