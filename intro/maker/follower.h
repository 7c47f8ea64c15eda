// Rebuilds the film when a source is saved, and shows it when it is built.
#pragma once

#include "maker/rebuilder.h"
#include "maker/screen.h"
#include "maker/stage.h"

#include <functional>

namespace odraz::maker {

class Follower {
public:
    // Receives news: a word for the window's title, and a line for stderr that may be empty.
    using Report = std::function<void(const std::string &word, const std::string &line)>;
    // `build`: the build folder.
    Follower(const std::string &build, Stage &stage, Report report);

    // To be called before each picture. `block`: the music's position. Returns true if the film is a new one.
    bool follow(Screen &screen, int block);
    // Draws one line over a picture, the first that exists: an error or progress, `limit` (names a constant
    // that is too small, or is null), `recent`.
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
