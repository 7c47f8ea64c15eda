// Decides how well the next pictures are traced, and how many of them, from the time that the last ones took,
// so that any machine keeps up. All times are in seconds. It has no clock of its own: the same times in, the
// same decisions out.
//
// It changes two things. The coarseness tells how much each traced picture does without: first quality, from
// `film` over `play` down to a level at which the scene would rather do without pixels; then pixels, which
// are scaled up; then the rest of quality, down to `draft`. It changes a little with every picture, so that
// nobody sees a step. The way tells how the sixty pictures a second that a screen shows are made:
//
//   kSixty    all are traced, if that can be done at `play` or better
//   kPairs    every other one is traced; the in-between of two of them is made from both, which is less work
//   kThirty   thirty are shown, and every other one of these is traced: where the scene would rather do
//             without half of its pictures than be coarser; and where pairs are too slow, as making one
//             takes as long as tracing it
//
// If even that is too much, next() leaves pictures out.
#pragma once

#include "base/maths.h"
#include "intro.h"

namespace odraz {

struct Governor {
    enum Way { kSixty, kPairs, kThirty };

    // What a traced picture may take, with its in-between: 87 % of the time until the next one. The rest is
    // for showing it, and for pictures that take longer than those before them.
    static constexpr float kBudget[] = {0.0145f, 0.029f, 0.058f}; // by way
    // Each new picture counts a quarter in the averages: they are those of the last four or so, a seventh of
    // a second. Fewer would follow noise, more would see a costly scene too late.
    static constexpr float kFollow = 0.25f;
    // Tracing one picture counts as at most so many times the average, and making one as so many times
    // tracing. What takes longer is a hiccup of the system or of another program, and tells nothing about the
    // pictures after it.
    static constexpr float kMostTracing = 4, kMostMaking = 1.5f;
    // How far the coarseness moves at a picture that takes twice its budget; from `play` to `draft` that is
    // six pictures. It improves at half that speed at most: viewers notice a late picture, but hardly a
    // coarse one. At pictures that take kFarTooLong times their budget it moves by a whole step, which is
    // expected to halve their time.
    static constexpr float kMove = 0.16f, kMostBetter = -0.5f, kMostWorse = 1, kFarTooLong = 2.5f;
    // Not quite `film`, which takes more samples of textures: that step would be seen.
    static constexpr float kBest = 0.1f;
    // All sixty are traced once a picture of at least `play` takes less than kSixtyBelow, and for as long as
    // the coarseness stays at `play` or a little above. The gap between these two conditions is 25 % of a
    // picture's time. That is more than noise of 30 % leaves in an average, so the way does not swing.
    static constexpr float kSixtyBelow = 0.0125f, kPlay = 1, kLittleCoarser = 1.25f;
    // Pairs are too slow once one at the coarsest takes kLate times its budget and kNearlyTwice times what
    // tracing alone takes.
    static constexpr float kLate = 1.1f, kNearlyTwice = 1.8f;
    // Sixty are shown again once thirty are so much better than where they began, or once the best thirty
    // take less than half of their time. Sooner, sixty would soon be too coarse, and the ways would swing.
    static constexpr float kBack = 1.6f, kHalf = 0.5f;
    // The next picture may be so much late before pictures are left out for it.
    static constexpr double kTolerance = 0.004;
    static constexpr double kSixtieth = 1 / 60.0;
    static constexpr double kNotBegun = -1e9; // the film's time before it begins: no picture is late

    static constexpr QualityName kRange[] = {QualityName::Film, QualityName::Play, QualityName::Draft};
    static constexpr int kSteps = sizeof kRange / sizeof *kRange - 1;
    // The share of a picture's width that a step of coarseness takes: about half of the time, as a step of
    // quality does.
    static constexpr float kShrink = 0.35f;
    // Pixels. Where fewer are traced than shown, quality stays as it is, and the coarseness does not move
    // while pictures take within kCalm of their budget, so that their size does not go to and fro. Better
    // quality is tried where all are traced in so much of the budget: the best of `draft` and the worst above
    // it are up to 19 % apart, since only the latter samples within pixels.
    static constexpr int kWidthStep = 16;
    static constexpr float kCalm = 0.06f, kSpare = 0.78f;

    int width = 0, height = 0; // of the pictures that are shown, where fewer pixels may be traced; else 0
    Pace pace = {};            // of the scene

    Way way = kPairs;
    float coarseness = kPlay; // kBest .. coarsest()
    // Of the last pictures, and of tracing them alone
    float average = kBudget[kPairs], tracing = kBudget[kPairs];
    bool fewer = false; // whether fewer pixels are traced, if it should be coarser than pace.pixels
    int scene = -1;

    bool pairs() const { return way != kSixty; }
    // From one traced picture to the next.
    double step() const { return kSixtieth * (1 << way); }
    // How far pixels may go, in steps of coarseness.
    float pixelSteps() const {
        return width ? max(1 - (float)pace.leastWidth / (float)width, 0.f) / kShrink : 0;
    }
    float coarsest() const { return kSteps + (pace.pixels <= kSteps ? pixelSteps() : 0); }
    float withoutPixels() const { return fewer ? min(coarseness - pace.pixels, pixelSteps()) : 0; }
    // Along kRange.
    float level() const { return coarseness - withoutPixels(); }
    Quality quality() const {
        int from = min((int)level(), kSteps - 1);
        return blend(kQualities[(int)kRange[from]], kQualities[(int)kRange[from + 1]], level() - (float)from);
    }
    TracedSize size() const {
        int w = (int)((1 - kShrink * withoutPixels()) * (float)width);
        if (w < width) w &= -kWidthStep;
        return {w, width ? (w * height + width / 2) / width : 0};
    }

    // The picture to trace next is of this scene.
    void enter(int next, const Pace &itsPace) {
        if (scene == next) return;
        scene = next;
        pace = itsPace;
        coarseness = min(coarseness, coarsest());
        if (way == kThirty) way = kPairs, average = tracing;
        if (way == kPairs && coarseness > pace.thirty) way = kThirty;
        fewer = coarseness >= pace.pixels;
    }

    // The times that the last picture took: to trace it, and to make the in-between before it, or 0.
    void spent(float trace, float make) {
        float budget = kBudget[way];
        trace = min(trace, kMostTracing * tracing);
        make = min(make, kMostMaking * tracing);
        tracing += (trace - tracing) * kFollow;
        average += (trace + make - average) * kFollow;
        float off = average / budget - 1;
        if (fewer) off -= clamp(off, -kCalm, kCalm);
        float move = clamp(off, kMostBetter, kMostWorse) * kMove;
        if (average > kFarTooLong * budget && coarseness + 1 < coarsest())
            move = 1, average *= 0.5f, tracing *= 0.5f;
        if (fewer && coarseness <= pace.pixels && average < kSpare * budget) fewer = false;
        coarseness = clamp(coarseness + move, fewer ? pace.pixels : kBest, coarsest());
        fewer |= coarseness >= pace.pixels;
        Way next = way;
        if (way == kSixty) {
            if (coarseness > kLittleCoarser) next = kPairs;
        } else if (way == kThirty) {
            if (coarseness < pace.thirty - kBack || (coarseness == kBest && average < kHalf * budget))
                next = kPairs, coarseness = pace.thirty, average *= 0.5f;
        } else if (coarseness <= kPlay && tracing < kSixtyBelow)
            next = kSixty;
        else if (coarseness > pace.thirty)
            next = kThirty;
        else if (coarseness == coarsest() && average > kLate * budget && average > kNearlyTwice * tracing)
            next = kThirty, pace.thirty = 0; // until the next scene
        if (next != way) average = next == kSixty ? tracing : average, way = next;
    }

    // The film's time of the picture to trace next, after the picture of `time`, when the film is at `now`.
    // The picture must be ready when its time comes; in pairs it must be ready earlier, as the in-between is
    // made from it. Pictures that are left out leave whole sixtieths out: else all later ones would come
    // between those of the screen, and wait there for the next.
    double next(double time, double now) const {
        double soonest = now + average + (pairs() ? 0.5 * step() : 0) - kTolerance;
        for (time += step(); time < soonest;) time += kSixtieth;
        return time;
    }
};

} // namespace odraz
