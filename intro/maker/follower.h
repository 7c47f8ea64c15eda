// Follows the sources: what was saved is built, and what was built is shown.
#pragma once

#include "maker/rebuilder.h"
#include "maker/screen.h"
#include "maker/stage.h"

#include <functional>

namespace odraz {

class Follower {
public:
    // `build`: the folder of the build. What goes on is told to `say`, in a word for the title and in a line.
    using Say = std::function<void(const std::string &word, const std::string &line)>;
    Follower(const std::string &build, Stage &stage, Say say);

    // Once a picture, before it is made; `block` is where the music is. True: there is a new film.
    bool follow(Screen &screen, int block);
    // What there is to tell, over the picture. `limit`: a constant that is too small, or null; `recent`: what
    // is told if there is nothing else.
    void write(const Picture &p, const char *limit, const std::string &recent) const;
    // The compiler needs the processors: until it is done, few pictures are made.
    void wait() const;

    std::string showFolder() const { return rebuilder.showFolder(); }
    uint64_t solverHash() const { return rebuilder.solverHash(); }

private:
    Rebuilder rebuilder;
    Stage &stage;
    Say say;
    bool failed = false;
};

} // namespace odraz
