#include "tools/measure/seen/simulated.h"

#include "tools/common/text.h"
#include "tools/measure/detect/screening.h"
#include "tools/measure/seen/simulated_player.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace odraz::measure {

namespace {

constexpr double kScreenRate = 60;

// The cost of making a picture, and of scaling it up, from the traced pictures `from`.
PictureCost costWith(const CostOf &costOf, const SimulatedMachine &machine, const ShownPicture &s,
                     const MadeFrom &from) {
    PictureCost cost = costOf({s.time, s.level, (double)s.width * s.height, from.gap()});
    if (s.width < machine.width) cost.parallel += machine.enlarging * machine.width * machine.height;
    return cost;
}
double presenting(const SimulatedMachine &machine) {
    return machine.presenting * machine.width * machine.height;
}

class Simulation : public SimulatedPlayer {
public:
    Simulation(const CostOf &costOf, const SimulatedMachine &machine, double from, double to)
        : SimulatedPlayer(from), costOf(costOf), machine(machine), to(to) {}

    std::vector<ShownPicture> play() {
        Governor governor;
        governor.width = machine.width, governor.height = machine.height;
        makePictures(*this, governor, from);
        if (begin < 0) begin = moment; // fewer pictures than the player makes before it starts
        showUntil(begin + nanosecondsOf(to - from));
        return list;
    }

    bool goesOn(double time) const { return time < to; }
    int sceneOf(double time) const { return sceneAt(time); }
    double startOf(double time) const { return shotStart(time); }
    Pace paceOf(int scene) const { return machine.paceOf(scene); }
    void trace(FinishedPicture &m, int, const Governor &governor) {
        before = traced;
        TracedSize size = governor.size();
        traced = {-1, m.time, false, governor.level(), size.width, size.height};
        make(traced, {traced, traced});
    }
    void between(FinishedPicture &m, int, int, double, int) {
        ShownPicture s = traced;
        s.time = m.time;
        make(s, {before, traced});
    }
    unsigned add(const FinishedPicture &m) {
        list.push_back(traced);
        list.back().time = m.time;
        list.back().between = m.time != traced.time;
        return SimulatedPlayer::add(m);
    }

private:
    double core() const { return machine.rate / machine.cores; }

    // Advances the clock by the time of a picture. Pictures shown meanwhile take their share of all cores.
    void make(const ShownPicture &s, const MadeFrom &madeFrom) {
        PictureCost cost = costWith(costOf, machine, s, madeFrom);
        int64_t end = moment + nanosecondsOf(cost.serial / core() + cost.parallel / machine.rate);
        for (int shownBefore = -1; shownBefore != presented;) {
            shownBefore = presented;
            showUntil(end);
            end += nanosecondsOf((presented - shownBefore) * presenting(machine) / machine.rate);
        }
        moment = end;
    }
    void show(unsigned number) override {
        looked += nanosecondsOf(presenting(machine) / core());
        double sixtieths = std::ceil((filmAt(looked) - from) * kScreenRate - 0.5);
        list[number].at = from + (sixtieths + 0.5) / kScreenRate;
        if (presented++ && list[last].at == list[number].at) list[last].at = -1; // replaced at once
        last = number;
    }

    const CostOf &costOf;
    SimulatedMachine machine;
    double to;                             // seconds of the film
    std::vector<ShownPicture> list;        // indexed by the queue's numbers
    ShownPicture before = {}, traced = {}; // the last two traced pictures
    unsigned last = 0;                     // number of the picture that was shown last
    int presented = 0;                     // pictures shown so far
};

class PageSimulation {
public:
    PageSimulation(const CostOf &costOf, const SimulatedMachine &machine, double to)
        : costOf(costOf), machine(machine), to(to) {}

    std::vector<ShownPicture> play(double from) {
        Queue queue = {};
        PagePlayer<PageSimulation> player = {this, &queue, machine.workers};
        player.begin(from, machine.width, machine.height);
        playPage(player, from, 1 / kScreenRate, player.kNearest);
        std::vector<ShownPicture> list;
        for (auto &[time, shown] : made) list.push_back(shown);
        return list;
    }

    bool goesOn(double time) const { return time < to; }
    int sceneOf(double time) const { return sceneAt(time); }
    double startOf(double time) const { return shotStart(time); }
    Pace paceOf(int scene) const { return pageOf(machine.paceOf(scene)); }
    Traceable traceable(double) const { return Traceable::Now; }
    int64_t tracing(const FinishedPicture &m) {
        ShownPicture &s = made[m.time] = {-1, m.time, false, m.level, m.size.width, m.size.height};
        PictureCost cost = costWith(costOf, machine, s, {s, s});
        return nanosecondsOf((cost.serial + cost.parallel) * machine.cores / machine.rate);
    }
    int64_t show(const FinishedPicture &m, double at) {
        made[m.time].at = at;
        return nanosecondsOf(presenting(machine) / machine.rate);
    }

private:
    const CostOf &costOf;
    SimulatedMachine machine;
    double to;                           // seconds of the film
    std::map<double, ShownPicture> made; // by time
};

} // namespace

std::vector<ShownPicture> simulate(const CostOf &costOf, const SimulatedMachine &machine, double from,
                                   double to) {
    if (machine.workers) return PageSimulation(costOf, machine, to).play(from);
    return Simulation(costOf, machine, from, to).play();
}

std::vector<PlayedScene> summary(const std::vector<ShownPicture> &list, const CostOf &costOf,
                                 const SimulatedMachine &machine) {
    std::vector<PlayedScene> scenes;
    if (list.empty()) return scenes;
    double from = list.front().time, to = list.back().time + 1 / kScreenRate;
    for (const Span &shot : shots()) {
        double begin = std::max(from, shot.from), end = std::min(to, shot.to);
        if (begin >= end) continue;
        if (scenes.empty() || scenes.back().scene != shot.scene)
            scenes.push_back({shot.scene, 0, 0, 0, 0, 0, 0, 0});
        scenes.back().seconds += end - begin;
    }
    for (PlayedScene &scene : scenes) {
        for (size_t i = 0; i < list.size(); ++i) {
            const ShownPicture &s = list[i];
            if (sceneAt(s.time) != scene.scene) continue;
            ++(s.between ? scene.between : scene.traced);
            scene.shown += s.at >= 0;
            scene.level += s.between ? 0 : (double)s.level;
            scene.width += s.between ? 0 : s.width;
            PictureCost cost = costWith(costOf, machine, s, madeFrom(list, i));
            scene.rate += cost.serial + cost.parallel + (s.at >= 0) * presenting(machine);
        }
        scene.rate /= scene.seconds;
        scene.level /= std::max(1, scene.traced);
        scene.width /= std::max(1, scene.traced);
    }
    return scenes;
}

std::string printSummary(const std::vector<PlayedScene> &scenes, const std::string &before) {
    std::string text;
    for (const PlayedScene &s : scenes)
        common::append(text, "%s%s,%.2f,%d,%d,%d,%.1f,%.2f,%.0f,%.2f\n", before.c_str(), sceneName(s.scene),
                       s.seconds, s.traced, s.between, s.shown, s.shown / s.seconds, s.level, s.width,
                       s.rate / 1e9);
    return text;
}

} // namespace odraz::measure
