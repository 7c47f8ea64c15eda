// Measures how a packed film decodes itself, from the start of its process to the entry of the program.
// Runs the film under ptrace with --doctor, which opens no window, and ends it where the decoder frees its
// memory, the last system call before it jumps to the program. Cycles are those of the time-stamp
// counter while the process had a processor.
#include "tools/common/command_line.h"
#include "tools/common/statistics.h"

#include "packer/stub/stub.h"
#include "packer/write/packed_file.h"

#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <x86intrin.h>

namespace {

// Of the processor time-stamp counter.
double cyclesPerSecond() {
    using Clock = std::chrono::steady_clock;
    auto began = Clock::now();
    uint64_t from = __rdtsc();
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    return (double)(__rdtsc() - from) / std::chrono::duration<double>(Clock::now() - began).count();
}

// The number that follows `name` in a file of /proc/PID; the first one if there is no name.
double numberIn(pid_t pid, const char *file, const char *name) {
    std::string path = "/proc/" + std::to_string(pid) + "/" + file;
    std::FILE *in = std::fopen(path.c_str(), "r");
    if (!in) throw std::runtime_error("cannot read " + path + ": " + std::strerror(errno));
    double value = -1;
    char line[256];
    while (value < 0 && std::fgets(line, sizeof line, in))
        if (!std::strncmp(line, name, std::strlen(name))) value = std::atof(line + std::strlen(name));
    std::fclose(in);
    if (value < 0) throw std::runtime_error(path + " has no " + name);
    return value;
}

struct Spent {
    double seconds, kilobytes;
};

// A traced process, which ends with this object.
struct Child {
    pid_t pid;
    bool ended = false;
    // Waits until it stops or ends, and returns the status.
    int wait() {
        int status;
        while (waitpid(pid, &status, 0) < 0)
            if (errno != EINTR) throw std::runtime_error("cannot wait for a process");
        ended = !WIFSTOPPED(status);
        return status;
    }
    ~Child() {
        if (ended) return;
        kill(pid, SIGKILL);
        waitpid(pid, nullptr, 0);
    }
};

Spent decodeOnce(const std::string &film, uint64_t modelMemory) {
    pid_t pid = fork();
    if (pid < 0) throw std::runtime_error("cannot start a process");
    if (pid == 0) {
        int nowhere = open("/dev/null", O_RDWR);
        for (int to : {0, 1, 2}) dup2(nowhere, to);
        ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
        execl(film.c_str(), film.c_str(), "--doctor", (char *)nullptr);
        _exit(127);
    }
    Child child = {pid};
    int status = child.wait(), signal = 0;
    if (child.ended || ptrace(PTRACE_SETOPTIONS, pid, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL))
        throw std::runtime_error("cannot trace " + film);
    for (;;) {
        ptrace(PTRACE_SYSCALL, pid, nullptr, (void *)(long)signal);
        status = child.wait();
        if (child.ended) throw std::runtime_error(film + " ended before it was decoded");
        // A stop that is not at a system call is a signal, which is passed on
        signal = WSTOPSIG(status) == (SIGTRAP | 0x80) ? 0 : WSTOPSIG(status);
        if (signal) continue;
        user_regs_struct r;
        if (ptrace(PTRACE_GETREGS, pid, nullptr, &r)) throw std::runtime_error("cannot trace " + film);
        if (r.orig_rax == SYS_munmap && r.rsi == modelMemory)
            return {numberIn(pid, "schedstat", "") / 1e9, numberIn(pid, "status", "VmHWM:")};
    }
}

int run(common::CommandLine &line) {
    int rounds = 5;
    std::vector<std::string> films;
    line.about("Measures how a packed film decodes itself, from the start of its process to the entry of the "
               "program.");
    line.arguments("FILM", films, "packed films; build/odraz if none is given", false);
    line.option("--rounds", "N", rounds, {1, 1000}, "runs of each film");
    line.parse();
    if (films.empty()) films = {"build/odraz"};
    double cycles = cyclesPerSecond();
    std::string table = "film,bytes decoded,ms until the program is entered,cycles a byte,MB at most\n";
    for (const std::string &film : films) {
        pack::Bytes file = pack::readBytes(film);
        pack::Packed packed;
        try {
            packed = pack::kElf.open(file);
        } catch (const common::Refused &why) {
            throw common::Refused(film + ": " + why.what());
        }
        std::vector<double> seconds, kilobytes;
        for (int i = 0; i < rounds; ++i) {
            Spent s = decodeOnce(film, pack::stubMemory(packed.parameters, packed.layout.size));
            seconds.push_back(s.seconds);
            kilobytes.push_back(s.kilobytes);
        }
        double took = common::median(seconds), size = packed.layout.size;
        char line[256];
        std::snprintf(line, sizeof line, "`%.99s`,%.0f,%.0f,%.0f,%.0f\n",
                      film.substr(film.rfind('/') + 1).c_str(), size, took * 1000, took * cycles / size,
                      std::ceil(common::median(kilobytes) / 1024));
        table += line;
    }
    std::fputs(table.c_str(), stdout);
    return 0;
}

} // namespace

int main(int argc, char **argv) { return common::runProgram("bench_decoding", argc, argv, run); }
