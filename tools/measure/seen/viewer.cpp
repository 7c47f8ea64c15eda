#include "tools/measure/seen/viewer.h"

#include "tools/picture/psnr.h"

#include <algorithm>
#include <cmath>

namespace odraz::measure {

namespace {

constexpr int kScreenRate = 60;
constexpr long kTruePixels = 8 << 20; // of all truths that are kept, of 23 bytes each

// Whether two pictures of lists are traced alike.
bool same(const Shown &a, const Shown &b) {
    return a.time == b.time && a.level == b.level && a.width == b.width && a.height == b.height;
}

} // namespace

double Seen::linearPsnr() const { return std::min(kMostPsnr, pictures::psnr(linear, (size_t)sixtieths)); }
double Seen::srgbPsnr() const { return std::min(kMostPsnr, pictures::psnr(srgb, (size_t)sixtieths)); }

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
    : workers(oneSet()), film(inPairs(width, height), workers, needsHall(from, to)),
      mostTruths(std::max(1l, kTruePixels / width / height)) {}

// A traced picture, in a slot.
Picture Viewer::traced(int slot, const Shown &s) {
    Held &h = held[slot];
    if (!same(h.shown, s))
        h = {s, picture(*film.intro, slot, s.time, qualityOf(s.level), nullptr, {s.width, s.height})};
    return h.picture;
}

// A picture of the list, as the screen shows it.
Picture Viewer::made(const std::vector<Shown> &list, size_t i) {
    MadeFrom from = madeFrom(list, i);
    int slot = same(held[1].shown, from.earlier);
    Picture earlier = traced(slot, from.earlier);
    if (!list[i].between) return earlier;
    traced(!slot, from.later);
    double share = (list[i].time - from.earlier.time) / (from.later.time - from.earlier.time);
    return between(*film.intro, slot, !slot, share);
}

// Keeps the film's pictures from one sixtieth to another, at most mostTruths.
void Viewer::keepTruth(long from, long to) {
    for (long n = from; n < to; ++n) {
        if (truths.count(n)) continue;
        if ((long)truths.size() + to - n > mostTruths) truths.clear(), n = from;
        held[0] = {};
        Truth &truth = truths[n];
        truth.rgb =
            rgbOf(picture(*film.intro, 0, (double)n / kScreenRate, kQualities[(int)QualityName::Film]));
        truth.perceived = pictures::see(truth.rgb, film.intro->width, film.intro->height);
    }
}

void Viewer::look(const std::vector<Shown> &list, double begin, double end, Seen &seen, const Each &each) {
    int width = film.intro->width, height = film.intro->height;
    for (const Shown &s : list)
        if (s.width > width || s.height > height || (s.width < width && width > kMostEnlarged))
            throw common::Refused("pictures of " + std::to_string(s.width) + "x" + std::to_string(s.height) +
                                  " are not scaled to a screen of " + std::to_string(width) + "x" +
                                  std::to_string(height));
    std::vector<uint8_t> shown;
    pictures::SeenPicture perceived;
    int last = -1;
    // (0.1334 s are eight sixtieths)
    auto sixtieth = [](double seconds) { return std::lround(std::ceil(seconds * kScreenRate - 0.01)); };
    long first = sixtieth(begin), behind = sixtieth(end);
    for (long n = first; n < behind; ++n) {
        // In the middle of the sixtieth: a picture that came some milliseconds late counts
        double moment = (double)n / kScreenRate;
        int i = onScreenAt(list, moment + 0.5 / kScreenRate + 1e-6);
        if (i < 0) throw common::Refused("nothing was shown before " + std::to_string(moment) + " s");
        if ((n - first) % mostTruths == 0) keepTruth(n, std::min(n + mostTruths, behind));
        if (i != last) {
            shown = rgbOf(made(list, (size_t)i));
            perceived = pictures::see(shown, width, height);
            seen.fresh += last >= 0;
            last = i;
        }
        const auto &[truth, perceivedTruth] = truths.at(n);
        double linear = 0, srgb = 0;
        for (size_t k = 0; k < truth.size(); ++k) {
            double a = (pictures::linearOfSrgb(truth[k]) - pictures::linearOfSrgb(shown[k])) * 255,
                   b = truth[k] - shown[k];
            linear += a * a;
            srgb += b * b;
        }
        seen.linear += linear / (double)truth.size();
        seen.srgb += srgb / (double)truth.size();
        seen.flip += pictures::meanFlip(perceivedTruth, perceived);
        ++seen.sixtieths;
        if (each) each(shown, truth);
    }
}

} // namespace odraz::measure
