// Tests the simulated player with invented costs.
#include "tools/measure/play/simulated.h"

#include "play/page_player.h"
#include "show/events.h"
#include "tests/support/thrown.h"
#include "tools/common/command_line.h"

#include <map>
#include <set>

using namespace odraz;
using namespace odraz::measure;

// Costs that differ much between scenes, and grow with quality as the tracer's costs do.
static PictureCost cost(const PictureKind &p) {
    double unit = 1 + std::fmod(std::floor(p.seconds / 16) * 2.7, 4);
    if (p.gap) return {3e6, 250 * p.pixels * unit};
    return {3e6, 300 * p.pixels * unit * std::pow(p.level < 1 ? 3 : 2, 1 - p.level)};
}
constexpr double kFrom = 10, kTo = 55;
static std::vector<ShownPicture> played(double giga) {
    return simulate(cost, {giga * 1e9, 4, 1280, 720}, kFrom, kTo);
}

TEST(Simulated, ListsAreWellFormed) {
    for (double giga : {0.5, 4., 14., 64., 1e6}) {
        std::vector<ShownPicture> list = played(giga);
        EXPECT_EQ(printShown(parseShown(printShown(list))), printShown(list)) << giga;
        EXPECT_EQ(printShown(played(giga)), printShown(list)) << "the same every time";
        for (const ShownPicture &s : list)
            ASSERT_TRUE(s.at < 0 || s.at >= s.time - 1e-3) << "nothing is shown before its time";
    }
}

// The page makes no in-betweens; each worker makes one picture at a time.
TEST(Simulated, ThePageListsAreWellFormed) {
    for (double giga : {4., 14., 64.}) {
        SimulatedMachine machine = {giga * 1e9, 4, 1280, 720};
        machine.workers = 4;
        std::vector<ShownPicture> list = simulate(cost, machine, kFrom, kTo);
        EXPECT_EQ(printShown(parseShown(printShown(list))), printShown(list)) << giga;
        int shown = 0;
        for (const ShownPicture &s : list) {
            ASSERT_TRUE(!s.between && (s.at < 0 || s.at >= s.time - PagePlayer<int>::kNearest));
            shown += s.at >= 0;
        }
        EXPECT_GE(shown, (kTo - kFrom) * (giga < 5 ? 20 : 29)) << giga;
    }
}

// Returns a pace at which all cadences but one have a high penalty.
static Pace paceFor(Governor::Cadence cadence) {
    Pace pace;
    for (int c = 0; c < kCadences; ++c) pace.penalty[c] = c == cadence ? 0 : 99;
    return pace;
}

// The number of in-betweens by gap (in sixtieths of a second), if the film is played in a cadence.
static std::map<long, int> charged(Governor::Cadence cadence, double from, double to) {
    std::map<long, int> gaps;
    CostOf counting = [&](const PictureKind &p) {
        if (p.gap) ++gaps[std::lround(p.gap)];
        return PictureCost{3e6, p.pixels * (p.gap ? 100 : 1500 * std::pow(2, 1 - p.level))};
    };
    SimulatedMachine machine = {20e9, 4, 1280, 720};
    machine.tracingWaits = machine.carryingWaits = machine.touching = 0;
    machine.paceOf = [=](int) { return paceFor(cadence); };
    std::vector<ShownPicture> list = simulate(counting, machine, from, to);
    std::map<long, int> made = std::exchange(gaps, {});
    summary(list, counting, machine);
    EXPECT_EQ(gaps, made) << "the summary charges the same";
    return made;
}

// An in-between has the cost of the gap of its cadence.
TEST(Simulated, InBetweensAreChargedAtTheirGap) {
    for (auto cadence : {Governor::kPairs, Governor::kFours, Governor::kSixes, Governor::kThirty}) {
        std::map<long, int> made = charged(cadence, 150, 160); // without a cut
        int expected = 10 * 60 / Governor::kGap[cadence] * Governor::kInBetweens[cadence];
        if (cadence != Governor::kPairs) {
            EXPECT_LE(made[2], 1) << cadence << " (every film begins in pairs)";
        }
        EXPECT_GT(made[Governor::kGap[cadence]], 0.85 * expected) << cadence;
    }
}

// An in-between next to a cut, which is made from only one picture, has the cost of its cadence's gap too.
// There is a cut at 40 s.
TEST(Simulated, InBetweensNextToACutAreNotTraced) { EXPECT_GT(charged(Governor::kSixes, 39, 41)[6], 80); }

// A faster machine shows as many pictures, or better ones.
TEST(Simulated, FasterMachinesAreNoWorse) {
    for (double giga = 2; giga <= 64; giga *= 1.3) {
        SimulatedMachine machine = {giga * 1e9, 4, 1280, 720};
        std::vector<PlayedScene> slow = summary(played(giga), cost, machine),
                                 fast = summary(played(2 * giga), cost, machine);
        ASSERT_EQ(slow.size(), 3u); // point, table, flake
        for (size_t i = 0; i < slow.size(); ++i)
            EXPECT_TRUE(fast[i].shown >= 0.99 * slow[i].shown || fast[i].level < slow[i].level - 0.3 ||
                        fast[i].width > 1.2 * slow[i].width)
                << giga << ' ' << slow[i].scene;
        EXPECT_LE(slow[1].rate, giga * 1e9 * 1.03) << "no more work than the machine can do";
    }
}

TEST(Simulated, CoresShareWhatIsParallel) {
    auto shown = [](int cores, PictureCost each) {
        CostOf same = [=](const PictureKind &) { return each; };
        SimulatedMachine machine = {8e9, cores, 640, 360};
        return summary(simulate(same, machine, 20, 30), same, machine)[0].shown;
    };
    EXPECT_NEAR(shown(1, {1, 400e6}), shown(8, {1, 400e6}), 2); // showing takes one core's time
    EXPECT_GT(shown(1, {50e6, 1}), 2.9 * shown(8, {50e6, 1}));
}

// Pictures take the time of their pixels' waits, and the first three that of new memory.
TEST(Simulated, PixelsWaitForMemory) {
    SimulatedMachine machine = {20e9, 4, 1280, 720};
    CostOf nothing = [](const PictureKind &) { return PictureCost{0, 0}; };
    machine.paceOf = [](int) { return paceFor(Governor::kPairs); };
    machine.presenting = 0;
    std::vector<ShownPicture> list = simulate(nothing, machine, 2, 4);
    ASSERT_GT(list.size(), 100u);
    for (size_t i = 0; i < list.size(); ++i) {
        double waits = (list[i].between ? kCarryingWaits : kTracingWaits) + (i < 3) * kTouching,
               enlarging = list[i].width < 1280 ? kEnlarging * 1280 * 720 : 0;
        EXPECT_NEAR(list[i].seconds * machine.rate, waits * list[i].width * list[i].height + enlarging, 1e3)
            << i;
    }
}

// A list shows how fast its machine was, also while the player had nothing to do.
TEST(Simulated, TheMachinesRateIsFound) {
    for (int workers : {0, 4})
        for (double giga : {10., 14., 200.}) {
            SimulatedMachine machine = {giga * 1e9, 4, 1280, 720};
            machine.workers = workers;
            std::vector<ShownPicture> list = simulate(cost, machine, kFrom, kTo);
            for (const PlayedScene &scene : summary(list, cost, machine, kFrom + 1))
                EXPECT_NEAR(scene.rate / machine.rate, 1, 0.03) << giga << ' ' << scene.scene;
            if (workers) continue;
            auto rates = ratesOf(list, cost, machine);
            for (double at = kFrom; at < kTo; ++at) EXPECT_NEAR(rates(at) / machine.rate, 1, 0.04) << at;
        }
    EXPECT_NE(thrown<common::Refused>([] { ratesOf({{3, 3, false, 1, 64, 36}}, cost, {0, 4, 64, 36}); }), "");
}

// Half of the rate in half of the film: the scenes are played as by two machines.
TEST(Simulated, TheRateMayChange) {
    SimulatedMachine machine = {0, 4, 1280, 720};
    machine.rateAt = [](double seconds) { return seconds < 30 ? 28e9 : 7e9; };
    std::vector<ShownPicture> list = simulate(cost, machine, kFrom, kTo);
    auto rates = ratesOf(list, cost, machine);
    EXPECT_NEAR(rates(20) / 28e9, 1, 0.04);
    EXPECT_NEAR(rates(50) / 7e9, 1, 0.04);
}

// The summary may leave out the first seconds.
TEST(Simulated, TheSummaryBeginsLater) {
    std::vector<ShownPicture> list = played(14);
    SimulatedMachine machine = {14e9, 4, 1280, 720};
    std::vector<PlayedScene> all = summary(list, cost, machine), later = summary(list, cost, machine, 20);
    ASSERT_EQ(later.size(), 2u); // no point
    EXPECT_NEAR(later[0].seconds, 12, 1e-6);
    EXPECT_LT(later[0].shown, all[1].shown);
    EXPECT_EQ(later[1].shown, all[2].shown);
}

// A scene that the film shows again has one row, with the seconds and the pictures of all its shots.
TEST(Simulated, TheSummaryHasEachSceneOnce) {
    SimulatedMachine machine = {14e9, 4, 1280, 720};
    std::vector<ShownPicture> list = simulate(cost, machine, 0, duration());
    std::set<int> scenes;
    double seconds = 0;
    size_t made = 0;
    for (const PlayedScene &scene : summary(list, cost, machine)) {
        scenes.insert(scene.scene);
        seconds += scene.seconds;
        made += (size_t)(scene.traced + scene.between);
    }
    EXPECT_EQ(scenes.size(), (size_t)kSceneCount);
    EXPECT_NEAR(seconds, duration(), 0.1);
    EXPECT_EQ(made, list.size());
}
