#include "maker/rebuilder.h"

#include "tools/common/hash.h"
#include "tools/common/whole_file.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

extern char **environ;

namespace odraz::maker {

namespace {

constexpr double kLook = 0.05; // seconds: how often the times of all sources are compared
constexpr const char *kSolvers[] = {"/radiosity/", "/transfer/"};

bool isSource(const std::string &name) {
    for (const char *end : {".cpp", ".h", ".keys", "CMakeLists.txt"})
        if (name.size() >= std::strlen(end) &&
            !name.compare(name.size() - std::strlen(end), std::string::npos, end))
            return true;
    return false;
}

} // namespace

Rebuilder::Rebuilder(const std::string &folder) : build(folder) {
    std::ifstream cache(build + "/CMakeCache.txt");
    auto take = [](const std::string &line, const std::string &key, std::string &to) {
        if (!line.compare(0, key.size(), key)) to = line.substr(key.size());
    };
    for (std::string line; std::getline(cache, line);) {
        take(line, "CMAKE_HOME_DIRECTORY:INTERNAL=", source);
        take(line, "CMAKE_MAKE_PROGRAM:FILEPATH=", maker);
    }
    if (source.empty() || maker.empty()) {
        wrong = build + " is no folder of a build: sources are not watched";
        return;
    }
    times = timesNow();
}

Rebuilder::~Rebuilder() {
    stop();
    if (compiling > 0) waitpid(compiling, nullptr, 0);
}

Rebuilder::Times Rebuilder::timesNow() const {
    Times now;
    std::error_code ignored;
    for (auto &entry : std::filesystem::recursive_directory_iterator(source + "/intro", ignored))
        if (isSource(entry.path().filename())) now[entry.path()] = entry.last_write_time(ignored);
    return now;
}

void Rebuilder::start() {
    std::filesystem::create_directories(build + "/live");
    std::string log = build + "/live/build.log";
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    // A process group, which is ended as one
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    // In English, with quotes that our font has. Not by cmake, which would end before its children
    const char *words[] = {"env", "LC_ALL=C", maker.c_str(), "-C", build.c_str(), "live", nullptr};
    // The times of files are up to 15 ms late: what was saved before is older than this
    began = std::filesystem::file_time_type::clock::now() - std::chrono::milliseconds(15);
    int error = posix_spawnp(&compiling, words[0], &actions, &attributes, (char *const *)words, environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (error) {
        compiling = -1;
        firstError = std::string("cannot start " + maker + ": ") + std::strerror(error);
    }
}

// Ends the build with all its processes.
void Rebuilder::stop() {
    if (compiling > 0) kill(-compiling, SIGTERM);
}

// Objects get the time at which their build began, so that a source saved during the build is newer. (Ninja
// before 1.12 does not see to that.)
void Rebuilder::backdate() {
    std::error_code ignored;
    for (const std::string &file : objects())
        if (std::filesystem::last_write_time(file, ignored) > began)
            std::filesystem::last_write_time(file, began, ignored);
}

void Rebuilder::readError() {
    std::ifstream log(build + "/live/build.log");
    std::string last;
    firstError.clear();
    for (std::string line; std::getline(log, line);) {
        if (!line.empty()) last = line;
        bool error = line.find("error:") != line.npos || line.find("undefined reference") != line.npos ||
                     line.find("CMake Error") != line.npos;
        if (error && firstError.empty()) firstError = line;
    }
    if (firstError.empty()) firstError = last.empty() ? "the build failed" : last;
    for (size_t at; (at = firstError.find(source + "/")) != firstError.npos;)
        firstError.erase(at, source.size() + 1);
}

Rebuilder::Event Rebuilder::poll(double now) {
    bool settled = false; // editors write in several steps
    auto look = [&] {
        lookedAt = now;
        Times before = std::exchange(times, timesNow());
        settled = times == before;
        if (!settled) changedAt = now;
        dirty |= !settled;
    };
    if (problem().empty() && now >= lookedAt + kLook) look();
    if (compiling > 0) {
        if (dirty && !stopped) stop(); // it builds old sources
        stopped = dirty;
        int status;
        pid_t ended = waitpid(compiling, &status, WNOHANG);
        if (ended == 0) return Event::None;
        compiling = -1;
        backdate();
        look(); // at what was saved since the last look
        if (dirty) return Event::None;
        if (ended > 0 && WIFEXITED(status) && !WEXITSTATUS(status)) return Event::Built;
        readError();
        return Event::Failed;
    }
    if (!dirty || !settled) return Event::None;
    dirty = stopped = false;
    savedAt = changedAt;
    start();
    return compiling > 0 ? Event::Building : Event::Failed;
}

// The target's object files: they have a folder of their own.
std::vector<std::string> Rebuilder::objects() const {
    std::vector<std::string> files;
    std::error_code ignored;
    for (auto &entry : std::filesystem::recursive_directory_iterator(build + "/intro/maker", ignored))
        if (entry.path().extension() == ".o") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

uint64_t Rebuilder::solverHash() const {
    uint64_t hash = common::kFnvStart;
    for (const std::string &file : objects())
        if (std::any_of(std::begin(kSolvers), std::end(kSolvers),
                        [&](const char *part) { return file.find(part) != file.npos; }))
            hash = common::fnv1a(common::readWholeFile(file).view(), hash);
    return hash;
}

} // namespace odraz::maker
