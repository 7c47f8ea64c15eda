#include "tools/measure/seen/viewer.h"

#include "tools/common/statistics.h"
#include "tools/measure/detect/flip.h"

#include <algorithm>
#include <cmath>

namespace odraz {

namespace {

constexpr int kScreenRate = 60;
std::vector<uint8_t> rgbOf(const Picture &p) {
    std::vector<uint8_t> rgb((size_t)p.width * (size_t)p.height * 3);
    for (size_t i = 0; i < rgb.size(); ++i) rgb[i] = p.rgba[i / 3 * 4 + i % 3];
    return rgb;
}

} // namespace

double Seen::linearPsnr() const { return std::min(kMostPsnr, psnr(linear, (size_t)sixtieths)); }
double Seen::srgbPsnr() const { return std::min(kMostPsnr, psnr(srgb, (size_t)sixtieths)); }

static IntroSettings inPairs(int width, int height) {
    IntroSettings settings = {width, height};
    settings.pairs = true;
    return settings;
}

// A process can start one set of threads only.
static const Workers &oneSet() {
    static const Workers workers = allProcessors();
    return workers;
}

Viewer::Viewer(int width, int height, double from, double to)
    : workers(oneSet()), theatre(inPairs(width, height), workers, from, to) {}

// A picture of the list, as it stands on the screen.
Picture Viewer::made(const std::vector<Shown> &list, int i) {
    auto traced = [&](int slot, const Shown &s) {
        return picture(*theatre.intro, slot, s.time, qualityOf(s.level), nullptr, {s.width, s.height});
    };
    if (!list[(size_t)i].between) return traced(0, list[(size_t)i]);
    traced(0, list[(size_t)i - 1]);
    traced(1, list[(size_t)i + 1]);
    return between(*theatre.intro, 0, 1);
}

void Viewer::look(const std::vector<Shown> &list, double begin, double end, Seen &seen) {
    int width = theatre.intro->width, height = theatre.intro->height;
    for (const Shown &s : list)
        if (s.width > width || s.height > height || (s.width < width && width > kMostEnlarged))
            throw Refused("pictures of " + std::to_string(s.width) + "x" + std::to_string(s.height) +
                          " are not scaled to a screen of " + std::to_string(width) + "x" +
                          std::to_string(height));
    std::vector<uint8_t> standing;
    SeenPicture perceived;
    int last = -1;
    for (long n = (long)std::ceil(begin * kScreenRate - 1e-6); (double)n < end * kScreenRate - 1e-6; ++n) {
        // What stands there in the middle of its sixtieth: a picture that took some milliseconds to come on
        // the screen has come, as on a screen that shows it a little later than it was given
        double moment = (double)n / kScreenRate;
        int i = standsAt(list, moment + 0.5 / kScreenRate + 1e-6);
        if (i < 0) throw Refused("nothing was shown before " + std::to_string(moment) + " s");
        if (i != last) {
            standing = rgbOf(made(list, i));
            perceived = see(standing, width, height);
            seen.fresh += last >= 0;
            last = i;
        }
        std::vector<uint8_t> truth =
            rgbOf(picture(*theatre.intro, 0, moment, kQualities[(int)QualityName::Film]));
        double linear = 0, srgb = 0;
        for (size_t k = 0; k < truth.size(); ++k) {
            double a = (linearOfSrgb(truth[k]) - linearOfSrgb(standing[k])) * 255, b = truth[k] - standing[k];
            linear += a * a;
            srgb += b * b;
        }
        seen.linear += linear / (double)truth.size();
        seen.srgb += srgb / (double)truth.size();
        seen.flip += odraz::meanFlip(see(truth, width, height), perceived);
        ++seen.sixtieths;
    }
}

} // namespace odraz
