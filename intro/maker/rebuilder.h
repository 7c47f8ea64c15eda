// Watches the film's sources, and builds the shared object anew whenever one is saved.
#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

namespace odraz {

class Rebuilder {
public:
    // `build`: the folder of the build, which knows its sources. Where these cannot be watched, problem()
    // says why.
    explicit Rebuilder(const std::string &build);
    ~Rebuilder();
    Rebuilder(const Rebuilder &) = delete;

    enum class News {
        None,
        Building, // a build has begun
        Failed,   // error() says why
        Built,    // it is to be loaded
    };
    // What happened since the last call; does not wait. `now`: seconds of any clock.
    News poll(double now);

    bool building() const { return compiling > 0; }

    const std::string &problem() const { return wrong; }
    // The compiler's first error, or what else was wrong, as one line with paths from the source folder on.
    const std::string &error() const { return firstError; }
    std::string object() const { return build + "/live/live.so"; }
    // A hash of the code that the hall's light is made by. Where it changes, the hall must be solved anew.
    uint64_t hallHash() const;
    double saved() const { return savedAt; } // when the last change came that was built

private:
    void watch(const std::string &folder);
    bool sawChange();
    void start();
    void readError();

    std::string build, source, wrong, firstError;
    int notify = -1;
    std::vector<std::string> watched; // by inotify's numbers
    pid_t compiling = -1;
    bool dirty = false;
    double changedAt = 0, savedAt = 0;
};

} // namespace odraz
