// Measures the film's music: hits are on time and follow silence, every scene has noise, and nothing clips.
#include "tests/support/shots.h"
#include "tools/measure/detect/hits.h"

#include "show/score.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>

using namespace odraz;
using namespace odraz::measure;

namespace {

// The whole music, rendered once.
const Recording &music() {
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

int64_t sampleOf(double row) { return (int64_t)(row / kRowsPerSecond * kSampleRate); }

} // namespace

TEST(Music, HitsAreOnTime) {
    std::vector<int> rows = hitRows();
    int late = 0;
    for (int row : rows) {
        double rise = riseTime(music(), sampleOf(row));
        std::printf("row %d: %.1f ms\n", row, rise);
        late += rise > 10;
    }
    EXPECT_GE(rows.size(), 10u);
    EXPECT_EQ(late, 0);
}

// The half beat before the big hits is silent, after 30 ms in which the sound fades.
TEST(Music, IsSilentBeforeTheBigHits) {
    std::vector<int> rows = hitRows();
    for (EventId hit : kHits) {
        int row = firstRow(kEvents[hit].scene) + kEvents[hit].row;
        int64_t at = sampleOf(row);
        EXPECT_LT(level(music(), at - kSampleRate / 4 + kSampleRate * 3 / 100, at), -100) << hit;
        EXPECT_GT(level(music(), at - kSampleRate, at - kSampleRate / 4), -40)
            << hit << ": the music plays before it";
        EXPECT_GT(level(music(), at, at + kSampleRate / 20), -20) << hit;
        EXPECT_TRUE(std::count(rows.begin(), rows.end(), row)) << hit << ": a drum is struck";
    }
}

TEST(Music, HasNoiseInEveryScene) {
    for (const SceneSpan &span : sceneSpans()) {
        const char *name = kScenes[span.scene].name;
        double flat = flatness(music(), sampleOf(span.from), sampleOf(span.to));
        std::printf("%s: %.3f\n", name, flat);
        EXPECT_GT(flat, 0.05) << name;
    }
}

TEST(Music, NeitherClipsNorStops) {
    float most = 0;
    for (const std::vector<float> &side : music().side)
        for (float x : side) most = std::max(most, std::fabs(x));
    EXPECT_LT(most, 0.76f);
    EXPECT_LT(level(music(), sampleOf((double)kFilm.endRow - 1), sampleOf((double)kFilm.endRow)), -70)
        << "the end is silent";
    // No bar before the credits is silent
    for (int bar = 0; bar < firstRow(kCredits) / 16; ++bar)
        EXPECT_GT(level(music(), sampleOf(bar * 16), sampleOf(bar * 16 + 16)), -45) << bar;
}
