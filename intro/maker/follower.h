// Rebuilds the film when a source is saved, and shows it when it is built.
#pragma once

#include "maker/rebuilder.h"
#include "maker/screen.h"
#include "maker/stage.h"

#include <functional>

namespace odraz::maker {

class Follower {
public:
    // Receives news: a text for the window's title, and a line for stderr that may be empty.
    using Report = std::function<void(const std::string &title, const std::string &line)>;
    // `build`: the build folder.
    Follower(const std::string &build, Stage &stage, Report report);

    // Call this before each picture. `block`: the music's position. Returns true if the film was replaced.
    bool follow(Screen &screen, int block);
    // Draws one line over a picture: an error or the progress; else the name of the constant that is too
    // small, `limit`, unless it is null; else `recent`.
    void drawState(const Picture &p, const char *limit, const std::string &recent) const;
    // During a build, waits for an event or 0.2 s, so that the compiler gets the processors.
    void wait() const;

    std::string showFolder() const { return rebuilder.showFolder(); }
    uint64_t solverHash() const { return rebuilder.solverHash(); }

private:
    Rebuilder rebuilder;
    Stage &stage;
    Report report;
    bool failed = false;
};

} // namespace odraz::maker
