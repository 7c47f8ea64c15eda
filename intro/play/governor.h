// Decides how well the next pictures are traced, and how many of them, from what the last ones took: so that
// any machine keeps up. Seconds throughout. It has no clock: the same times in, the same decisions out.
//
// Two things can give way. The quality moves between `film`, `play` and `draft`, a little with every picture,
// so that nobody sees a step. The way is what becomes of the sixty pictures a second that a screen shows:
//
//   kSixty    all are traced, where that can be done at `play` or better
//   kPairs    every other one is traced; the one between two of them is made of both, which is less work
//   kThirty   every other one is traced, and shown twice: where `draft` is too slow for pairs, and making
//             costs nearly what tracing does. It lasts until the next scene
//
// Where even that is too much, next() leaves pictures out.
#pragma once

#include "base/maths.h"
#include "intro.h"

namespace odraz {

struct Governor {
    enum Way { kSixty, kPairs, kThirty };

    // What a picture may take: 87 % of the time until the next one. The rest is for showing it, and for
    // pictures that take longer than those before them.
    static constexpr float kSixtyBudget = 0.0145f, kThirtyBudget = 0.029f;
    // Averages follow a new picture by a quarter: they are those of the last four or so, a seventh of a
    // second. Fewer would follow noise, more would see a costly scene too late.
    static constexpr float kFollow = 0.25f;
    // Tracing one picture counts as at most so many times the average, and making one as so many times
    // tracing: what takes longer is a hiccup, of the system or another program, and says nothing of the
    // pictures after it.
    static constexpr float kMostTracing = 4, kMostMaking = 1.5f;
    // How far the quality moves at a picture that takes twice its budget; from `play` to `draft` that is six
    // pictures. Better it becomes at half that speed at most: a picture that is late is seen, a coarse one
    // hardly.
    static constexpr float kMove = 0.16f, kMostBetter = -0.5f, kMostWorse = 1;
    // Not quite `film`, which takes more samples of textures: a step that would be seen.
    static constexpr float kBest = 0.1f;
    // Sixty are traced when a picture of at least `play` takes less than this, and as long as it is of `play`
    // or a little coarser. Between both lie 25 % of a picture's time, more than noise of 30 % leaves in an
    // average, so that it does not swing.
    static constexpr float kSixtyBelow = 0.0125f, kPlay = 1, kLittleCoarser = 1.25f;
    // None are made between when a pair at `draft` is so many times its budget, and so many times what
    // tracing alone takes
    static constexpr float kLate = 1.1f, kNearlyTwice = 1.8f;
    // What comes next may be so much late before pictures are left out for it.
    static constexpr double kTolerance = 0.004;
    static constexpr double kNotBegun = -1e9; // where the film stands before it begins: there is time for all

    static constexpr QualityName kRange[] = {QualityName::Film, QualityName::Play, QualityName::Draft};
    static constexpr int kSteps = sizeof kRange / sizeof *kRange - 1;

    Way way = kPairs;
    float level = kPlay;                                    // kBest .. kSteps along kRange
    float average = kThirtyBudget, tracing = kThirtyBudget; // that the last pictures took, and tracing alone
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

    // What the last picture took: to trace, and to make the one before it of its neighbours, or 0.
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

    // The time of the film to trace next, after the picture of `time`, when the film is at `now`: it must be
    // there when its time comes, and what is made from both, sooner.
    double next(double time, double now) const {
        double soonest = now + average + (pairs() ? 0.5 * step() : 0);
        time += step();
        return time < soonest - kTolerance ? soonest : time;
    }
};

} // namespace odraz
