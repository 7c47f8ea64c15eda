// Tests the governor on simulated machines: the player's makePictures() drives it, on a clock that only the
// test advances.
#include "tools/measure/play/simulated_player.h"

using namespace odraz;

// A scene: the seconds that a picture of each quality and an in-between take on one core.
struct SceneCost {
    int id;
    double film, play, draft, make;
};
constexpr SceneCost kUsual = {0, 0.18, 0.07, 0.04, 0.016}, kCostly = {1, 0.54, 0.21, 0.12, 0.048};
// A scene whose in-betweens take longer than tracing the picture.
constexpr SceneCost kEntangled = {2, 0.18, 0.07, 0.04, 0.06};
constexpr double kAlone = 0.001; // seconds of each picture that only one core can work on

struct Machine {
    double cores, noise = 0; // noise: share by which times vary, in both directions
    unsigned seed = 1;
    double hiccupAt = -1;         // the first picture from this time of the film on takes one second longer
    bool hiccupInBetween = false; // that picture is an in-between, not a traced one
    int width = 0, height = 0;    // the screen's size, if fewer pixels may be traced
};
static Machine withScreen(double cores, double noise = 0) {
    return {.cores = cores, .noise = noise, .width = 1280, .height = 720};
}

// The governor's decision after a traced picture.
struct Decision {
    double time; // seconds of the film
    SceneCost scene;
    Governor::Cadence cadence;
    float level;
    bool dropped; // whether the next pictures are dropped
    TracedSize size;
};
using SceneAt = std::function<SceneCost(double)>;
using Penalty = std::array<float, kCadences>;
constexpr Penalty kSomePairs = {0, 0.2f, 50, 50, 6}, kPairsAlone = {1e9, 0, 1e9, 1e9, 1e9};

// Makes and shows pictures as the player does, on the clock of the test.
class GovernedPlayer : public measure::SimulatedPlayer {
public:
    GovernedPlayer(const Machine &machine, double length, SceneAt sceneAt, const Penalty &penalty)
        : SimulatedPlayer(0), machine(machine), random(machine.seed), sceneAt(sceneAt), length(length) {
        governor.width = machine.width, governor.height = machine.height;
        std::copy(penalty.begin(), penalty.end(), pace.penalty);
    }

    std::vector<Decision> play() {
        makePictures(*this, governor, 0);
        return all;
    }

    // The rest of the interface that makePictures() needs
    bool goesOn(double time) {
        if (!all.empty()) {
            Decision &last = all.back();
            last.cadence = governor.cadence;
            last.level = governor.coarseness;
            last.dropped = time > last.time + governor.step() + 1e-9;
        }
        return time < length;
    }
    int sceneOf(double time) const { return sceneAt(time).id; }
    double startOf(double time) const { return time < cut ? 0 : cut; }
    Pace paceOf(int id) const {
        Pace p = pace;
        if (foresight) p.cost = (float)(id ? kCostly : kUsual).play;
        return p;
    }
    void trace(FinishedPicture &m, int, const Governor &) {
        SceneCost scene = sceneAt(m.time);
        all.push_back({m.time, scene, {}, 0, false, governor.size()});
        spend(traceTime(scene) * pixels(), hiccup(m.time, false));
    }
    void between(FinishedPicture &, int, int, double, int) {
        const Decision &later = all.back();
        spend(later.scene.make * pixels(), hiccup(later.time, true));
    }

    Pace pace;              // the same for all scenes, but for the cost
    bool foresight = false; // whether its cost is that of kUsual and kCostly
    double cut = 0;         // time at which the second shot begins
    Governor governor;

private:
    // The cost relative to tracing all pixels: about the 0.85th power of the share of the pixels.
    double pixels() const {
        return machine.width ? std::pow((double)governor.size().width / machine.width, 1.7) : 1;
    }
    double traceTime(const SceneCost &s) const {
        double t = governor.level();
        return t < 1 ? s.film * std::pow(s.play / s.film, t) : s.play * std::pow(s.draft / s.play, t - 1);
    }
    double hiccup(double time, bool between) {
        if (machine.hiccupAt < 0 || time < machine.hiccupAt || between != machine.hiccupInBetween) return 0;
        machine.hiccupAt = -1;
        return 1;
    }
    void spend(double oneCore, double hiccup) {
        std::uniform_real_distribution<double> vary(1 - machine.noise, 1 + machine.noise);
        moment += std::llround(((kAlone + oneCore / machine.cores) * vary(random) + hiccup) * 1e9);
    }

    Machine machine;
    std::mt19937 random;
    SceneAt sceneAt;
    double length; // seconds of the film
    std::vector<Decision> all;
};

static SceneAt always(const SceneCost &scene) {
    return [=](double) { return scene; };
}
static std::vector<Decision> played(const Machine &machine, double length, SceneAt sceneAt = always(kUsual),
                                    const Penalty &penalty = kSomePairs) {
    return GovernedPlayer(machine, length, sceneAt, penalty).play();
}
static std::vector<Decision> playedInPairs(const Machine &machine, double length,
                                           SceneAt sceneAt = always(kUsual)) {
    return played(machine, length, sceneAt, kPairsAlone);
}
// A costly scene between two usual ones, from 5 to 10 seconds.
static SceneCost costlyFromFiveToTen(double time) { return time < 5 || time >= 10 ? kUsual : kCostly; }

// Statistics between two times of the film.
struct Summary {
    int changes = 0, drops = 0, pictures = 0; // changes: number of changes of the cadence
    float least = 9, most = 0;                // range of the level
    std::set<Governor::Cadence> cadences;
};
static Summary seen(const std::vector<Decision> &all, double from, double to) {
    Summary s;
    for (size_t i = 1; i < all.size(); ++i) {
        const Decision &d = all[i];
        if (d.time < from || d.time >= to) continue;
        s.changes += d.cadence != all[i - 1].cadence;
        s.drops += d.dropped;
        ++s.pictures;
        s.least = std::min(s.least, d.level);
        s.most = std::max(s.most, d.level);
        s.cadences.insert(d.cadence);
    }
    return s;
}

// The cadence settles even if times vary by 30 %.
TEST(Governor, SettlesSoonAndNeverSwings) {
    for (int cores = 1; cores <= 16; ++cores)
        for (unsigned seed = 0; seed <= 10; ++seed) {
            SCOPED_TRACE(testing::Message() << cores << ' ' << seed);
            bool noise = seed > 0;
            auto all = played({(double)cores, noise ? 0.3 : 0, seed}, 30);
            EXPECT_LE(seen(all, 0, 1).changes, 1);
            Summary then = seen(all, noise ? 1 : 1.5, 30);
            EXPECT_LE(then.changes, noise); // two cadences may be equally good
            EXPECT_TRUE(then.changes || then.most - then.least < (noise ? 0.6f : 0.03f));
            EXPECT_TRUE(noise || cores < 3 || !then.drops);
        }
}

// A costly part, three times as slow, begins and ends suddenly: once as another scene, once within the same
// scene.
TEST(Governor, ChangesItsCadenceAtMostTwiceWhereCostsJump) {
    for (bool sameScene : {false, true})
        for (double noise : {0., 0.3})
            for (double cores = 1; cores <= 16; cores *= 1.05)
                for (unsigned seed = 1; seed <= (noise > 0 ? 5 : 1); ++seed) {
                    auto all = played({cores, noise, seed}, 30, [&](double time) {
                        SceneCost s = (int)(time / 5) % 2 ? kCostly : kUsual;
                        if (sameScene) s.id = 0;
                        return s;
                    });
                    for (int from = 0; from < 30; from += 5) {
                        SCOPED_TRACE(testing::Message() << cores << ' ' << seed << ' ' << from);
                        Summary then = seen(all, from + 1.5, from + 5);
                        EXPECT_LE(seen(all, from, from + 5).changes, 2);
                        EXPECT_LE(then.changes, noise > 0 || cores < 1.15);
                        if (noise > 0 || cores < 6.5) continue;
                        EXPECT_LT(then.most - then.least, 0.1f);
                        EXPECT_EQ(then.drops, 0);
                    }
                }
}

// A picture that takes a second longer does not change later ones.
TEST(Governor, ForgetsAHiccup) {
    for (bool between : {false, true})
        for (int cores = 2; cores <= 16; ++cores) {
            SCOPED_TRACE(cores);
            auto all = played({.cores = (double)cores, .hiccupAt = 5, .hiccupInBetween = between}, 15);
            Summary before = seen(all, 2, 5), later = seen(all, 7.2, 15), whole = seen(all, 2, 15);
            EXPECT_EQ(whole.changes, 0);
            EXPECT_LT(whole.most - before.most, 0.5f);
            EXPECT_NEAR(later.least, before.least, 0.05f);
            EXPECT_NEAR(later.most, before.most, 0.05f);
        }
}

TEST(Governor, TracesAllSixtyWhereItCan) {
    auto all = played({16}, 10);
    Summary then = seen(all, 1, 10);
    EXPECT_EQ(then.cadences, std::set{Governor::kSixty});
    EXPECT_EQ(then.pictures, 540);
    EXPECT_EQ(then.most, Governor::kFinest);
}

TEST(Governor, LeavesSixtyWhenTheyCostTooMuch) {
    auto all = played({10}, 10, costlyFromFiveToTen);
    EXPECT_EQ(seen(all, 4, 5).cadences, std::set{Governor::kSixty});
    EXPECT_EQ(seen(all, 6, 10).cadences, std::set{Governor::kPairs});
}

TEST(Governor, ShowsThirtyWhereMakingCostsMore) {
    auto all = played({2}, 15, [](double time) { return time < 5 || time >= 10 ? kUsual : kEntangled; });
    EXPECT_EQ(seen(all, 6, 10).cadences, std::set{Governor::kThirty});
    EXPECT_LE(seen(all, 6, 10).drops, 8);
    EXPECT_EQ(seen(all, 11, 15).cadences, std::set{Governor::kPairs}) << "the next scene tries again";
}

TEST(Governor, KeepsTimeInDraftAndDropsPicturesWhereAllIsTooMuch) {
    auto all = playedInPairs({1}, 20);
    Summary then = seen(all, 1, 20);
    EXPECT_EQ(then.least, (float)Governor::kSteps);
    EXPECT_NEAR(then.pictures, 19 / (0.04 + 0.016 + 2 * kAlone), 3) << "no moment is lost";
    EXPECT_NEAR(all.back().time, 20, 0.1);
}

TEST(Governor, MixesQualities) {
    Governor g;
    auto at = [&](float level) { return g.coarseness = level, g.quality(); };
    for (auto name : {QualityName::Film, QualityName::Play, QualityName::Draft}) {
        float level = (float)QualityName::Film - (float)name; // 0, 1, 2
        EXPECT_FLOAT_EQ(at(level).threshold, kQualities[(int)name].threshold) << level;
        EXPECT_EQ(at(level).smallest, kQualities[(int)name].smallest) << level;
    }
    for (float level = 0; level < 1.99f; level += 0.01f)
        EXPECT_LT(at(level).threshold, at(level + 0.01f).threshold) << level;
    // A blend takes all its other settings from a named quality
    EXPECT_EQ(at(0.99f).smallest, kQualities[(int)QualityName::Film].smallest);
}

// --- Pixels ---

TEST(Governor, TracesFewerPixelsWhereTimeIsShort) {
    for (double cores : {1., 1.5, 2., 3.}) {
        auto all = playedInPairs(withScreen(cores), 20);
        Summary then = seen(all, 2, 20);
        const Decision &last = all.back();
        SCOPED_TRACE(cores);
        EXPECT_EQ(then.drops, 0);
        EXPECT_TRUE(then.cadences.count(Governor::kPairs));
        EXPECT_TRUE(cores > 1.5 || last.size.width < 1280);
        EXPECT_TRUE(cores < 3 || last.size.width == 1280);
        EXPECT_GE(last.size.width, Pace{}.leastWidth);
        EXPECT_NEAR(last.size.height, last.size.width * 9 / 16., 0.5);
    }
}

// A size that rises and falls all the time would be visible as pulsation. A step of 48 pixels is below 4 % of
// the width. Only times that vary by 30 % change the size more than once in ten seconds. Slightly fewer
// pixels would blur the picture and save almost nothing: all are traced, or clearly fewer.
TEST(Governor, ChangesTheSizeSeldomAndByLittle) {
    for (double noise : {0., 0.1, 0.3})
        for (double cores = 1; cores < 4; cores *= 1.1) {
            auto all = playedInPairs(withScreen(cores, noise), 62);
            int changes = 0, largest = 0;
            for (size_t i = 1; i < all.size(); ++i) {
                EXPECT_TRUE(all[i].size.width == 1280 || all[i].size.width <= 1248) << all[i].size.width;
                if (all[i].time < 2) continue;
                int step = std::abs(all[i].size.width - all[i - 1].size.width);
                changes += step != 0;
                largest = std::max(largest, step);
            }
            double most = noise == 0 ? 0 : noise < 0.2 ? 0.1 : 2; // changes a second
            EXPECT_LE(changes, most * 60 + 1) << noise << ' ' << cores;
            EXPECT_LE(largest, 48) << noise << ' ' << cores;
        }
}

// When there is time again, the pixels return first, then the quality.
TEST(Governor, ComesBackToAllPixels) {
    for (double cores : {2., 3., 4.}) {
        auto all = playedInPairs(withScreen(cores), 15, costlyFromFiveToTen);
        auto at = [&](double time) {
            return *std::find_if(all.begin(), all.end(), [=](const Decision &d) { return d.time >= time; });
        };
        EXPECT_LT(at(9.5).size.width, 0.9 * at(4.5).size.width) << cores;
        EXPECT_NEAR(at(14.5).size.width, at(4.5).size.width, 76) << cores; // kDeadBand, in both directions
        EXPECT_NEAR(at(14.5).level, at(4.5).level, 0.2) << cores;
    }
}

// Pixels that were given up in one cadence return at once in a better one.
TEST(Governor, TakesAllPixelsInABetterCadence) {
    SceneCost easy = {0, .05, .02, .012, .004}, hard = {0, .36, .14, .08, .006};
    auto all =
        played(withScreen(2), 10, [=](double t) { return t < 3 ? easy : hard; }, {0, 0.2f, 0.8f, 1.5f, 6});
    auto change = std::adjacent_find(all.begin(), all.end(), [](const Decision &a, const Decision &b) {
        return a.size.width < 1280 && a.cadence < Governor::kFours && b.cadence >= Governor::kFours;
    });
    ASSERT_LT(change + 2, all.end());
    for (auto d = change + 2; d != all.end(); ++d) EXPECT_EQ(d->size.width, 1280) << d->time;
}

// Thirty pictures a second are shown if their penalty is less than the error of fewer pixels. All in-betweens
// return when there is time.
TEST(Governor, ShowsThirtyWhereThePenaltyIsLess) {
    SceneCost easy = {0, .05, .02, .012, .005};
    auto all =
        played(withScreen(1), 20, [=](double time) { return time < 10 ? kUsual : easy; }, {0, 1, 50, 50, 4});
    EXPECT_TRUE(seen(all, 2, 10).cadences.count(Governor::kThirty));
    EXPECT_LE(seen(all, 1, 10).changes, 1);
    EXPECT_GT(all[250].size.width, 950) << "in pairs it is 832";
    EXPECT_FALSE(seen(all, 12, 20).cadences.count(Governor::kThirty));
    EXPECT_LE(seen(all, 10, 20).changes, 2);
}

// The film must not begin as a slide show, even on a screen that is far too large for the machine: all thirty
// pictures a second are traced soon, as coarse as they stay.
TEST(Governor, IsAsCoarseAsItMustBeAfterOneAndAHalfSeconds) {
    auto all =
        playedInPairs({.cores = 1, .width = 2560, .height = 1440}, 10, always({0, 0.72, 0.28, 0.16, 0.064}));
    Summary early = seen(all, 1.5, 2.5), late = seen(all, 8, 9);
    EXPECT_NEAR(early.most, late.most, 0.05);
    EXPECT_GE(early.pictures, 29);
}

// If fewer pixels would make letters illegible, pictures are dropped instead.
TEST(Governor, KeepsTheWidthThatTheSceneNeeds) {
    GovernedPlayer player(withScreen(1), 10, always(kUsual), kPairsAlone);
    player.pace.leastWidth = 1280;
    for (const Decision &d : player.play()) EXPECT_EQ(d.size.width, 1280);
    EXPECT_EQ(player.governor.level(), 2);
}

// The governor does not oscillate between cadences, whatever their penalties.
TEST(Governor, StaysWithItsCadence) {
    bool taken[kCadences] = {};
    for (const Penalty &penalty : {Penalty{0, 0.2f, 0.8f, 1.5f, 6},
                                   {0, 0.2f, 0.4f, 0.5f, 20},
                                   {0, 1, 3, 6, 2},
                                   {0, 4, 2, 1, 0.5f},
                                   {0, 0, 0, 0, 0}})
        for (double noise : {0., 0.1})
            for (double cores = 0.5; cores < 24; cores *= 1.1) {
                auto all = played(withScreen(cores, noise), 30, always(kUsual), penalty);
                EXPECT_LE(seen(all, 3, 30).changes, 1) << penalty[1] << ' ' << noise << ' ' << cores;
                taken[all.back().cadence] = true;
            }
    for (bool one : taken) EXPECT_TRUE(one);
}

// Three or five in-betweens are made if that is less work than tracing, and the penalty is small.
TEST(Governor, TracesFewWhereMakingIsCheap) {
    auto all = played(withScreen(2), 10, always(kUsual), {0, 0.1f, 0.1f, 0.1f, 9});
    EXPECT_TRUE(all.back().cadence >= Governor::kFours && all.back().cadence <= Governor::kSixes);
    EXPECT_EQ(seen(all, 1, 10).drops, 0);
    EXPECT_LT(all.back().level, 1);
}

// The first picture of each shot is traced, at exactly the sixtieth of a second at which the shot begins.
TEST(Governor, TracesAtCuts) {
    for (int sixtieth = 300; sixtieth < 312; ++sixtieth) {
        GovernedPlayer player(withScreen(2), 10, always(kUsual), {0, 0.1f, 0.1f, 0.1f, 9});
        player.cut = sixtieth / 60.0;
        auto all = player.play();
        EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Decision &d) {
            return std::abs(d.time - player.cut) < 1e-6;
        })) << sixtieth;
        EXPECT_LE(seen(all, 1, 10).drops, 1);
    }
}

// The first picture of a costly scene is in time if the scene's cost is given. The first one of a cheap scene
// is not finer than `play`, since the times of single pictures differ from their scene's.
TEST(Governor, ForeseesTheCostOfAScene) {
    for (bool foresight : {false, true}) {
        GovernedPlayer player(withScreen(8), 12, costlyFromFiveToTen, kPairsAlone);
        player.foresight = foresight;
        auto all = player.play();
        EXPECT_EQ(seen(all, 4.9, 5.2).drops > 0, !foresight);
        EXPECT_GE(seen(all, 10, 10.05).least, Governor::kPlay - 0.2f);
    }
}

// A scene that needs all pixels has them from its first picture on, whatever the previous scene gave up.
TEST(Governor, IsNeverCoarserThanDraft) {
    Governor g;
    g.width = 1280, g.height = 720;
    g.coarseness = 3;
    Pace wide;
    wide.leastWidth = 1280;
    g.enter(1, wide);
    EXPECT_EQ(g.level(), Governor::kSteps);
    EXPECT_EQ(g.size().width, 1280);
}
