#include "tools/measure/seen/viewer.h"

#include "tools/common/statistics.h"
#include "tools/measure/detect/flip.h"

#include <algorithm>
#include <cmath>

namespace odraz {

namespace {

constexpr int kScreenRate = 60;
constexpr int kTaps = 4;

// Where a line of `from` values is read, and with which weights, to have `to` of them.
struct Taps {
    int at[kTaps];
    float weight[kTaps];
};
std::vector<Taps> tapsOf(int from, int to) {
    std::vector<Taps> all((size_t)to);
    for (int i = 0; i < to; ++i) {
        double x = (i + 0.5) * from / to - 0.5, whole = std::floor(x), t = x - whole;
        double weights[] = {((-t + 2) * t - 1) * t / 2, ((3 * t - 5) * t * t + 2) / 2,
                            ((-3 * t + 4) * t + 1) * t / 2, (t - 1) * t * t / 2};
        for (int k = 0; k < kTaps; ++k) {
            all[(size_t)i].at[k] = std::clamp((int)whole + k - 1, 0, from - 1);
            all[(size_t)i].weight[k] = (float)weights[k];
        }
    }
    return all;
}

std::vector<uint8_t> rgbOf(const Picture &p) {
    std::vector<uint8_t> rgb((size_t)p.width * (size_t)p.height * 3);
    for (size_t i = 0; i < rgb.size(); ++i) rgb[i] = p.rgba[i / 3 * 4 + i % 3];
    return rgb;
}

} // namespace

std::vector<uint8_t> scaled(const std::vector<uint8_t> &rgb, int width, int height, int toWidth,
                            int toHeight) {
    if (width == toWidth && height == toHeight) return rgb;
    std::vector<Taps> across = tapsOf(width, toWidth), down = tapsOf(height, toHeight);
    std::vector<float> rows((size_t)height * (size_t)toWidth * 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < toWidth; ++x)
            for (int c = 0; c < 3; ++c) {
                float sum = 0;
                const Taps &t = across[(size_t)x];
                for (int k = 0; k < kTaps; ++k)
                    sum += t.weight[k] *
                           (float)rgb[((size_t)y * (size_t)width + (size_t)t.at[k]) * 3 + (size_t)c];
                rows[((size_t)y * (size_t)toWidth + (size_t)x) * 3 + (size_t)c] = sum;
            }
    size_t row = (size_t)toWidth * 3;
    std::vector<uint8_t> out((size_t)toHeight * row);
    for (int y = 0; y < toHeight; ++y)
        for (size_t x = 0; x < row; ++x) {
            float sum = 0;
            const Taps &t = down[(size_t)y];
            for (int k = 0; k < kTaps; ++k) sum += t.weight[k] * rows[(size_t)t.at[k] * row + x];
            out[(size_t)y * row + x] = (uint8_t)std::clamp(sum + 0.5f, 0.f, 255.f);
        }
    return out;
}

double Seen::linearPsnr() const { return std::min(kMostPsnr, psnr(linear, (size_t)sixtieths)); }
double Seen::srgbPsnr() const { return std::min(kMostPsnr, psnr(srgb, (size_t)sixtieths)); }

Viewer::Viewer(int width, int height, double from, double to)
    : width(width), height(height), from(from), to(to), workers(allProcessors()) {}

Intro &Viewer::of(int w, int h) {
    auto &theatre = theatres[{w, h}];
    if (!theatre) {
        IntroSettings settings = {w, h};
        settings.pairs = true;
        theatre = std::make_unique<Theatre>(settings, workers, from, to);
    }
    return *theatre->intro;
}

// A picture of the list, as large as the screen.
std::vector<uint8_t> Viewer::made(const std::vector<Shown> &list, int i) {
    const Shown &s = list[(size_t)i];
    Intro &intro = of(s.width, s.height);
    auto traced = [&](int slot, const Shown &t) { return picture(intro, slot, t.time, qualityOf(t.level)); };
    Picture p = {};
    if (s.between) {
        traced(0, list[(size_t)i - 1]);
        traced(1, list[(size_t)i + 1]);
        p = between(intro, 0, 1);
    } else
        p = traced(0, s);
    return scaled(rgbOf(p), s.width, s.height, width, height);
}

void Viewer::look(const std::vector<Shown> &list, double begin, double end, Seen &seen) {
    std::vector<uint8_t> standing;
    SeenPicture perceived;
    int last = -1;
    for (long n = (long)std::ceil(begin * kScreenRate - 1e-6); (double)n < end * kScreenRate - 1e-6; ++n) {
        // What stands there in the middle of its sixtieth: a picture that took some milliseconds to come on
        // the screen has come, as on a screen that shows it a little later than it was given
        double moment = (double)n / kScreenRate;
        int i = standsAt(list, moment + 0.5 / kScreenRate);
        if (i < 0) throw Refused("nothing was shown before " + std::to_string(moment) + " s");
        if (i != last) {
            standing = made(list, i);
            perceived = see(standing, width, height);
            seen.fresh += last >= 0;
            last = i;
        }
        std::vector<uint8_t> truth =
            rgbOf(picture(of(width, height), 0, moment, kQualities[(int)QualityName::Film]));
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
