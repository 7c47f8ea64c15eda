// Tests that the page's player decides as the film's player does if both have one worker and no in-betweens,
// and tests it with several workers.
#include "tools/measure/play/simulated_player.h"

using namespace odraz;
using namespace odraz::measure;

constexpr double kFrom = 3, kTo = 23;

// A film of two scenes. The second one costs more.
struct TwoScenes {
    double core; // speed of a core
    bool goesOn(double time) const { return time < kTo; }
    int sceneOf(double time) const { return time > 13; }
    double startOf(double time) const { return time > 13 ? 13 : 0; }
    Pace paceOf(int) const { return pageOf({}); }
    int64_t cost(const FinishedPicture &m) const {
        double pixels = std::pow((double)m.size.width / 1280, 1.7), unit = sceneOf(m.time) ? 0.06 : 0.03;
        return nanosecondsOf(unit / core * pixels * std::pow(m.level < 1 ? 3 : 2, 1 - m.level));
    }
};

// The decisions for a picture.
struct Decided {
    double time;
    float level;
    int width;
    bool operator==(const Decided &) const = default;
};

struct Native : SimulatedPlayer, TwoScenes {
    explicit Native(double core) : SimulatedPlayer(kFrom), TwoScenes{core} {}
    std::vector<Decided> all;

    void trace(FinishedPicture &m, int, const GovernorOf<false> &governor) {
        m.size = governor.size(), m.level = governor.level();
        all.push_back({m.time, m.level, m.size.width});
        moment += cost(m);
    }
    void between(FinishedPicture &, int, int, double, int) { FAIL() << "it has no in-betweens"; }
    // There are two slots: the film begins when both are full
    unsigned add(const FinishedPicture &m) {
        int64_t began = begin;
        unsigned count = SimulatedPlayer::add(m);
        begin = count == 2 ? moment : began;
        return count;
    }
};
static std::vector<Decided> native(double core) {
    Native player(core);
    GovernorOf<false> governor;
    governor.width = 1280, governor.height = 720;
    makePictures(player, governor, kFrom);
    return player.all;
}

struct Page : TwoScenes {
    std::vector<Decided> all;
    std::vector<double> shown;

    Traceable traceable(double time) const { return time >= 8 && time < 9 ? dark : Traceable::Now; }
    int64_t tracing(const FinishedPicture &m) {
        all.push_back({m.time, m.level, m.size.width});
        return cost(m) * (int64_t)workers;
    }
    int64_t show(const FinishedPicture &m, double at) {
        EXPECT_LE(m.time, at + 0.0081);
        EXPECT_TRUE(shown.empty() || m.time > shown.back());
        shown.push_back(m.time);
        return 0;
    }
    unsigned workers = 1;
    Traceable dark = Traceable::Now;
};
static Page page(double core, unsigned workers, Traceable dark = Traceable::Now) {
    Page film = {{core}, {}, {}, workers, dark};
    Queue queue = {};
    PagePlayer<Page> player = {&film, &queue, (int)workers};
    player.begin(kFrom, 1280, 720);
    bool one = workers == 1;
    if (one) player.most = 2; // slots
    playPage(player, kFrom, one ? 1e-5 : 1 / 60., one ? 0 : player.kNearest);
    return film;
}

TEST(PagePlayer, OneWorkerPlaysAsTheFilmDoes) {
    for (double core : {0.5, 1., 2., 4., 16.}) {
        std::vector<Decided> film = native(core), web = page(core, 1).all;
        for (size_t i = 0; i < std::min(film.size(), web.size()); ++i) {
            ASSERT_EQ(film[i].time, web[i].time) << core << " " << i;
            EXPECT_NEAR(film[i].level, web[i].level, 1e-3) << core << " " << i;
            EXPECT_EQ(film[i].width, web[i].width) << core << " " << i;
        }
        EXPECT_EQ(film.size(), web.size()) << core;
    }
}

TEST(PagePlayer, ManyWorkersPlayEvenly) {
    for (unsigned workers : {2u, 5u, 8u})
        for (double core : {1., 4.}) {
            Page film = page(core, workers);
            EXPECT_GE(film.shown.size(), (size_t)((kTo - kFrom) * 29)) << workers << " " << core;
            EXPECT_GE(film.shown.size() + 20, film.all.size()) << workers << " " << core;
        }
}

TEST(PagePlayer, LeavesOutWhatIsNeverLit) {
    Page film = page(4, 3, Traceable::Never);
    for (const Decided &d : film.all) EXPECT_FALSE(d.time >= 8 && d.time < 9);
    EXPECT_GT(film.shown.back(), 22.9);
}

TEST(Queue, SortsPicturesAndDropsLateOnes) {
    Queue q = {};
    for (double time : {3., 1., 2.}) q.insert({{}, time, 0, 0, 0, {}, 0});
    EXPECT_EQ(q.first().time, 1);
    EXPECT_EQ(q.action(0.5), Queue::kWait);
    EXPECT_EQ(q.action(1), Queue::kShow);
    EXPECT_EQ(q.action(2.5), Queue::kSkip);
    q.remove(), q.remove();
    q.insert({{}, 1.5, 0, 0, 0, {}, 0});
    EXPECT_EQ(q.first().time, 3);
    EXPECT_EQ(q.ready(), 3u);
}
