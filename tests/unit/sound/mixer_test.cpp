// Tests the mixer: refused notes, stolen voices, silence, the compressor and seeking.
#include "sound/mixer.h"

#include "show/score.h"
#include "tests/support/sanitized.h"

#include <span>

using namespace odraz;

constexpr Instrument kString = {
    .partials = 8, .level = 0.01f, .tilt = 1, .decay = 20, .release = 2, .room = 0.5f};

static std::unique_ptr<Mixer> mixer(RowPlayer player) {
    auto m = std::make_unique<Mixer>();
    m->player = player;
    return m;
}

static void nothing(Mixer &, int) {}

// Plays a note on the first row.
static void once(Mixer &m, int row) {
    if (row == 0) playNote(m, {&kString, 60, 1, 1, 1});
}

// Plays a cluster that grows by 16 notes each row.
static void crowd(Mixer &m, int row) {
    for (int i = 0; i < kVoicesAtOnce; ++i)
        playNote(m, {&kString, (float)(30 + (row * kVoicesAtOnce + i) % 60), 1 - 0.01f * (float)i, 100, 1});
}

static std::vector<float> rendered(Mixer &m, int blocks) {
    std::vector<float> out((size_t)blocks * 2 * kBlock);
    for (int i = 0; i < blocks; ++i) renderBlock(m, &out[(size_t)i * 2 * kBlock]);
    return out;
}

// Counts the denormal numbers in a struct of floats.
template <class T> long denormals(const T &data) {
    const float *from = (const float *)&data, *to = (const float *)(&data + 1);
    return std::count_if(from, to, [](float v) { return std::fpclassify(v) == FP_SUBNORMAL; });
}

// Returns the largest absolute value of some samples.
static float largest(std::span<const float> samples) {
    float most = 0;
    for (float x : samples) most = std::max(most, std::fabs(x));
    return most;
}

TEST(Mixer, RefusesInvalidNotes) {
    float nan = std::nanf("");
    auto m = mixer(nothing);
    for (Note bad : {Note{&kString, nan, 1, 1, 1}, Note{&kString, 0, 1, 1, 1}, Note{&kString, 60, nan, 1, 1},
                     Note{&kString, 60, 1, 1, nan}, Note{&kString, 60, 0, 1, 1}, Note{&kString, 60, -1, 1, 1},
                     Note{&kString, 60, 1, 1, -1}})
        playNote(*m, bad);
    EXPECT_EQ(m->voiceCount, 0);
    // None of these can be heard
    for (Note mute :
         {Note{&kString, 60, 1, nan, 1}, Note{&kString, 140, 1, 1, 1}, Note{&kString, kInfinity, 1, 1, 1}})
        playNote(*m, mute);
    EXPECT_EQ(largest(rendered(*m, 50)), 0);
    EXPECT_EQ(m->voiceCount, 0);
    for (float key : {15.5f, 60.f, 135.f}) playNote(*m, {&kString, key, 1, 1, 1}); // 20 Hz to 19.9 kHz
    EXPECT_EQ(m->voiceCount, 3);
    EXPECT_LT(largest(rendered(*m, 50)), 0.2f);
}

TEST(Mixer, HoldsAllVoicesAndStealsTheQuietestWithoutAStep) {
    auto m = mixer(crowd);
    std::vector<float> out;
    int most = 0;
    for (int block = 0; block < 30 * kBlocksPerRow; ++block) {
        std::vector<float> stereo = rendered(*m, 1);
        out.insert(out.end(), stereo.begin(), stereo.end());
        most = std::max(most, m->voiceCount);
        ASSERT_LE(m->voiceCount, kVoices);
    }
    EXPECT_GT(most, kVoices - kVoicesAtOnce);
    // The notes of the last row sound, and there is room for the notes of the next
    EXPECT_EQ(m->voiceCount, kVoices - kVoicesAtOnce);
    // Clicks show as second differences: compare the largest while voices are stolen with the largest before
    double before = 0, after = 0;
    size_t full = (size_t)(kVoices / kVoicesAtOnce) * kBlocksPerRow * 2 * kBlock;
    for (size_t i = 4; i + 4 < out.size(); ++i) {
        double bend = std::fabs((double)out[i - 2] - 2 * (double)out[i] + (double)out[i + 2]);
        (i < full ? before : after) = std::max(i < full ? before : after, bend);
    }
    EXPECT_LT(after, before * 1.5);
}

TEST(Mixer, LeavesNoDenormalsAndRestoresTheirMode) {
    unsigned control = _mm_getcsr();
    auto m = mixer(once);
    std::vector<float> out = rendered(*m, 40 * 200);
    EXPECT_EQ(_mm_getcsr() & 0x8040, control & 0x8040);
    EXPECT_EQ(m->voiceCount, 0);
    EXPECT_EQ(denormals(m->reverb.lines), 0);
    EXPECT_EQ(denormals(m->reverb.low), 0);
    EXPECT_EQ(denormals(m->echo), 0);
    EXPECT_LT(largest({&out[out.size() - 1000], 1000}), 1e-9f);
}

TEST(Mixer, StaysWithinItsPeak) {
    static constexpr Instrument kLoudest = {.partials = 8, .level = 100, .decay = 20, .room = 1};
    auto m = mixer([](Mixer &m, int row) {
        if (row % 4 == 0) playNote(m, {&kLoudest, (float)(20 + row), 1, 0.4f, 1});
    });
    EXPECT_NEAR(largest(rendered(*m, 4000)), 0.68f, 1e-4f) << "-3.3 dB";
}

// A lasting sound that is 12 dB louder is 9 dB louder in the mix.
TEST(Mixer, CompressesLastingSounds) {
    auto dbOf = [](float level) {
        Instrument kind = {.level = level, .tilt = 9, .decay = 1000};
        auto m = mixer(nothing);
        playNote(*m, {&kind, 60, 1, 100, 0});
        rendered(*m, 1000);
        double power = 0;
        for (float x : rendered(*m, 200)) power += (double)x * (double)x;
        return 10 * std::log10(power);
    };
    EXPECT_NEAR(dbOf(0.4f) - dbOf(0.1f), 9, 0.5);
}

// Silence begins within 30 ms, is complete, and ends within 1 ms.
TEST(Mixer, IsSilentWhileMuted) {
    static constexpr Instrument kLasting = {.level = 0.2f, .tilt = 9, .decay = 1000, .room = 1, .echo = 1};
    auto m = mixer([](Mixer &m, int row) {
        if (row == 0) playNote(m, {&kLasting, 69, 1, 100, 1});
        m.muted = row == 8 || row == 9;
    });
    std::vector<float> before = rendered(*m, 8 * kBlocksPerRow), muted = rendered(*m, 2 * kBlocksPerRow),
                       after = rendered(*m, 1);
    EXPECT_EQ(largest(std::span(muted).subspan((size_t)(2 * 0.03 * kSampleRate))), 0);
    float most = largest(std::span(before).last(4800));
    EXPECT_GT(largest(after), 0.8f * most);
    EXPECT_LT(std::fabs(after[0]), 0.05f * most);
}

// After seeking, the same voices sound as after playing. Room and echo differ only by sound that has faded
// away.
TEST(Mixer, SeeksToTheSameSound) {
    for (int second : {3, 47, 121}) {
        if (kSanitized && second == 121) continue;
        auto played = mixer(playRow), sought = mixer(playRow);
        rendered(*played, second * 200);
        rendered(*sought, 100);
        seekBlock(*sought, second * 200);
        ASSERT_EQ(played->block, sought->block);
        ASSERT_EQ(played->voiceCount, sought->voiceCount);
        EXPECT_EQ(played->ducked, sought->ducked);
        for (int i = 0; i < played->voiceCount; ++i)
            EXPECT_EQ(std::memcmp(&played->voices[i].note, &sought->voices[i].note,
                                  offsetof(Note, left) + sizeof(float)),
                      0)
                << i;
        std::vector<float> a = rendered(*played, 100), b = rendered(*sought, 100);
        double error = 0, power = 0;
        for (size_t i = 0; i < a.size(); ++i) {
            error += ((double)a[i] - (double)b[i]) * ((double)a[i] - (double)b[i]);
            power += (double)a[i] * (double)a[i];
        }
        EXPECT_LT(error / power, 1e-5) << second;
    }
}

FIGURES_TEST(Mixer, HasVoicesEnoughForTheFilm) {
    auto m = mixer(playRow);
    int most = 0;
    for (int block = 0; block < 164 * 200; ++block) {
        rendered(*m, 1);
        most = std::max(most, m->voiceCount);
    }
    EXPECT_LE(most, kVoices - kVoicesAtOnce) << "nothing is stolen in the film";
}
