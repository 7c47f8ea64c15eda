#include "tools/measure/play/simulated.h"

#include "tools/common/command_line.h"
#include "tools/common/text.h"
#include "tools/measure/bench/screening.h"
#include "tools/measure/play/simulated_player.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace odraz::measure {

namespace {

constexpr double kScreenRate = 60;

// The cost of making a picture, and of scaling it up, from the traced pictures `from`. The first pictures
// fill both slots and the first buffer.
PictureCost costWith(const CostOf &costOf, const SimulatedMachine &machine, const ShownPicture &s,
                     const MadeFrom &from, size_t madeBefore) {
    double pixels = (double)s.width * s.height, gap = from.gap();
    PictureCost cost = costOf({s.time, s.level, pixels, gap});
    cost.parallel += pixels * ((gap > 0 ? machine.carryingWaits : machine.tracingWaits) +
                               (madeBefore <= kSlots) * machine.touching);
    if (s.width < machine.width) cost.parallel += kEnlarging * machine.width * machine.height;
    return cost;
}
double presenting(const SimulatedMachine &machine) {
    return machine.presenting * machine.width * machine.height;
}

// What was made and shown in a part of a list.
struct Work {
    double made = 0, busy = 0; // instructions and seconds of making pictures
    int shown = 0;
    void add(const std::vector<ShownPicture> &list, size_t i, const CostOf &costOf,
             const SimulatedMachine &machine) {
        PictureCost cost = costWith(costOf, machine, list[i], madeFrom(list, i), i);
        // Other cores wait during the serial part, but not on the page
        made += cost.serial * (machine.workers ? 1 : machine.cores) + cost.parallel;
        busy += list[i].seconds;
        shown += list[i].at >= 0;
    }
    // Instructions a second, within some per cent: about half of the pictures are shown while others are
    // made, the other half while the player waits.
    double rate(const SimulatedMachine &machine, double seconds) const {
        return busy > 0 ? made / busy + shown * presenting(machine) / seconds / 2 : 0;
    }
};

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
        list.back().seconds = (double)(m.trace + m.make);
        return SimulatedPlayer::add(m);
    }

private:
    double core() const { return machine.rate / machine.cores; }

    // Advances the clock by the time of a picture. Pictures shown meanwhile take their share of all cores.
    void make(const ShownPicture &s, const MadeFrom &madeFrom) {
        if (machine.rateAt) machine.rate = machine.rateAt(s.time);
        PictureCost cost = costWith(costOf, machine, s, madeFrom, made++);
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
        if (presented++ && list[last].at == list[number].at)
            list[last].at = -1; // overwritten before it was shown
        last = number;
    }

    const CostOf &costOf;
    SimulatedMachine machine;
    double to;                             // seconds of the film
    std::vector<ShownPicture> list;        // indexed by the queue's numbers
    ShownPicture before = {}, traced = {}; // the last two traced pictures
    size_t made = 0;                       // pictures made so far
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
        PictureCost cost = costWith(costOf, machine, s, {s, s}, made.size() - 1);
        s.seconds = (cost.serial + cost.parallel) / machine.rate; // shared by all workers
        return nanosecondsOf(s.seconds * machine.cores);
    }
    int64_t show(const FinishedPicture &m, double at) {
        made[m.time].at = at;
        made[m.time].seconds = (double)m.trace / machine.workers; // with what was lost to showing
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
                                 const SimulatedMachine &machine, double since) {
    std::vector<PlayedScene> scenes;
    if (list.empty()) return scenes;
    double from = std::max(since, list.front().time), to = list.back().time + 1 / kScreenRate;
    for (const Span &shot : shots()) {
        double begin = std::max(from, shot.from), end = std::min(to, shot.to);
        if (begin >= end) continue;
        auto scene = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const PlayedScene &s) { return s.scene == shot.scene; });
        if (scene == scenes.end()) scene = scenes.insert(scene, {shot.scene, begin, 0, 0, 0, 0, 0, 0, 0});
        scene->seconds += end - begin;
    }
    for (PlayedScene &scene : scenes) {
        Work work;
        for (size_t i = 0; i < list.size(); ++i) {
            const ShownPicture &s = list[i];
            if (s.time < since || sceneAt(s.time) != scene.scene) continue;
            ++(s.between ? scene.between : scene.traced);
            scene.shown += s.at >= 0;
            scene.level += s.between ? 0 : (double)s.level;
            scene.width += s.between ? 0 : s.width;
            work.add(list, i, costOf, machine);
        }
        scene.rate = work.rate(machine, scene.seconds);
        scene.level /= std::max(1, scene.traced);
        scene.width /= std::max(1, scene.traced);
    }
    return scenes;
}

std::function<double(double)> ratesOf(const std::vector<ShownPicture> &list, const CostOf &costOf,
                                      const SimulatedMachine &machine) {
    common::need(!list.empty(), "no picture was shown");
    double from = list.front().time, length = list.back().time + 1 / kScreenRate - from;
    std::vector<Work> works(std::max<size_t>(1, (size_t)length)); // the last one may be longer than a second
    auto second = [from, last = works.size() - 1](double time) {
        return std::min(last, (size_t)std::max(0., time - from));
    };
    for (size_t i = 0; i < list.size(); ++i) works[second(list[i].time)].add(list, i, costOf, machine);
    std::vector<double> rates;
    for (const Work &work : works) {
        rates.push_back(work.rate(machine, &work == &works.back() ? length - (double)(works.size() - 1) : 1));
        common::need(rates.back() > 0, "no picture was made in a whole second: record the list again");
    }
    return [=](double time) { return rates[second(time)]; };
}

std::string printSummary(const std::vector<PlayedScene> &scenes, const std::string &before) {
    std::string text;
    for (const PlayedScene &s : scenes)
        common::append(text, "%s%s,%.2f,%.2f,%d,%d,%d,%.1f,%.2f,%.0f,%.2f\n", before.c_str(),
                       sceneName(s.scene), s.begin, s.seconds, s.traced, s.between, s.shown,
                       s.shown / s.seconds, s.level, s.width, s.rate / 1e9);
    return text;
}

} // namespace odraz::measure
