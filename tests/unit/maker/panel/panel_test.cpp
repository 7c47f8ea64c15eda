// Tests the panel over pictures of the film, as odraz-debug uses it.
#include "maker/panel/panel.h"
#include "tests/support/loaded_film.h"
#include "tests/support/pictures.h"

#include <chrono>

using namespace odraz;
using namespace odraz::maker;

static int64_t nanosecondsNow() { return std::chrono::steady_clock::now().time_since_epoch().count(); }

static const Quality &kDraft = kQualities[(int)QualityName::Draft],
                     &kBest = kQualities[(int)QualityName::Film];

// The film without its hall, with a panel over its pictures
struct FilmWithPanel : LoadedFilm {
    Panel panel;
    FilmWithPanel(int width, int height)
        : LoadedFilm(1, width, height, false), panel(width, height, 25, nanosecondsNow) {}
    Picture plain(double time, const Quality &q = kDraft) { return odraz::picture(*intro, 0, time, q); }
    Picture picture(double time, const Quality &q = kDraft) {
        return panel.picture(*intro, {time, q, nullptr});
    }
    size_t samples() const {
        const std::vector<uint32_t> &all = panel.samples();
        return std::accumulate(all.begin(), all.end(), (size_t)0);
    }
};

// --- The map of samples ---

// Sizes are odd, so that tiles are cut at the right and the lower edge
TEST(Heat, AddsUpToTheSamplesThatTheEngineCounts) {
    FilmWithPanel film(203, 117);
    film.panel.act(Action::Heat);
    for (const Quality &q : kQualities)
        for (double time : {12., 22., 45.}) {
            if (q.grid && time != 22) continue;
            film.picture(time, q);
            EXPECT_GT(film.samples(), 0u);
            EXPECT_EQ(film.samples(), (size_t)film.panel.lastCosts().samples) << q.name << " " << time;
        }
}

TEST(Heat, CountsTheSamplesOfAGridWhereTheyAre) {
    FilmWithPanel film(203, 117);
    film.panel.act(Action::Heat);
    Quality grid = kDraft;
    grid.grid = 2;
    film.picture(22, grid);
    for (uint32_t n : film.panel.samples()) ASSERT_EQ(n, 4u);
    EXPECT_EQ(film.panel.lastCosts().samplesAPixel(), 4);
}

// Anti-aliasing adds samples where green differs between neighbours by 32 levels or more, but hardly any
// where it does not differ by 4.
TEST(Heat, IsHotWhereThereAreEdges) {
    FilmWithPanel film(320, 180);
    film.panel.act(Action::Heat);
    film.picture(22, kBest);
    std::vector<uint8_t> rgba = bytesOf(film.plain(22, kBest));
    int edges = 0, hotEdges = 0, smooth = 0, hotSmooth = 0;
    for (int i = 321; i < 320 * 179 - 1; ++i) {
        int step = 0;
        for (int to : {1, -1, 320, -320})
            step = std::max(step, std::abs(rgba[(size_t)i * 4 + 1] - rgba[(size_t)(i + to) * 4 + 1]));
        bool hot = film.panel.samples()[(size_t)i] > 3;
        edges += step >= 32, hotEdges += step >= 32 && hot;
        smooth += step < 4, hotSmooth += step < 4 && hot;
    }
    EXPECT_GT(hotEdges, edges * 3 / 4);
    EXPECT_LT(hotSmooth, smooth / 50);
    EXPECT_GT(edges, 100);
}

TEST(Heat, ColoursGrowBrighter) {
    int before = -1;
    for (float n : {0.01f, 0.1f, 0.3f, 1.f, 3.f, 8.f, 16.f}) {
        Colour c = heatOf(n);
        int bright = c.r * 3 + c.g * 6 + c.b;
        EXPECT_GT(bright, before - (n < 0.05f)) << n;
        before = bright;
    }
}

// On black, a colour is drawn at 184/256 of its value
TEST(Heat, ShowsHowFarApartTheSamplesAre) {
    constexpr int kWidth = 24, kHeight = 12; // the lower squares are cut
    std::vector<uint8_t> rgba(kWidth * kHeight * 4);
    std::vector<uint32_t> samples(kWidth * kHeight);
    auto at = [&](int x, int y) -> uint32_t & { return samples[(size_t)(y * kWidth + x)]; };
    at(0, 0) = 1;                                    // the first square has one sample,
    at(8, 0) = at(12, 0) = at(8, 4) = at(12, 4) = 1; // the second four,
    for (int y = 0; y < 8; ++y) // in the third every pixel has one, except one that has 16
        for (int x = 16; x < 24; ++x) at(x, y) = x == 20 && y == 3 ? 16 : 1;
    Canvas canvas(Picture{kWidth, kHeight, rgba.data()});
    drawHeat(canvas, samples);
    auto shows = [&](int x, int y, float n) {
        Colour c = heatOf(n);
        const uint8_t *p = canvas.at(x, y);
        return p[0] == c.r * 184 >> 8 && p[1] == c.g * 184 >> 8 && p[2] == c.b * 184 >> 8;
    };
    EXPECT_TRUE(shows(0, 0, 1 / 64.f));
    EXPECT_TRUE(shows(7, 7, 1 / 64.f));
    EXPECT_TRUE(shows(8, 0, 1 / 16.f));
    EXPECT_TRUE(shows(15, 7, 1 / 16.f));
    EXPECT_TRUE(shows(16, 0, 1));
    EXPECT_TRUE(shows(20, 3, 16));
    EXPECT_TRUE(shows(21, 3, 1));
    EXPECT_TRUE(shows(23, 11, 0));
}

// --- The costs of a picture ---

TEST(PictureCosts, PartsSumToTheWholeAtMost) {
    FilmWithPanel film(320, 180);
    film.panel.act(Action::Panel);
    film.picture(22);
    const PictureCosts &c = film.panel.lastCosts();
    double sum = 0;
    for (PicturePart part :
         {PicturePart::Posing, PicturePart::Tracing, PicturePart::Glare, PicturePart::Development}) {
        EXPECT_GT(c.milliseconds[(int)part], 0) << (int)part;
        sum += c.milliseconds[(int)part];
    }
    EXPECT_EQ(c.milliseconds[(int)PicturePart::Enlarging], 0);
    EXPECT_LE(sum, c.whole);
}

TEST(Probe, MeasuresOnlyWhenSet) {
    LoadedFilm film(1, 64, 36, false);
    Probe probe;
    probe.clock = nanosecondsNow;
    inspector().watch(&probe);
    picture(*film.intro, 0, 22, kDraft, nullptr, {32, 18});
    inspector().watch(nullptr);
    for (int64_t spent : probe.spent) EXPECT_GT(spent, 0); // enlarging included
    Probe before = probe;
    picture(*film.intro, 0, 22, kDraft);
    for (int i = 0; i < (int)PicturePart::Count; ++i) EXPECT_EQ(probe.spent[i], before.spent[i]);
}

// --- The picture ---

TEST(Panel, ShowsThePictureAloneWhenHidden) {
    FilmWithPanel film(320, 180);
    std::vector<uint8_t> alone = bytesOf(film.plain(22));
    auto isAlone = [&] { return bytesOf(film.picture(22)) == alone; };
    EXPECT_TRUE(isAlone());
    film.panel.act(Action::Panel);
    EXPECT_FALSE(isAlone());
    film.panel.act(Action::Panel);
    EXPECT_TRUE(isAlone());
    film.panel.act(Action::Help);
    EXPECT_FALSE(isAlone());
}

// Draws every part of the panel in pictures of several sizes, for sanitizers to check
TEST(Panel, DrawsOnPicturesOfAllSizes) {
    for (auto [width, height] : {std::pair{1, 1}, {16, 9}, {239, 200}, {320, 180}, {100, 500}, {500, 100}}) {
        FilmWithPanel film(width, height);
        Panel &panel = film.panel;
        double time = 163.9;
        bool paused = false, sought = false;
        for (Action a : {Action::Panel, Action::Heat, Action::Help, Action::LoopShot}) {
            panel.act(a);
            panel.move(width - 1, height - 1);
            panel.wheel(width - 1, height - 1, 3);
            panel.steer(time, paused, sought);
            film.picture(22);
        }
    }
}

// --- Keys and the mouse ---

struct Host {
    Panel panel{1280, 720, 25, nanosecondsNow};
    double time = 30;
    bool paused = false, sought = false;

    Host() { panel.act(Action::Panel); }
    void steer() {
        sought = false;
        panel.steer(time, paused, sought);
    }
    void act(Action a) {
        panel.act(a);
        steer();
    }
    double x(double seconds) const { return panel.timeLine().xOf(seconds); }
    double y() const { return panel.timeLine().area.y + 5; }
};

TEST(Panel, StepsByPictureBarAndEvent) {
    Host h;
    h.steer();
    EXPECT_FALSE(h.sought);
    auto after = [&](Action a) {
        h.act(a);
        EXPECT_TRUE(h.sought && h.paused);
        return h.time;
    };
    EXPECT_NEAR(after(Action::PictureOn), 30.04, 1e-9);
    EXPECT_NEAR(after(Action::PictureBack), 30, 1e-9);
    EXPECT_NEAR(after(Action::BarOn), 32, 1e-9);
    EXPECT_NEAR(after(Action::BarBack), 30, 1e-9);
    EXPECT_NEAR(after(Action::BarBack), 28, 1e-9);
    EXPECT_NEAR(after(Action::EventOn), 31.5, 1e-9) << "the glass ball swallows the lens";
    EXPECT_NEAR(after(Action::EventBack), 26, 1e-9) << "the dark ball";
    // Two key presses between two pictures make two steps
    h.panel.act(Action::BarOn);
    h.panel.act(Action::BarOn);
    h.steer();
    EXPECT_NEAR(h.time, 30, 1e-9);
}

TEST(Panel, ScrubsAndHoldsTheTimeAtTheMouse) {
    Host h;
    h.steer();
    h.panel.press(h.x(50), h.y(), Panel::Button::Left);
    EXPECT_TRUE(h.panel.grabs());
    h.steer();
    EXPECT_NEAR(h.time, 50, 1e-6);
    h.panel.move(h.x(70), 3); // may leave the strip
    h.steer();
    EXPECT_NEAR(h.time, 70, 1e-6);
    h.time += 0.1; // the film plays
    h.steer();
    EXPECT_NEAR(h.time, 70, 1e-6);
    h.panel.release();
    h.steer();
    h.time += 0.1;
    h.steer();
    EXPECT_NEAR(h.time, 70.1, 1e-6);
    EXPECT_FALSE(h.panel.grabs() || h.paused);
}

TEST(Panel, LoopsAPart) {
    Host h;
    h.panel.press(h.x(60), h.y(), Panel::Button::Right);
    h.panel.move(h.x(65), h.y());
    h.panel.release();
    EXPECT_NEAR(h.panel.loop().from, 60, 0.51);
    EXPECT_NEAR(h.panel.loop().to, 65, 0.51);
    h.steer();
    EXPECT_EQ(h.time, h.panel.loop().from);
    EXPECT_TRUE(h.sought);
    h.time = h.panel.loop().to + 0.01;
    h.steer();
    EXPECT_EQ(h.time, h.panel.loop().from);
    // While paused, times outside the loop can be shown
    h.paused = true;
    h.time = 10;
    h.steer();
    EXPECT_EQ(h.time, 10);
    // A click ends the loop; the key loops the shot
    h.panel.press(h.x(20), h.y(), Panel::Button::Right);
    h.panel.release();
    EXPECT_FALSE(h.panel.loop().on());
    h.time = 26;
    h.steer();
    h.act(Action::LoopShot);
    EXPECT_EQ(h.panel.loop().from, 26);
    EXPECT_EQ(h.panel.loop().to, 28);
    h.act(Action::LoopShot);
    EXPECT_FALSE(h.panel.loop().on());
}

TEST(Panel, LeavesOtherMouseEventsToTheHost) {
    Host h;
    h.panel.press(640, 300, Panel::Button::Left);
    EXPECT_FALSE(h.panel.grabs());
    h.panel.act(Action::Panel); // hidden
    h.panel.press(h.x(50), h.y(), Panel::Button::Left);
    EXPECT_FALSE(h.panel.grabs());
}

// --- The film's content ---

TEST(Content, IsInOrderAndInTheFilm) {
    Content c = contentOf(inspector());
    EXPECT_EQ(c.end, duration());
    EXPECT_EQ(c.shots[0].from, 0);
    for (size_t i = 1; i < c.shots.size(); ++i) EXPECT_EQ(c.shots[i].from, c.shots[i - 1].to);
    ASSERT_FALSE(c.events.empty());
    for (size_t i = 1; i < c.events.size(); ++i) EXPECT_GE(c.events[i].at, c.events[i - 1].at);
    EXPECT_EQ(inWords(c.events[0]), "light is born");
    bool found = false;
    for (const EventInfo &e : c.events) {
        EXPECT_LT(e.at, c.end);
        found = found || inWords(e) == "generation 2";
        // The scene of an event is on screen
        EXPECT_GE(e.at, c.shotAt(e.at).story);
    }
    EXPECT_TRUE(found);
    for (const ShotInfo &s : c.shots)
        for (double t : {s.from, (s.from + s.to) / 2}) {
            CameraKey a = cameraAt(t), b = pose(*s.path, (float)((t - s.story) * kRowsPerSecond));
            EXPECT_NEAR(length(a.eye - b.eye), 0, 1e-4) << t;
        }
}
