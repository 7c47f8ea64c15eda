#include "maker/follower.h"

#include "maker/panel/canvas.h"

#include <cstdio>

namespace odraz::maker {

Follower::Follower(const std::string &build, Stage &shown, Report to)
    : rebuilder(build), stage(shown), report(std::move(to)) {
    if (!rebuilder.problem().empty()) report("", rebuilder.problem());
}

bool Follower::follow(Screen &screen, int block) {
    Rebuilder::Event event = rebuilder.poll(glfwGetTime());
    bool built = event == Rebuilder::Event::Built;
    if (event == Rebuilder::Event::Building) report("building", "");
    failed = event == Rebuilder::Event::Failed || (failed && !built);
    if (event == Rebuilder::Event::Failed) report("does not compile", rebuilder.error());
    if (built) {
        stage.change(screen.gl, rebuilder.solverHash(), block, [&](bool on) { screen.useHidden(on); });
        if (!stage.state().empty()) report("loading", stage.state());
    }
    bool fresh = stage.poll(block) || (built && stage.state().empty());
    if (fresh) {
        char line[80];
        std::snprintf(line, sizeof line, "shown %.1f s after it was saved",
                      glfwGetTime() - rebuilder.saved());
        report(line, line);
    }
    return fresh;
}

void Follower::drawState(const Picture &p, const char *limit, const std::string &recent) const {
    std::string line = failed ? rebuilder.error() : stage.state();
    if (line.empty() && limit) line = limit;
    if (line.empty()) line = recent;
    if (!line.empty()) drawStatus(p, line, stage.loaded());
}

void Follower::wait() const {
    if (rebuilder.building()) glfwWaitEventsTimeout(0.2);
}

} // namespace odraz::maker
