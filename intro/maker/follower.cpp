#include "maker/follower.h"

#include <cstdio>

namespace odraz {

Follower::Follower(const std::string &build, Stage &shown, Say to)
    : rebuilder(build), stage(shown), say(std::move(to)) {
    if (!rebuilder.problem().empty()) say("", rebuilder.problem());
}

bool Follower::follow(Screen &screen, int block) {
    Rebuilder::News what = rebuilder.poll(glfwGetTime());
    bool built = what == Rebuilder::News::Built;
    if (what == Rebuilder::News::Building) say("building", "");
    failed = what == Rebuilder::News::Failed || (failed && !built);
    if (what == Rebuilder::News::Failed) say("does not compile", rebuilder.error());
    if (built) {
        stage.change(screen.gl, rebuilder.solverHash(), block, [&](bool on) { screen.hiddenCurrent(on); });
        if (!stage.told().empty()) say("loading", stage.told());
    }
    bool fresh = stage.poll(block) || (built && stage.told().empty());
    if (fresh) {
        char line[80];
        std::snprintf(line, sizeof line, "new since %.1f s after it was saved",
                      glfwGetTime() - rebuilder.saved());
        say(line, line);
    }
    return fresh;
}

void Follower::write(const Picture &p, const char *limit, const std::string &recent) const {
    std::string line = failed ? rebuilder.error() : stage.told();
    if (line.empty() && limit) line = std::string("this scene outgrew a limit; raise in scene.h: ") + limit;
    if (line.empty()) line = recent;
    if (!line.empty()) liveInUse()->write(p, line.c_str(), stage.loaded());
}

void Follower::wait() const {
    if (rebuilder.building()) glfwWaitEventsTimeout(0.2);
}

} // namespace odraz
