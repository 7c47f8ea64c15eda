// pack-link: links a program for the packer, in the ways that are possible, and keeps the smallest.
#include "packer/link/ways.h"
#include "tools/common/temporary_folder.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sys/wait.h>
#include <unistd.h>

namespace pack::linking {

namespace {

std::string theFolder; // of all files that are made on the way

// Nothing is left over. It calls what a handler of signals may call.
void endBySignal(int) {
    endRunning();
    if (pid_t remover = _Fork())
        waitpid(remover, nullptr, 0);
    else
        execl("/bin/rm", "rm", "-rf", theFolder.c_str(), nullptr);
    constexpr char kLine[] = "pack-link: ended by a signal\n";
    [[maybe_unused]] ssize_t written = write(2, kLine, sizeof kLine - 1);
    _exit(1);
}

int packLink(common::CommandLine &line) {
    setenv("LC_ALL", "C", 1); // the linker's messages are read
    try {
        DividedWords words = divide(line.words());
        common::CommandLine own("pack-link", words.own);
        LinkOptions options = parseLinkOptions(own, words.compiler);
        common::TemporaryFolder folder;
        theFolder = folder / "";
        theFolder.pop_back();
        for (int signal : {SIGINT, SIGTERM, SIGHUP})
            if (std::signal(signal, endBySignal) == SIG_IGN)
                std::signal(signal, SIG_IGN); // as nohup leaves it
        packSmallest(options, theFolder);
        return 0;
    } catch (const std::filesystem::filesystem_error &e) {
        throw common::Refused("cannot write " + e.path2().string() + e.path1().string() + ": " +
                              e.code().message());
    }
}

} // namespace

} // namespace pack::linking

int main(int argc, char **argv) {
    return common::runProgram("pack-link", argc, argv, pack::linking::packLink);
}
