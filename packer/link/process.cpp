#include "packer/link/process.h"

#include "tools/common/arguments.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

namespace pack::linking {

namespace {

volatile std::sig_atomic_t theSignal;
volatile std::sig_atomic_t theChild; // 0: none runs

// Ends the program that runs from here: a signal that comes just before the wait for it would not end the
// wait.
void endAll(int signal) {
    theSignal = signal;
    if (theChild) kill(theChild, SIGTERM);
}

void print(const Words &command) {
    std::string line;
    for (const std::string &word : command) line += (line.empty() ? "" : " ") + word;
    std::fprintf(stderr, "%s\n", line.c_str());
}

// Starts the command, with both outputs in `output` if that is not -1.
pid_t start(const Words &command, int output) {
    if (theSignal) throw std::runtime_error("ended by a signal");
    std::vector<char *> words;
    for (const std::string &word : command) words.push_back(const_cast<char *>(word.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (output >= 0) {
        posix_spawn_file_actions_adddup2(&actions, output, 1);
        posix_spawn_file_actions_adddup2(&actions, output, 2);
    }
    pid_t child;
    int wrong = posix_spawnp(&child, words[0], &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (wrong)
        throw common::Refused("cannot run " + command[0] + " (" + std::strerror(wrong) +
                              "): install gcc or clang, or name a compiler with --cc");
    theChild = child;
    if (theSignal) kill(child, SIGTERM);
    return child;
}

int waitFor(pid_t child) {
    siginfo_t info;
    while (waitid(P_PID, (id_t)child, &info, WEXITED | WNOWAIT) && errno == EINTR) {
    }
    theChild = 0; // before its number is free for another process
    int status;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (theSignal) throw std::runtime_error("ended by a signal");
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string readAll(int from) {
    std::string all;
    char buffer[4096];
    for (;;) {
        ssize_t n = read(from, buffer, sizeof buffer);
        if (n <= 0 && !(n < 0 && errno == EINTR && !theSignal)) return all;
        if (n > 0) all.append(buffer, (size_t)n);
    }
}

} // namespace

Outcome runKept(const Words &command, bool tell) {
    if (tell) print(command);
    int ends[2];
    if (pipe2(ends, O_CLOEXEC)) throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
    pid_t child;
    try {
        child = start(command, ends[1]);
    } catch (...) {
        close(ends[0]);
        close(ends[1]);
        throw;
    }
    close(ends[1]);
    Outcome outcome = {0, readAll(ends[0])};
    close(ends[0]);
    outcome.status = waitFor(child);
    return outcome;
}

Outcome runShown(const Words &command, bool tell) {
    if (tell) print(command);
    std::fflush(stdout);
    void (*before)(int) = std::signal(SIGINT, SIG_IGN); // ignored, it would be ignored by the child, too
    std::signal(SIGINT, [](int) {});
    pid_t child = start(command, -1);
    int status = waitFor(child);
    std::signal(SIGINT, before);
    return {status, ""};
}

void catchSignals() {
    struct sigaction action = {};
    action.sa_handler = endAll; // and no SA_RESTART: reading must end
    for (int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

std::string ownFolder() {
    std::error_code wrong;
    return std::filesystem::read_symlink("/proc/self/exe", wrong).parent_path();
}

} // namespace pack::linking
