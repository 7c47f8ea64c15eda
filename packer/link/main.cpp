// pack-link: links a program for the packer, in the ways that are possible, and keeps the smallest.
#include "packer/link/tries.h"
#include "tools/common/temporary_folder.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace pack::linking {

namespace {

Words theCompilerWords;

std::string findPacker() {
    std::error_code none;
    auto beside = std::filesystem::read_symlink("/proc/self/exe", none).parent_path() / "pack";
    if (std::filesystem::exists(beside)) return beside;
    throw common::Refused("there is no " + beside.string() + ": pack must lie beside pack-link");
}

int packLink(common::CommandLine &line) {
    setenv("LC_ALL", "C", 1); // the linker's messages are read
    try {
        Options options = parseOptions(line, theCompilerWords);
        blockSignals();
        common::TemporaryFolder folder;
        std::string path = folder / "";
        path.pop_back();
        Tries tries(options, path, findPacker());
        tries.run();
        std::fputs(tries.print().c_str(), stdout);
        return tries.finish();
    } catch (const std::filesystem::filesystem_error &e) {
        throw common::Refused("cannot write " + e.path2().string() + e.path1().string() + ": " +
                              e.code().message());
    }
}

} // namespace

} // namespace pack::linking

int main(int argc, char **argv) {
    pack::linking::DividedWords words = pack::linking::divide(argc, argv);
    pack::linking::theCompilerWords = words.compiler;
    std::vector<char *> own = {argv[0]};
    for (std::string &word : words.own) own.push_back(word.data());
    return common::runProgram("pack-link", (int)own.size(), own.data(), pack::linking::packLink);
}
