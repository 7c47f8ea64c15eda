#include "packer/link/process.h"

#include "tools/common/command_line.h"

#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>
#include <spawn.h>
#include <sys/wait.h>

extern char **environ;

namespace pack::linking {

namespace {

sigset_t setOf(std::initializer_list<int> signals) {
    sigset_t set;
    sigemptyset(&set);
    for (int signal : signals) sigaddset(&set, signal);
    return set;
}
const sigset_t kSignals = setOf({SIGINT, SIGTERM, SIGHUP, SIGCHLD});

// Starts the command with no signal blocked, and with both outputs in `output` if there is one.
pid_t start(const Words &command, std::FILE *output) {
    std::vector<char *> words;
    for (const std::string &word : command) words.push_back(const_cast<char *>(word.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (int to : {1, 2})
        if (output) posix_spawn_file_actions_adddup2(&actions, fileno(output), to);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none = setOf({});
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    pid_t child;
    int wrong = posix_spawnp(&child, words[0], &actions, &attributes, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (wrong)
        throw common::Refused("cannot run " + command[0] + " (" + std::strerror(wrong) +
                              "): install gcc or clang, or name a compiler with --cc");
    return child;
}

std::string readAll(std::FILE *file) {
    std::string all;
    char buffer[4096];
    std::rewind(file);
    while (size_t n = std::fread(buffer, 1, sizeof buffer, file)) all.append(buffer, n);
    return all;
}

} // namespace

Outcome run(const Words &command, Output output, bool verbose) {
    std::string line;
    for (const std::string &word : command) line += (line.empty() ? "" : " ") + word;
    if (verbose) std::fprintf(stderr, "%s\n", line.c_str());
    std::fflush(stdout);
    bool kept = output == Output::kKept;
    std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(kept ? std::tmpfile() : nullptr, std::fclose);
    if (kept && !file) throw std::runtime_error(std::string("no temporary file: ") + std::strerror(errno));
    pid_t child = start(command, file.get());
    int status;
    bool ended = false;
    while (waitpid(child, &status, WNOHANG) != child) {
        int signal = sigwaitinfo(&kSignals, nullptr);
        if (signal < 0 || signal == SIGCHLD || (signal == SIGINT && !kept)) continue;
        ended = true;
        kill(child, SIGTERM);
    }
    if (ended) throw std::runtime_error("ended by a signal");
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            kept ? readAll(file.get()) : ""};
}

void blockSignals() { sigprocmask(SIG_BLOCK, &kSignals, nullptr); }

} // namespace pack::linking
