// Watches the film's sources, and rebuilds the shared object when one is saved.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <sys/types.h>
#include <vector>

namespace odraz::maker {

class Rebuilder {
public:
    // `build`: the build folder. If its CMake cache names no source folder, problem() has the reason.
    explicit Rebuilder(const std::string &build);
    ~Rebuilder();
    Rebuilder(const Rebuilder &) = delete;

    enum class Event {
        None,
        Building, // a build has begun
        Failed,   // error() has the reason
        Built,    // object() can be loaded
    };
    // Never waits. Returns what happened since the last call. `now`: seconds of any clock.
    Event poll(double now);

    bool building() const { return compiling > 0; }

    const std::string &problem() const { return wrong; }
    // The compiler's first error, or another problem, as one line. Paths are relative to the source folder.
    const std::string &error() const { return firstError; }
    std::string showFolder() const { return source.empty() ? "" : source + "/intro/show"; }
    std::string object() const { return build + "/live/live.so"; }
    // A hash of the code that solves the hall. When it changes, the hall must be solved again.
    uint64_t solverHash() const;
    // Returns the time, as in poll(), at which the change that led to the last build was noticed.
    double saved() const { return savedAt; }

private:
    using Times = std::map<std::filesystem::path, std::filesystem::file_time_type>;
    Times timesNow() const;
    void start();
    void stop();
    void backdate();
    void readError();
    std::vector<std::string> objects() const;

    std::string build, source, buildTool, wrong, firstError;
    Times times; // by source file
    pid_t compiling = -1;
    std::filesystem::file_time_type began = {};
    bool dirty = false;   // a source was saved since the build began
    bool stopped = false; // the build is being stopped
    double lookedAt = 0, changedAt = 0, savedAt = 0;
};

} // namespace odraz::maker
