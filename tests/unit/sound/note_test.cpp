// Tests notes: they are in tune, have no aliases and no clicks, and do not depend on block boundaries.
#include "show/score.h"
#include "tests/support/figure.h"
#include "tests/support/voice.h"
#include "tools/support/recording.h"

using namespace odraz;
using namespace odraz::measure;

// Renders the left channel of a note, from its start.
static std::vector<double> render(const Instrument &kind, float key, double seconds, float velocity = 1,
                                  float length = 100) {
    std::vector<double> out;
    for (Float8 x : rendered(*begun({&kind, key, velocity, length, 0}), seconds))
        out.push_back((double)x[0] + (double)x[1] + (double)x[2] + (double)x[3]);
    return out;
}

// Returns how many cents a sound is off a frequency, from the drift of its phase between two times (in
// samples).
static double centsOff(const std::vector<double> &x, size_t from, size_t to, double hertz) {
    auto phaseAt = [&](size_t from) { // in turns
        constexpr size_t kSize = 16384;
        std::complex<double> sum = 0;
        for (size_t i = 0; i < kSize; ++i) {
            double window = 0.5 - 0.5 * std::cos(2 * M_PI * (double)i / kSize);
            sum +=
                x[from + i] * window * std::polar(1., -2 * M_PI * hertz * (double)(from + i) / kSampleRate);
        }
        return std::arg(sum) / (2 * M_PI);
    };
    double drift = std::remainder(phaseAt(to) - phaseAt(from), 1);
    return std::fabs(drift * kSampleRate / (double)(to - from) / hertz * 1200 / std::log(2));
}

constexpr Instrument kSine = {.partials = 4, .tilt = 60, .decay = 1000};

static double db(double ratio) { return 10 * std::log10(ratio + 1e-30); }

TEST(Note, IsInTuneOverEightOctaves) {
    double worst = 0;
    for (int key = 24; key <= 120; ++key) {
        double wanted = 440 * std::exp2((key - 69) / 12.);
        worst = std::max(worst, centsOff(render(kSine, (float)key, 2), 24000, 72000, wanted));
    }
    expectAtMost("largest error, cents", worst, 0.5);
}

TEST(Note, HasThePartialsOfItsInstrument) {
    Instrument bell = {.partials = 4, .stretch = 1.5f, .decay = 1000};
    std::vector<double> x = render(bell, 69, 1.5);
    for (int k = 1; k <= 4; ++k) EXPECT_LT(centsOff(x, 24000, 36000, 440 * std::pow(k, 1.5)), 0.5) << k;
    // Left and right are detuned symmetrically
    bell.detune = 0.001f;
    auto voice = begun({&bell, 69, 1, 1, 1});
    for (int lane = 0; lane < 4; ++lane)
        EXPECT_NEAR((double)voice->group[0].turn[lane] / (double)voice->group[0].turn[lane + 4],
                    1.001 / 0.999, 1e-6);
}

// Everything outside the partials (harmonics up to 20 kHz) is below -80 dB, under a window with lower
// sidelobes.
TEST(Note, DoesNotAlias) {
    Instrument full = {.partials = 32, .decay = 1000};
    for (float key : {57.f, 81.f, 93.f, 105.f, 117.f}) {
        double pitch = 440 * std::exp2(((double)key - 69) / 12);
        std::vector<double> x = render(full, key, 2);
        constexpr size_t kSize = 65536;
        std::vector<std::complex<double>> f(kSize);
        for (size_t i = 0; i < kSize; ++i) {
            double t = 2 * M_PI * (double)i / kSize; // Blackman-Harris: sidelobes at -92 dB
            f[i] = x[20000 + i] *
                   (0.35875 - 0.48829 * std::cos(t) + 0.14128 * std::cos(2 * t) - 0.01168 * std::cos(3 * t));
        }
        fourier(f);
        double own = 0, other = 0;
        for (size_t i = 0; i < kSize / 2; ++i) {
            double hertz = (double)i * kSampleRate / kSize, k = std::round(hertz / pitch);
            bool partial = k >= 1 && k <= 32 && k * pitch < kHighest && std::fabs(hertz - k * pitch) < 6;
            (partial ? own : other) = std::max(partial ? own : other, std::norm(f[i]));
        }
        expectAtMost("key " + testing::PrintToString(key) + ": aliases, dB", db(other / own), -80);
    }
}

// A drum, whose partials glide down, has no aliases either.
TEST(Note, BendsWithoutAliasing) {
    Instrument drum = {.partials = 32, .stretch = 1.4f, .decay = 1000, .bend = 2, .bendTime = 0.1f};
    std::vector<double> x = render(drum, 81, 1);
    std::vector<float> side(x.begin(), x.end());
    std::vector<double> power = spectrum({kSampleRate, {side, side}}, 960, 16384);
    size_t highest = (size_t)(kHighest + 1500) * 16384 / kSampleRate;
    double inside = std::accumulate(power.begin(), power.begin() + (long)highest, 0.),
           above = std::accumulate(power.begin() + (long)highest, power.end(), 0.);
    expectAtMost("above 21.5 kHz, dB", db(above / inside), -79);
}

// The frequency, measured between rising zeros, swings by the vibrato's amplitude, but hardly at the start.
TEST(Note, FadesInItsVibrato) {
    Instrument sung = kSine;
    sung.vibrato = 0.01f;
    std::vector<double> x = render(sung, 69, 3);
    double last = 0, most[2] = {}, least[2] = {1, 1};
    for (size_t i = 1; i < x.size(); ++i) {
        if (x[i - 1] >= 0 || x[i] < 0) continue;
        double zero = (double)i - x[i] / (x[i] - x[i - 1]), ratio = kSampleRate / (zero - last) / 440;
        bool begun = i > kSampleRate;
        if (last > 0 && (begun || i < kSampleRate / 20)) {
            most[begun] = std::max(most[begun], ratio);
            least[begun] = std::min(least[begun], ratio);
        }
        last = zero;
    }
    EXPECT_NEAR(most[1], 1.01, 5e-4);
    EXPECT_NEAR(least[1], 0.99, 5e-4);
    EXPECT_NEAR(most[0], 1, 1e-3);
    EXPECT_NEAR(least[0], 1, 1e-3);
}

TEST(Note, IsAFunctionOfTime) {
    for (const Instrument &kind : kInstruments) {
        if (kind.noise > 0) continue; // its filters have a state
        auto voice = begun({&kind, 57, 0.7f, 1, 1}, 1234);
        std::vector<Float8> all = rendered(*voice, 10. * kBlock / kSampleRate);
        Float8 one[kBlock] = {};
        renderVoice(*voice, 7 * kBlock, 1, 1, one);
        EXPECT_EQ(std::memcmp(one, &all[7 * kBlock], sizeof one), 0);
    }
}

// Blocks join without a click: the second difference is no larger there than elsewhere.
TEST(Note, JoinsItsBlocksWithoutAStep) {
    for (const Instrument &kind : kInstruments) {
        std::vector<double> x = render(kind, 50, 1.5, 1, 0.5f);
        double at = 0, elsewhere = 0;
        for (size_t i = 2 * kBlock; i + 1 < x.size(); ++i) {
            double bend = std::fabs(x[i - 1] - 2 * x[i] + x[i + 1]);
            (i % kBlock <= 1 ? at : elsewhere) = std::max(i % kBlock <= 1 ? at : elsewhere, bend);
        }
        EXPECT_LT(at, elsewhere * 1.2 + 1e-5) << &kind - kInstruments;
    }
}

TEST(Note, BeginsAndEndsInSilence) {
    for (const Instrument &kind : kInstruments) {
        std::vector<double> x = render(kind, 60, 6, 1, 1);
        EXPECT_LT(std::fabs(x[0]), 1e-6);
        EXPECT_EQ(x[(size_t)((1 + kind.release) * kSampleRate) + kBlock], 0);
    }
}

// The first 5 ms of a struck note are its loudest: its partials begin in phase and rise within a millisecond.
TEST(Note, IsLoudestAtItsStartIfStruck) {
    for (InstrumentId id : {kGlassDrop, kPiano, kWood, kPulse, kDrum, kBrush, kImpact}) {
        std::vector<double> x = render(kInstruments[id], 57, 0.2);
        double first = 0, later = 0;
        for (size_t i = 0; i < x.size(); ++i)
            (i < 240 ? first : later) = std::max(i < 240 ? first : later, std::fabs(x[i]));
        EXPECT_GT(first, 0.7 * later) << (int)id;
        EXPECT_LT(std::fabs(x[2]), 0.2 * first) << (int)id << ": no step";
    }
}

TEST(Note, StaysFiniteAtExtremes) {
    for (float key : {-20.f, 15.5f, 60.f, 135.f, 135.1f, 200.f})
        for (float level : {0.f, 1.f, 100.f}) {
            Instrument kind = {.partials = 32,
                               .level = level,
                               .stretch = 1.9f,
                               .scatter = 1,
                               .decay = 0.01f,
                               .damp = 2,
                               .bend = 3};
            for (double x : render(kind, key, 0.1)) {
                ASSERT_TRUE(std::isfinite(x)) << key;
                ASSERT_LE(std::fabs(x), (double)level * 32 * 1.2) << key;
            }
        }
}
