// Checks how the film's pictures change over time: the climax moves most, and light does not flicker.
#include "inside.h"
#include "tests/support/figure.h"
#include "tests/support/loaded_film.h"
#include "tests/support/sanitized.h"
#include "tools/common/statistics.h"
#include "tools/picture/psnr.h"

using namespace odraz;

constexpr int kRate = 15, kPixels = 160 * 90; // pictures a second, and their size
constexpr double kClimaxFrom = 56 * 2, kClimaxTo = 68 * 2, kBeforeFrom = 46 * 2; // seconds

struct Pictures {
    std::vector<double> light;   // mean linear luminance of each picture
    std::vector<double> changes; // mean difference of luma from the picture before, in levels of 255
};

static const Pictures &measured() {
    static const Pictures all = [] {
        Pictures p;
        std::vector<double> before;
        for (int n = 0; n < duration() * kRate; ++n) {
            Picture now = picture(smallFilm(), 0, (double)n / kRate, kQualities[(int)QualityName::Draft]);
            std::vector<double> luma;
            double light = 0, change = 0;
            for (int i = 0; i < kPixels; ++i) {
                const uint8_t *c = now.rgba + 4 * i;
                auto linear = [=](int k) { return pictures::linearOfSrgb(c[k]); };
                light += 0.2126 * linear(0) + 0.7152 * linear(1) + 0.0722 * linear(2);
                luma.push_back(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]);
                if (n) change += std::fabs(luma.back() - before[(size_t)i]);
            }
            p.light.push_back(light / (kPixels));
            p.changes.push_back(change / (kPixels));
            before = luma;
        }
        return p;
    }();
    return all;
}

static double medianChange(double from, double to) {
    auto begin = measured().changes.begin();
    return common::median(std::vector(begin + (long)(from * kRate) + 1, begin + (long)(to * kRate)));
}

// Returns how often the values rise or fall by a tenth or more, of a fiftieth of white at least.
static int swings(const double *values, int count) {
    int result = 0, direction = 0;
    double low = std::max(values[0], 0.02), high = low;
    for (int i = 1; i < count; ++i) {
        double v = std::max(values[i], 0.02);
        if (direction >= 0) high = std::max(high, v);
        if (direction <= 0) low = std::min(low, v);
        if (direction != -1 && v < high * 0.9) {
            ++result, direction = -1, low = v;
        } else if (direction != 1 && v > low * 1.1) {
            ++result, direction = 1, high = v;
        }
    }
    return result;
}

// What swings more often tires the eye; three flashes a second are the limit of WCAG 2.3.1.
FIGURES_TEST(Motion, LightRisesAndFallsAtMostThreeTimesASecond) {
    const std::vector<double> &light = measured().light;
    for (int n = 0; n + kRate < (int)light.size(); n += kRate / 5)
        EXPECT_LE(swings(&light[(size_t)n], kRate + 1), 3) << "from " << (double)n / kRate << " s";
}

FIGURES_TEST(Motion, TheClimaxMovesMost) {
    expectAtMost("ten bars before, share of it",
                 medianChange(kBeforeFrom, kClimaxFrom) / medianChange(kClimaxFrom, kClimaxTo), 1 / 1.5);
}
