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
#include <regex>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace odraz::maker {

static constexpr double kInterval = 0.05; // seconds between two comparisons of all sources' times
static constexpr const char *kSolvers[] = {"/radiosity/", "/transfer/"};

static bool isSource(const std::string &name) {
    return name.ends_with(".cpp") || name.ends_with(".h") || name.ends_with(".keys") ||
           name.ends_with("CMakeLists.txt");
}

Rebuilder::Rebuilder(const std::string &folder) : build(folder) {
    std::ifstream cache(build + "/CMakeCache.txt");
    auto readEntry = [](const std::string &line, const std::string &key, std::string &to) {
        if (line.starts_with(key)) to = line.substr(key.size());
    };
    for (std::string line; std::getline(cache, line);) {
        readEntry(line, "CMAKE_HOME_DIRECTORY:INTERNAL=", source);
        readEntry(line, "CMAKE_MAKE_PROGRAM:FILEPATH=", buildTool);
    }
    if (source.empty() || buildTool.empty()) {
        wrong = build + " is not a build folder: sources are not watched";
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
    // File times lag behind the clock by up to 15 ms: a file saved from now on is not older than this
    began = std::filesystem::file_time_type::clock::now() - std::chrono::milliseconds(15);
    compiling = fork();
    if (compiling < 0) firstError = "cannot start " + buildTool + ": " + std::strerror(errno);
    setpgid(compiling, 0); // in both processes; stop() ends the whole group
    if (compiling != 0) return;
    int to = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(to, 1);
    dup2(to, 2);
    // Ask for English messages, whose quotes the font has. `cmake --build` would end before its children
    execlp("env", "env", "LC_ALL=C", buildTool.c_str(), "-C", build.c_str(), "live", nullptr);
    _exit(127);
}

// Ends all processes of the build.
void Rebuilder::stop() {
    if (compiling > 0) kill(-compiling, SIGTERM);
}

// Sets the objects' times to the start of their build, so that a source saved during the build is newer.
// (Ninja before 1.12 does not do that.)
void Rebuilder::backdate() {
    std::error_code ignored;
    for (const std::string &file : objects())
        if (std::filesystem::last_write_time(file, ignored) > began)
            std::filesystem::last_write_time(file, began, ignored);
}

void Rebuilder::readError() {
    static const std::regex error("error:|sorry, unimplemented:|undefined reference|CMake Error");
    std::ifstream log(build + "/live/build.log");
    std::string last;
    firstError.clear();
    for (std::string line; firstError.empty() && std::getline(log, line);) {
        if (!line.empty()) last = line;
        if (std::regex_search(line, error)) firstError = line;
    }
    if (firstError.empty()) firstError = last.empty() ? "the build failed" : last;
    for (size_t at; (at = firstError.find(source + "/")) != firstError.npos;)
        firstError.erase(at, source.size() + 1);
}

Rebuilder::Event Rebuilder::poll(double now) {
    bool settled = false; // no source has changed since the last look: editors write in several steps
    auto look = [&] {
        lookedAt = now;
        Times before = std::exchange(times, timesNow());
        settled = times == before;
        if (!settled) changedAt = now;
        dirty |= !settled;
    };
    if (problem().empty() && now >= lookedAt + kInterval) look();
    if (compiling > 0) {
        if (dirty && !stopped) stop(); // it uses old sources
        stopped = dirty;
        int status;
        pid_t ended = waitpid(compiling, &status, WNOHANG);
        if (ended == 0) return Event::None;
        compiling = -1;
        backdate();
        look(); // a source may have been saved since the last look
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

// Returns the object files below intro/maker. The target `live` has its copies of the engine's there, too.
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
            hash = common::fnv1a(common::readWhole(file), hash);
    return hash;
}

} // namespace odraz::maker
