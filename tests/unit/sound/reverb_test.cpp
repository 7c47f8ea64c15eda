// Tests that the room's sound decays as designed and is dense, and that the echo alternates sides.
#include "sound/reverb.h"

using namespace odraz;

// Returns the room's response to an impulse in one lane.
static std::vector<Float8> response(double seconds, int lane) {
    auto room = std::make_unique<Reverb>();
    std::vector<Float8> out;
    for (int block = 0; block < (int)(seconds * kSampleRate / kBlock); ++block) {
        Float8 in[kBlock] = {}, sum[kBlock] = {};
        if (block == 0) in[0][lane] = 1;
        renderReverb(*room, block, in, sum);
        out.insert(out.end(), sum, sum + kBlock);
    }
    return out;
}
// Returns that response summed over lanes of both channels.
static std::vector<double> impulse(double seconds) {
    std::vector<double> out;
    for (Float8 x : response(seconds, 2))
        out.push_back((double)x[0] - (double)x[1] + (double)x[2] + (double)x[5]);
    return out;
}

// Filters a band around a frequency, by a resonator applied four times.
static std::vector<double> band(std::vector<double> x, double hertz) {
    double r = 1 - M_PI * hertz / 3 / kSampleRate, c = 2 * r * std::cos(2 * M_PI * hertz / kSampleRate);
    for (int pass = 0; pass < 4; ++pass) {
        double a = 0, b = 0;
        for (double &v : x) {
            double y = v + c * a - r * r * b;
            b = a, a = y, v = y;
        }
    }
    return x;
}

// Returns the decay time for 60 dB in seconds, from the remaining energy between -5 and -35 dB. Schroeder,
// 1965.
static double decayTime(const std::vector<double> &x) {
    std::vector<double> rest(x.size() + 1);
    for (size_t i = x.size(); i-- > 0;) rest[i] = rest[i + 1] + x[i] * x[i];
    size_t a = 0, b = 0;
    while (rest[a] > rest[0] * std::pow(10, -0.5)) ++a;
    while (rest[b] > rest[0] * std::pow(10, -3.5)) ++b;
    return (double)(b - a) * 2 / kSampleRate;
}

// Returns the decay time at a frequency, kDecayHigh .. kDecay, for which a mean line's low-pass is designed.
static double designed(double hertz) {
    double length = 2650, log2gain = -9.96578 * length / kSampleRate / (double)kDecay,
           ratio = (double)(kDecay / kDecayHigh), pole = log2gain * 0.173287 * (1 - ratio * ratio),
           w = 2 * M_PI * hertz / kSampleRate,
           filter = (1 - pole) / std::sqrt(1 - 2 * pole * std::cos(w) + pole * pole);
    return -9.96578 * length / kSampleRate / (log2gain + std::log2(filter));
}

TEST(Reverb, DecaysAsDesigned) {
    std::vector<double> response = impulse(6);
    for (double hertz : {125., 250., 500., 1000., 2000., 4000.}) {
        double took = decayTime(band(response, hertz));
        EXPECT_NEAR(took / designed(hertz), 1, 0.15) << hertz;
    }
    // Interpolation between samples also damps high frequencies
    double high = decayTime(band(response, 12000));
    EXPECT_GT(high, 0.5 * (double)kDecayHigh);
    EXPECT_LT(high, designed(12000) * 1.1);
    EXPECT_NEAR(designed(1), (double)kDecay, 0.02);
}

TEST(Reverb, IsDenseAndOnBothSides) {
    for (int lane : {0, 5}) {
        std::vector<Float8> out = response(1, lane);
        double left = 0, right = 0;
        int loud = 0;
        for (size_t i = 51 * kBlock; i < out.size(); ++i) {
            for (int k = 0; k < 8; ++k) (k < 4 ? left : right) += (double)out[i][k] * (double)out[i][k];
            loud += i >= 120 * kBlock && std::fabs(out[i][0]) > 1e-7f;
        }
        EXPECT_NEAR(std::log2(left / right), 0, 0.6) << lane;
        EXPECT_GT(loud, 80 * kBlock / 2) << "half a second later single echoes cannot be heard";
    }
}

// The allpasses spread an impulse without a loss of energy.
TEST(Reverb, HasNoClicksAsFirstEchoes) {
    double most = 0, sum = 0;
    for (double x : impulse(0.1)) most = std::max(most, x * x), sum += x * x;
    EXPECT_LT(most, 0.1 * sum);
}

TEST(Echo, AlternatesSidesEveryThreeRows) {
    auto echo = std::make_unique<Echo>();
    for (int block = 0; block < 300; ++block) {
        Float8 in[kBlock] = {}, dry[kBlock] = {}, wet[kBlock] = {};
        if (block == 0) in[3][6] = 1;
        renderEcho(*echo, block, in, dry, wet);
        auto sum = [](Float8 x, int from) { return x[from] + x[from + 1] + x[from + 2] + x[from + 3]; };
        EXPECT_EQ(sum(dry[3], 0) > 0, block == Echo::kBlocks || block == 3 * Echo::kBlocks) << block;
        EXPECT_EQ(sum(dry[3], 4) > 0, block == 2 * Echo::kBlocks) << block;
        EXPECT_EQ(sum(wet[3], 0) > 0, sum(dry[3], 0) > 0) << block;
        EXPECT_EQ(sum(dry[4], 0), 0);
    }
    EXPECT_EQ(Echo::kBlocks * kBlock, kSampleRate * 3 / 8);
}
