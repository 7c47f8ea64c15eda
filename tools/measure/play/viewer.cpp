#include "tools/measure/play/viewer.h"

#include "tools/picture/psnr.h"

#include <algorithm>
#include <cmath>

namespace odraz::measure {

namespace {

constexpr int kScreenRate = 60;
constexpr long kTruePixels = 24 << 20; // most kept: a pixel takes 3 bytes, and 20 more where FLIP is computed
// FLIP takes longer than all else, so it is computed in every fifth sixtieth: 5 has no divisor in
// common with the gaps of in-betweens. It is the third one of a window.
constexpr long kFlipStep = 5, kFlipFirst = 2;

// Returns whether two pictures are traced alike.
bool same(const ShownPicture &a, const ShownPicture &b) {
    return a.time == b.time && a.level == b.level && a.width == b.width && a.height == b.height;
}

} // namespace

double SeenErrors::srgbPsnr() const { return std::min(kMostPsnr, pictures::psnr(srgb, (size_t)sixtieths)); }

static IntroSettings inPairs(int width, int height) {
    IntroSettings settings = {width, height};
    settings.pairs = true;
    return settings;
}

Viewer::Viewer(int width, int height, double from, double to)
    : workers(allProcessors()), film(inPairs(width, height), workers, needsHall(from, to)),
      mostTruths(std::max(1l, kTruePixels / width / height)) {}

// Traces a picture in a slot, unless the slot has it.
Picture Viewer::traced(int slot, const ShownPicture &s) {
    TracedSlot &at = slots[slot];
    if (!same(at.shown, s))
        at = {s, picture(*film.intro, slot, s.time, qualityOf(s.level), nullptr, {s.width, s.height})};
    return at.picture;
}

// Makes a picture of the list as the screen shows it.
Picture Viewer::made(const std::vector<ShownPicture> &list, size_t i) {
    MadeFrom from = madeFrom(list, i);
    int slot = same(slots[1].shown, from.earlier);
    Picture earlier = traced(slot, from.earlier);
    if (!list[i].between) return earlier;
    traced(!slot, from.later);
    double share = (list[i].time - from.earlier.time) / (from.later.time - from.earlier.time);
    return between(*film.intro, slot, !slot, share);
}

// Traces and keeps the film's pictures from one sixtieth to another. Keeps at most mostTruths pictures.
void Viewer::keepTruth(long from, long to) {
    for (long n = from; n < to; ++n) {
        if (truths.count(n)) continue;
        if ((long)truths.size() + to - n > mostTruths) truths.clear(), n = from;
        slots[0] = {};
        Truth &truth = truths[n];
        truth.rgb =
            rgbOf(picture(*film.intro, 0, (double)n / kScreenRate, kQualities[(int)QualityName::Film]));
    }
}

void Viewer::compare(const std::vector<ShownPicture> &list, double begin, double end, SeenErrors &errors,
                     const Each &each) {
    int width = film.intro->width, height = film.intro->height;
    for (const ShownPicture &s : list)
        if (s.width > width || s.height > height || (s.width < width && width > kMostEnlarged))
            throw common::Refused("cannot scale a picture of " + std::to_string(s.width) + "x" +
                                  std::to_string(s.height) + " to a screen of " + std::to_string(width) +
                                  "x" + std::to_string(height));
    std::vector<uint8_t> shown;
    int onScreen = -1; // index of the picture
    // Times may be rounded: 0.1334 s are eight sixtieths
    auto sixtieth = [](double seconds) { return std::lround(std::ceil(seconds * kScreenRate - 0.01)); };
    long first = sixtieth(begin), last = sixtieth(end);
    for (long n = first; n < last; ++n) {
        // Compare in the middle of the sixtieth, so that a picture may come some milliseconds late
        double moment = (double)n / kScreenRate;
        int i = onScreenAt(list, moment + 0.5 / kScreenRate + 1e-6);
        if (i < 0) throw common::Refused("the list shows nothing up to " + std::to_string(moment) + " s");
        if ((n - first) % mostTruths == 0) keepTruth(n, std::min(n + mostTruths, last));
        if (i != onScreen) {
            shown = rgbOf(made(list, (size_t)i));
            errors.fresh += onScreen >= 0;
            onScreen = i;
        }
        Truth &kept = truths.at(n);
        const std::vector<uint8_t> &truth = kept.rgb;
        errors.srgb += pictures::squares(truth, shown) / (double)truth.size();
        if ((n - first) % kFlipStep == std::min(kFlipFirst, last - first - 1)) {
            if (kept.perceived.lightness.empty()) kept.perceived = pictures::see(truth, width, height);
            errors.flip += pictures::meanFlip(kept.perceived, pictures::see(shown, width, height));
            ++errors.flips;
        }
        ++errors.sixtieths;
        if (each) each(shown, truth);
    }
}

} // namespace odraz::measure
