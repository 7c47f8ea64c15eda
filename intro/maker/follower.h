// Follows the sources: what was saved is built, and what was built is shown.
#pragma once

#include "maker/rebuilder.h"
#include "maker/screen.h"
#include "maker/stage.h"

#include <functional>

namespace odraz::maker {

class Follower {
public:
    // Called with what goes on: a word for the title, and a line for stderr that may be empty.
    using Report = std::function<void(const std::string &word, const std::string &line)>;
    // `build`: the folder of the build.
    Follower(const std::string &build, Stage &stage, Report report);

    // Once a picture, before it is made; `block` is where the music is. True: there is a new film.
    bool follow(Screen &screen, int block);
    // Draws the state over a picture: an error, progress, or else `limit`, a constant that is too small, or
    // null, or else `recent`.
    void drawState(const Picture &p, const char *limit, const std::string &recent) const;
    // The compiler needs the processors: until it is done, few pictures are made.
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
