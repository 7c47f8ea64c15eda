// Measures the film's music: hits are on time and follow silence, every scene has noise, and nothing clips.
#include "tests/support/shots.h"
#include "tools/support/hits.h"

#include "show/score.h"

using namespace odraz;
using namespace odraz::measure;

// The whole music, rendered once.
static const Recording &music() {
    static const Recording all = [] {
        auto m = std::make_unique<Mixer>();
        m->player = playRow;
        Recording r;
        r.rate = kSampleRate;
        for (int block = 0; block < (int)kFilm.endRow * kBlocksPerRow; ++block) {
            float stereo[2 * kBlock];
            renderBlock(*m, stereo);
            for (int i = 0; i < 2 * kBlock; ++i) r.side[i & 1].push_back(stereo[i]);
        }
        return r;
    }();
    return all;
}

static int64_t sampleOf(double row) { return (int64_t)(row / kRowsPerSecond * kSampleRate); }

// Returns the loudness of each bar in LUFS: the level after the two filters of ITU-R BS.1770-4.
static std::vector<double> loudnessOfBars() {
    static constexpr double kFilters[2][5] = {
        {1.53512485958697, -2.69169618940638, 1.19839281085285, -1.69065929318241, 0.73248077421585},
        {1, -2, 1, -1.99004745483398, 0.99007225036621}};
    std::vector<double> bars(music().size() / kSampleRate / 2);
    for (const std::vector<float> &side : music().side) {
        double state[2][2] = {};
        for (size_t i = 0; i < side.size(); ++i) {
            double x = (double)side[i];
            for (int f = 0; f < 2; ++f) {
                const double *k = kFilters[f];
                double y = k[0] * x + state[f][0];
                state[f][0] = k[1] * x - k[3] * y + state[f][1];
                state[f][1] = k[2] * x - k[4] * y;
                x = y;
            }
            bars[i / kSampleRate / 2] += x * x / (2 * kSampleRate);
        }
    }
    for (double &bar : bars) bar = -0.691 + 10 * std::log10(bar + 1e-20);
    return bars;
}

// The whole film's curve of loudness, in stretches that rise or fall evenly.
TEST(Music, FollowsItsCurveOfLoudness) {
    struct Stretch {
        int from, to; // bars, both included
        double first, last;
    };
    static constexpr Stretch kCurve[] = {
        {0, 5, -36, -22},    {6, 15, -22, -18},  {16, 16, -32, -32}, {17, 27, -21, -14.5},
        {28, 31, -36, -25},  {32, 35, -19, -16}, {36, 40, -25, -22}, {41, 45, -20, -30},
        {46, 51, -24, -20},  {52, 55, -19, -14}, {56, 59, -13, -13}, {60, 63, -12, -12},
        {64, 67, -11, -9.5}, {68, 69, -23, -25}, {70, 73, -36, -23}, {74, 80, -25, -42}};
    std::vector<double> bars = loudnessOfBars();
    for (const Stretch &s : kCurve)
        for (int bar = s.from; bar <= s.to; ++bar)
            EXPECT_NEAR(bars[(size_t)bar],
                        s.first + (s.last - s.first) * (bar - s.from) / std::max(s.to - s.from, 1), 1.5)
                << "bar " << bar;
    double summit = *std::max_element(bars.begin() + 64, bars.begin() + 68),
           first = *std::max_element(bars.begin(), bars.begin() + 56);
    EXPECT_GT(summit, first + 4);
    for (int bar = 0; bar < (int)bars.size(); ++bar)
        EXPECT_TRUE((bar >= 64 && bar < 68) || bars[(size_t)bar] < -11.5)
            << "louder than the summit: " << bar;
    EXPECT_GE(std::count_if(bars.begin(), bars.begin() + 74, [=](double l) { return l < summit - 18; }), 5);
}

TEST(Music, HitsAreOnTime) {
    std::vector<int> rows = hitRows();
    for (int row : rows) EXPECT_LE(riseTime(music(), sampleOf(row)), 10) << row;
    EXPECT_GE(rows.size(), 10u);
}

// The rows before the big hits are silent, after 30 ms in which the sound fades.
TEST(Music, IsSilentBeforeTheBigHits) {
    std::vector<int> rows = hitRows();
    for (const Silence &silence : kSilences) {
        int row = firstRow(silence.scene) + silence.before;
        int64_t at = sampleOf(row), from = sampleOf(row - silence.rows);
        EXPECT_LT(level(music(), from + kSampleRate * 3 / 100, at), -100) << row;
        EXPECT_GT(level(music(), from - kSampleRate, from), -40) << row << ": the music plays before it";
        if (silence.scene == kPatches && silence.before == (int)rowOf(kLinesSpread))
            continue; // it begins softly
        EXPECT_GT(level(music(), at, at + kSampleRate / 20), -20) << row;
        EXPECT_TRUE(std::count(rows.begin(), rows.end(), row)) << row << ": a drum is struck";
    }
}

TEST(Music, HasNoiseInEveryScene) {
    for (const SceneSpan &span : sceneSpans())
        EXPECT_GT(flatness(music(), sampleOf(span.from), sampleOf(span.to)), 0.05)
            << kScenes[span.scene].name;
}

TEST(Music, NeverClipsAndEndsInSilence) {
    float most = 0;
    for (const std::vector<float> &side : music().side)
        for (float x : side) most = std::max(most, std::fabs(x));
    EXPECT_LT(most, 0.76f);
    EXPECT_LT(level(music(), sampleOf((double)kFilm.endRow - 1), sampleOf((double)kFilm.endRow)), -70)
        << "the end is silent";
}
