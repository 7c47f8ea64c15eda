// Decides how well the next pictures are traced, and how many of them, from the time that the last ones took,
// so that any machine keeps up. All times are in seconds. It has no clock of its own: the same times in, the
// same decisions out.
//
// It changes two things. The quality moves between `film`, `play` and `draft`, a little with every picture,
// so that nobody sees a step. The way tells how the sixty pictures a second that a screen shows are made:
//
//   kSixty    all are traced, if that can be done at `play` or better
//   kPairs    every other one is traced; the in-between of two of them is made from both, which is less work
//   kThirty   every other one is traced, and shown twice: if `draft` is too slow for pairs, and making one
//             costs nearly as much as tracing it. This lasts until the next scene
//
// If even that is too much, next() leaves pictures out.
#pragma once

#include "base/maths.h"
#include "intro.h"

namespace odraz {

struct Governor {
    enum Way { kSixty, kPairs, kThirty };

    // What a picture may take: 87 % of the time until the next one. The rest is for showing it, and for
    // pictures that take longer than those before them.
    static constexpr float kSixtyBudget = 0.0145f, kThirtyBudget = 0.029f;
    // Each new picture counts a quarter in the averages: they are those of the last four or so, a seventh of
    // a second. Fewer would follow noise, more would see a costly scene too late.
    static constexpr float kFollow = 0.25f;
    // Tracing one picture counts as at most so many times the average, and making one as so many times
    // tracing. What takes longer is a hiccup of the system or of another program, and tells nothing about the
    // pictures after it.
    static constexpr float kMostTracing = 4, kMostMaking = 1.5f;
    // How far the quality moves at a picture that takes twice its budget; from `play` to `draft` that is six
    // pictures. It improves at half that speed at most: viewers notice a late picture, but hardly a coarse
    // one.
    static constexpr float kMove = 0.16f, kMostBetter = -0.5f, kMostWorse = 1;
    // Not quite `film`, which takes more samples of textures: that step would be seen.
    static constexpr float kBest = 0.1f;
    // All sixty are traced once a picture of at least `play` takes less than kSixtyBelow, and for as long as
    // the quality stays at `play` or a little coarser. The gap between these two conditions is 25 % of a
    // picture's time. That is more than noise of 30 % leaves in an average, so the way does not swing.
    static constexpr float kSixtyBelow = 0.0125f, kPlay = 1, kLittleCoarser = 1.25f;
    // No in-betweens are made once a pair at `draft` takes kLate times its budget and kNearlyTwice times what
    // tracing alone takes
    static constexpr float kLate = 1.1f, kNearlyTwice = 1.8f;
    // The next picture may be so much late before pictures are left out for it.
    static constexpr double kTolerance = 0.004;
    static constexpr double kNotBegun = -1e9; // the film's time before it begins: no picture is late

    static constexpr QualityName kRange[] = {QualityName::Film, QualityName::Play, QualityName::Draft};
    static constexpr int kSteps = sizeof kRange / sizeof *kRange - 1;

    Way way = kPairs;
    float level = kPlay;                                    // kBest .. kSteps along kRange
    float average = kThirtyBudget, tracing = kThirtyBudget; // of the last pictures, and of tracing them alone
    int scene = -1;

    bool pairs() const { return way == kPairs; }
    // From one traced picture to the next.
    double step() const { return way == kSixty ? 1 / 60.0 : 1 / 30.0; }
    Quality quality() const {
        int from = min((int)level, kSteps - 1);
        return blend(kQualities[(int)kRange[from]], kQualities[(int)kRange[from + 1]], level - (float)from);
    }

    // The picture that was traced last is of this scene.
    void enter(int next) {
        if (scene != next && way == kThirty) way = kPairs;
        scene = next;
    }

    // The times that the last picture took: to trace it, and to make the in-between before it, or 0.
    void spent(float trace, float make) {
        float budget = way == kSixty ? kSixtyBudget : kThirtyBudget;
        trace = min(trace, kMostTracing * tracing);
        make = min(make, kMostMaking * tracing);
        tracing += (trace - tracing) * kFollow;
        average += (trace + make - average) * kFollow;
        level =
            clamp(level + clamp(average / budget - 1, kMostBetter, kMostWorse) * kMove, kBest, (float)kSteps);
        bool late =
            pairs() && level == kSteps && average > kLate * budget && average > kNearlyTwice * tracing;
        if (pairs() ? level <= kPlay && tracing < kSixtyBelow : way == kSixty && level > kLittleCoarser) {
            way = pairs() ? kSixty : kPairs;
            average = tracing;
        } else if (late) {
            way = kThirty;
            average = tracing;
        }
    }

    // The film's time of the picture to trace next, after the picture of `time`, when the film is at `now`.
    // The picture must be ready when its time comes; in pairs it must be ready earlier, as the in-between is
    // made from it.
    double next(double time, double now) const {
        double soonest = now + average + (pairs() ? 0.5 * step() : 0);
        time += step();
        return time < soonest - kTolerance ? soonest : time;
    }
};

} // namespace odraz
