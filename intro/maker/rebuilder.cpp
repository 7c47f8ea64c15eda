#include "maker/rebuilder.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <signal.h>
#include <spawn.h>
#include <sys/inotify.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

namespace odraz {

namespace {

constexpr double kSettled = 0.03; // seconds without a change: editors write in several steps
// What makes the hall's light, beside the numbers that scenes give it
constexpr const char *kHallObjects[] = {"radiosity", "transfer", "show/hall.cpp.o", "show/hall_model.cpp.o"};

bool isSource(const std::string &name) {
    for (const char *end : {".cpp", ".h", "CMakeLists.txt"})
        if (name.size() >= std::strlen(end) &&
            !name.compare(name.size() - std::strlen(end), std::string::npos, end))
            return true;
    return false;
}

uint64_t hashOf(const std::filesystem::path &file, uint64_t hash) {
    std::ifstream in(file, std::ios::binary);
    for (char block[65536]; in.read(block, sizeof block), in.gcount() > 0;)
        for (std::streamsize i = 0; i < in.gcount(); ++i) hash = (hash ^ (uint8_t)block[i]) * 0x100000001b3;
    return hash;
}

} // namespace

Rebuilder::Rebuilder(const std::string &folder) : build(folder) {
    std::ifstream cache(build + "/CMakeCache.txt");
    constexpr char kKey[] = "CMAKE_HOME_DIRECTORY:INTERNAL=";
    for (std::string line; std::getline(cache, line);)
        if (!line.compare(0, sizeof kKey - 1, kKey)) source = line.substr(sizeof kKey - 1);
    if (source.empty()) {
        wrong = build + " is no folder of a build: sources are not watched";
        return;
    }
    notify = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    if (notify < 0) {
        wrong = std::string("sources are not watched: ") + std::strerror(errno);
        return;
    }
    watch(source + "/intro");
}

Rebuilder::~Rebuilder() {
    if (compiling > 0) {
        kill(compiling, SIGTERM);
        waitpid(compiling, nullptr, 0);
    }
    if (notify >= 0) close(notify);
}

// The folder and all in it.
void Rebuilder::watch(const std::string &folder) {
    int number =
        inotify_add_watch(notify, folder.c_str(), IN_CLOSE_WRITE | IN_MOVED_TO | IN_CREATE | IN_ONLYDIR);
    if (number < 0) {
        wrong = "cannot watch " + folder + ": " + std::strerror(errno);
        return;
    }
    if (watched.size() <= (size_t)number) watched.resize((size_t)number + 1);
    watched[(size_t)number] = folder;
    std::error_code ignored;
    for (auto &entry : std::filesystem::directory_iterator(folder, ignored))
        if (entry.is_directory(ignored)) watch(entry.path());
}

bool Rebuilder::sawChange() {
    bool saw = false;
    alignas(inotify_event) char events[4096];
    for (ssize_t size; notify >= 0 && (size = read(notify, events, sizeof events)) > 0;)
        for (char *at = events; at < events + size;) {
            auto *event = (inotify_event *)at;
            at += sizeof *event + event->len;
            if (!event->len) continue;
            if (event->mask & IN_ISDIR && (size_t)event->wd < watched.size())
                watch(watched[(size_t)event->wd] + "/" + event->name);
            else if (!(event->mask & IN_CREATE) && isSource(event->name))
                saw = true;
        }
    return saw;
}

void Rebuilder::start() {
    std::filesystem::create_directories(build + "/live");
    std::string log = build + "/live/build.log";
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    const char *words[] = {"env",         "LC_ALL=C", "cmake", "--build",
                           build.c_str(), "--target", "live",  nullptr}; // with quotes that our font has
    int error = posix_spawnp(&compiling, words[0], &actions, nullptr, (char *const *)words, environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error) {
        compiling = -1;
        firstError = std::string("cannot start cmake: ") + std::strerror(error);
    }
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

Rebuilder::News Rebuilder::poll(double now) {
    if (sawChange()) {
        dirty = true;
        changedAt = now;
    }
    if (compiling > 0) {
        int status;
        pid_t ended = waitpid(compiling, &status, WNOHANG);
        if (ended == 0) return News::None;
        compiling = -1;
        if (dirty) return News::None; // what was built is not what there is now
        if (ended > 0 && WIFEXITED(status) && !WEXITSTATUS(status)) return News::Built;
        readError();
        return News::Failed;
    }
    if (!dirty || now < changedAt + kSettled) return News::None;
    dirty = false;
    savedAt = changedAt;
    start();
    return compiling > 0 ? News::Building : News::Failed;
}

uint64_t Rebuilder::hallHash() const {
    uint64_t hash = 0xcbf29ce484222325;
    std::vector<std::filesystem::path> files;
    std::error_code ignored;
    // The generator keeps objects in a folder of the target, under the paths of their sources
    for (auto &entry : std::filesystem::recursive_directory_iterator(build + "/intro/maker", ignored)) {
        std::string path = entry.path();
        bool ofHall = std::any_of(std::begin(kHallObjects), std::end(kHallObjects), [&](const char *part) {
            return path.find(std::string("/") + part) != path.npos;
        });
        if (ofHall && entry.path().extension() == ".o") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (auto &file : files) hash = hashOf(file, hash);
    return hash;
}

} // namespace odraz
