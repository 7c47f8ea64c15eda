#include "packer/read/process.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace pack {

static volatile pid_t theRunning;

Outcome run(const Words &command) {
    std::vector<char *> words;
    for (const std::string &word : command) words.push_back(const_cast<char *>(word.c_str()));
    words.push_back(nullptr);
    int ends[2];
    pid_t child = pipe2(ends, O_CLOEXEC) ? -1 : fork();
    if (child < 0) throw std::runtime_error("cannot run " + command[0] + ": " + std::strerror(errno));
    if (!child) {
        for (int to : {1, 2}) dup2(ends[1], to);
        execvp(words[0], words.data());
        _exit(127);
    }
    theRunning = child;
    close(ends[1]);
    std::string output;
    char buffer[1 << 16];
    for (ssize_t size; (size = read(ends[0], buffer, sizeof buffer)) > 0;)
        output.append(buffer, (size_t)size);
    close(ends[0]);
    int status;
    waitpid(child, &status, 0);
    theRunning = 0;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), output};
}

void endRunning() {
    if (!theRunning) return;
    kill(theRunning, SIGTERM);
    waitpid(theRunning, nullptr, 0);
}

} // namespace pack
