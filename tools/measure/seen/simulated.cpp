#include "tools/measure/seen/simulated.h"

#include "play/schedule.h"
#include "tools/common/print.h"
#include "tools/measure/detect/screening.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace odraz {

namespace {

constexpr double kScreenRate = 60;
// The player looks for a picture whose time has come every half a millisecond (play/player.cpp).
constexpr double kNap = 0.0005;

const Shot *shotAt(double seconds) { return momentAt(kFilm, seconds * kRowsPerSecond).shot; }

int64_t nanosecondsOf(double seconds) { return std::llround(seconds * 1e9); }

// The stage of makePictures().
class Simulation {
public:
    Simulation(const CostOf &costOf, const Machine &machine, double from, double to)
        : costOf(costOf), machine(machine), from(from), to(to) {}

    std::vector<Shown> play() {
        Governor governor;
        governor.tradePixels(machine.width, machine.height);
        makePictures(*this, governor, from);
        if (begin < 0) begin = moment; // so short that it never got ahead
        showUntil(begin + nanosecondsOf(to - from));
        return list;
    }

    bool wants(double time) const { return time < to; }
    int64_t now() const { return moment; }
    double filmAt(int64_t at) const {
        return begin < 0 ? Governor::kNotBegun : from + (double)(at - begin) * 1e-9;
    }
    int sceneOf(double time) const { return sceneAt(time); }
    Pace paceOf(int scene) const { return odraz::paceOf(scene); }
    void trace(Made &m, int, const Governor &governor) {
        before = traced;
        TracedSize size = governor.size();
        traced = {-1, m.time, false, governor.level(), size.width, size.height};
        make(traced);
    }
    void between(Made &m, int, int) {
        Shown s = traced;
        s.time = m.time;
        s.between = shotAt(before.time) == shotAt(traced.time); // else it is traced
        make(s);
    }
    unsigned add(const Made &m) {
        showUntil(moment);
        list.push_back(traced);
        list.back().time = m.time;
        list.back().between = m.time != traced.time;
        unsigned count = queue.add(m);
        if (count == Queue::kAhead) begin = moment;
        return count;
    }
    void await(unsigned number) {
        while (!queue.passed(number)) {
            if (begin < 0) throw std::logic_error("the player would wait for ever");
            moment = std::max(moment, sixtieth(looked));
            showUntil(moment);
        }
    }

private:
    double core() const { return machine.rate / machine.cores; }
    double presenting() const { return machine.presenting * machine.width * machine.height; }

    // Passes the time that a picture takes. Showing others meanwhile takes its share of all cores.
    void make(const Shown &s) {
        Cost cost = costOf({s.time, s.level, (double)s.width * s.height, s.between});
        if (s.width < machine.width) cost.parallel += machine.enlarging * machine.width * machine.height;
        int64_t end = moment + nanosecondsOf(cost.serial / core() + cost.parallel / machine.rate);
        for (int already = -1; already != presented;) {
            already = presented;
            showUntil(end);
            end += nanosecondsOf((presented - already) * presenting() / machine.rate);
        }
        moment = end;
    }
    // The beginning of a sixtieth of the screen, by its number since the film began.
    int64_t sixtieth(int64_t number) const { return begin + nanosecondsOf((double)number / kScreenRate); }
    // Shows what play() would, at all sixtieths up to a moment.
    void showUntil(int64_t until) {
        for (; begin >= 0 && sixtieth(looked) <= until; ++looked) {
            if (looked < free) continue;
            double time = filmAt(sixtieth(looked));
            for (Queue::Turn turn; (turn = queue.turn(time + kNap)) != Queue::kWaits;) {
                unsigned number = queue.shown;
                queue.pass();
                if (turn == Queue::kPasses) continue;
                list[number].at = time;
                ++presented;
                free = looked + std::max(1l, std::lround(std::ceil(presenting() / core() * kScreenRate)));
                break;
            }
        }
    }

    const CostOf &costOf;
    Machine machine;
    double from, to; // of the film
    Queue queue = {};
    std::vector<Shown> list;        // by the numbers of the queue
    Shown before = {}, traced = {}; // the last two
    int64_t moment = 0, begin = -1; // now; the film's first picture
    // Sixtieths: the next one to look at, and the first one at which another picture can be shown
    int64_t looked = 0, free = 0;
    int presented = 0;
};

} // namespace

std::vector<Shown> simulate(const CostOf &costOf, const Machine &machine, double from, double to) {
    return Simulation(costOf, machine, from, to).play();
}

std::vector<PlayedScene> summary(const std::vector<Shown> &list) {
    std::vector<PlayedScene> scenes;
    if (list.empty()) return scenes;
    double from = list.front().time, to = list.back().time + 1 / kScreenRate;
    for (const Span &shot : shots()) {
        double begin = std::max(from, shot.from), end = std::min(to, shot.to);
        if (begin >= end) continue;
        if (scenes.empty() || scenes.back().scene != shot.scene)
            scenes.push_back({shot.scene, 0, 0, 0, 0, 0, 0});
        scenes.back().seconds += end - begin;
    }
    for (PlayedScene &scene : scenes) {
        for (const Shown &s : list) {
            if (sceneAt(s.time) != scene.scene) continue;
            ++(s.between ? scene.between : scene.traced);
            scene.shown += s.at >= 0;
            scene.level += s.between ? 0 : (double)s.level;
            scene.width += s.between ? 0 : s.width;
        }
        scene.level /= std::max(1, scene.traced);
        scene.width /= std::max(1, scene.traced);
    }
    return scenes;
}

std::string printSummary(const std::vector<PlayedScene> &scenes) {
    std::string text = "scene,seconds,traced,between,shown,a_second,level,width\n";
    for (const PlayedScene &s : scenes)
        print(text, "%s,%.2f,%d,%d,%d,%.1f,%.2f,%.0f\n", sceneName(s.scene), s.seconds, s.traced, s.between,
              s.shown, s.shown / s.seconds, s.level, s.width);
    return text;
}

} // namespace odraz
