// The governor decides how each picture of the film is traced, so that playback keeps up on any machine.
//
// Input: the scene's limits (Pace), and the seconds that tracing the last picture and making the in-betweens
// before it took. Output: the quality and size of the next traced picture, its time in the film, and the
// number of in-betweens before it. It reads no clock: the same input always gives the same decisions.
//
// Two quantities are controlled:
//
//   coarseness   How much detail a traced picture gives up: 0 is `film`, 1 `play`, 2 `draft`. Values between
//                them blend two qualities. Above 2 the quality stays `draft`, and fewer pixels are traced
//                and scaled up. It changes a little with every traced picture, so that no step is visible.
//   cadence      Which sixtieths of a second are traced, and how many in-betweens are made between two:
//
//                          traced         in-betweens   shown a second
//                kSixty    every one      0             60
//                kPairs    every second   1             60
//                kFours    every fourth   3             60
//                kSixes    every sixth    5             60
//                kThirty   every fourth   1             30
//
// Tracing fewer pictures leaves more time for each, but in-betweens are less exact than traced pictures,
// especially in fast scenes. So the governor estimates the error of every cadence: the error of the
// coarseness at which this machine keeps up, plus a penalty that the scene sets. The cadence with the least
// error wins. If even the coarsest pictures take too long, pictures are dropped.
#pragma once

#include "base/maths.h"
#include "intro.h"

namespace odraz {

// Without in-betweens (kBetweens = false) a cadence has only its traced pictures.
template <bool kBetweens> struct GovernorOf {
    static constexpr bool kMakesBetweens = kBetweens;
    enum Cadence { kSixty, kPairs, kFours, kSixes, kThirty };
    static constexpr int kGap[kCadences] = {1, 2, 4, 6, 4}; // sixtieths between two traced pictures
    static constexpr int kInBetweens[kCadences] = {0, kBetweens, 3 * kBetweens, 5 * kBetweens, kBetweens};
    static_assert(kInBetweens[kSixes] <= kBetweenBuffers);

    static constexpr QualityName kRange[] = {QualityName::Film, QualityName::Play, QualityName::Draft};
    static constexpr int kSteps = sizeof kRange / sizeof *kRange - 1; // the coarseness of `draft`
    static constexpr float kPlay = 1, kFinest = 0;

    // --- The budget, and the averages that are compared with it ---

    // The share of the time from one traced picture to the next that tracing it and making the in-betweens
    // before it may take. The rest is for showing them, and for pictures that take longer than the average.
    static constexpr float kShare = 0.87f;
    // The weight of a new time in its average. With a smaller weight, the average follows a costly scene too
    // late; with a larger one, it follows noise.
    static constexpr float kWeight = 0.25f;
    // A time counts as at most this many times the average: a longer one is a hiccup of the system.
    static constexpr float kMostTimes = 4;
    // While no in-betweens are made, the average of making one moves towards kGuess times the average of
    // tracing, the usual ratio. With each picture it moves by kForget of the difference, so that old times
    // are forgotten within a second.
    static constexpr float kForget = 0.03f, kGuess = 0.5f;

    // --- How coarseness moves ---

    // The excess of a picture is its time divided by its budget, minus 1. For each sixtieth of a second,
    // coarseness moves by kGain times the excess. The excess is limited to kMostExcess upwards (from `play`
    // to `draft` in a seventh of a second) and to kLeastExcess downwards, because viewers notice a late
    // picture more than a coarse one. Beyond kAlarm coarseness moves up by a whole step at once.
    static constexpr float kGain = 0.12f, kLeastExcess = -0.5f, kMostExcess = 1, kAlarm = 1.5f;
    // While fewer pixels are traced than shown, an excess within kDeadBand counts as 0, so that the size of
    // pictures does not oscillate.
    static constexpr float kDeadBand = 0.06f;

    // --- Fewer pixels ---

    // A step of coarseness gives up this share of the width. Tracing then takes about half the time.
    static constexpr float kShrink = 0.35f;
    static constexpr int kWidthStep = 16; // pixels; reduced widths are multiples of it
    // A reduction by less than this part of a step is not made, because scaling up blurs the whole picture.
    static constexpr float kLeastShrink = 0.06f;
    // All pixels are traced again only if there is time for this many times their cost, so that the size does
    // not oscillate.
    static constexpr float kAllPixelsCost = 1.05f;

    // --- How the cadence is chosen ---

    // With each step of coarseness the squared error grows by 2^kGrowth: 6.9 dB. In the mean over the scenes
    // it is 4 dB from `play` to `draft`, and more elsewhere. With less than 6.9 dB the cadence would swing.
    static constexpr float kGrowth = 2.3f;
    // The cadence changes once another one's error has been less than kMargin times its own for kWait
    // sixtieths of a second. After the first picture of a scene any lower error is enough, at once. Later
    // than kSettled sixtieths into a scene, each change multiplies the margin by kMargin again, so that the
    // cadence cannot oscillate.
    static constexpr float kMargin = 0.65f;
    static constexpr int kWait = 20, kSettled = 90;

    // --- Time ---

    // Pictures are dropped once the next one would be more than this late, in seconds.
    static constexpr double kTolerance = 0.004;
    static constexpr double kSixtieth = 1 / 60.0;
    static constexpr double kNotBegun = -1e9; // the film's time before it begins: no picture is late

    // --- State ---

    int width = 0, height = 0; // size of the pictures shown, in pixels; 0: all pixels are always traced
    Pace pace = {};            // limits of the scene

    Cadence cadence = kPairs;
    float coarseness = kPlay; // kFinest .. coarsest()
    // Average seconds to trace a picture and to make an in-between, scaled to the present coarseness
    float tracing = 0.05f, making = 0.02f;
    float weight = 1;     // weight of the next time in these averages: 1, 1/2, 1/3 after a cut, then kWeight
    int waited = kWait;   // sixtieths for which another cadence has been better
    float margin = 1;     // another cadence must have less than this share of the present one's error
    int played = 0;       // sixtieths of this scene
    bool reduced = false; // whether fewer pixels are traced than shown; coarseness is then at least `draft`
    int scene = -1;

    // Seconds of the film from one traced picture to the next.
    double step() const { return kSixtieth * kGap[cadence]; }
    // Seconds of work from one traced picture to the next.
    float work() const { return tracing + kInBetweens[cadence] * making; }
    // Seconds that this work may take in a cadence.
    float budget(int c) const { return kShare * (float)kSixtieth * (float)kGap[c]; }

    // The number of steps beyond `draft`, down to the scene's least width.
    float pixelSteps() const {
        return width ? max(1 - (float)pace.leastWidth / (float)width, 0.f) / kShrink : 0;
    }
    float coarsest() const { return kSteps + pixelSteps(); }
    // Whether the quality is `draft` already, but the size can still shrink.
    bool mustReduce() const { return coarseness >= kSteps && coarsest() > kSteps; }

    // --- Output: how to make the next pictures ---

    // The position of quality() on kRange: 0 `film`, 1 `play`, 2 `draft`.
    float level() const { return min(coarseness, (float)kSteps); }
    Quality quality() const {
        int from = min((int)level(), kSteps - 1);
        return blend(kQualities[(int)kRange[from]], kQualities[(int)kRange[from + 1]], level() - (float)from);
    }
    // The pixels to trace; 0 x 0 if the size does not vary.
    TracedSize size() const {
        float steps = coarseness - kSteps, shrunk = steps < kLeastShrink ? 0 : steps;
        int w = (int)((1 - kShrink * shrunk) * (float)width);
        if (w < width) w &= -kWidthStep;
        return {w, width ? (w * height + width / 2) / width : 0};
    }
    // The sixtieths from one picture to the next, in-betweens included.
    int spacing() const { return kGap[cadence] / (kInBetweens[cadence] + 1); }
    // The number of in-betweens for two traced pictures that are `gap` sixtieths apart. Before a cut the gap
    // may be shorter than planned. After a hiccup it is far longer, and there are none.
    int between(int gap) const {
        return gap > 2 * kGap[cadence] ? 0 : min(kInBetweens[cadence], (gap - 1) / spacing());
    }
    // Returns the film's time of the picture to trace next, in seconds. The last one had `time`, and the film
    // is at `now`. The picture and all in-betweens before it must be ready when they are due. If they cannot
    // be, whole sixtieths are dropped: a picture between two refreshes of the screen would only wait for the
    // second one. One of several `workers` takes `workers` times longer than all of them together.
    double next(double time, double now, int workers = 1) const {
        int count = kInBetweens[cadence];
        // Seconds by which the picture must be ahead of the film, so that its first in-between is in time,
        // and so that its last one is. Without in-betweens both are for the picture itself
        float first = tracing * (float)workers, last = work();
        float interval = (float)(spacing() * kSixtieth);
        if (count) first += making + (float)count * interval, last += interval;
        double soonest = now + max(first, last) - kTolerance;
        for (time += step(); time < soonest;) time += kSixtieth;
        return time;
    }

    // --- Input: the scene, and the times that pictures took ---

    // Prepares for a picture of this scene.
    void enter(int next, const Pace &nextPace) {
        if (scene == next) return;
        if (scene >= 0) tracing *= nextPace.cost / pace.cost;
        pace = nextPace;
        setCoarseness(clamp(scene < 0 ? coarseness : expected(cadence), min(coarseness, kPlay), coarsest()));
        reduced = mustReduce();
        weight = 1;
        waited = kWait;
        scene = next;
        played = 0;
        margin = 1;
    }

    // Takes into account that the last picture took `trace` seconds, and each of the `count` in-betweens
    // before it `make`.
    void spent(float trace, float make, int count) {
        auto follow = [&](float &average, float time) {
            average += (min(time, kMostTimes * average) - average) * weight;
        };
        follow(tracing, trace);
        if (count)
            follow(making, make);
        else
            making += (tracing * kGuess - making) * kForget;
        weight = max(weight / (1 + weight), kWeight);

        float excess = work() / budget(cadence) - 1;
        if (reduced) excess -= clamp(excess, -kDeadBand, kDeadBand);
        float move = clamp(excess, kLeastExcess, kMostExcess) * kGain * (float)kGap[cadence];
        if (excess > kAlarm && coarseness + 1 < coarsest()) move = 1;
        // Return to all pixels if there is time for them
        reduced &= coarseness > kSteps ||
                   tracing * kAllPixelsCost + (float)kInBetweens[cadence] * making > budget(cadence);
        setCoarseness(clamp(coarseness + move, reduced ? kSteps : kFinest, coarsest()));
        reduced |= mustReduce();

        choose();
        margin = min(margin, kMargin);
    }

    // --- Decisions ---

    // The coarseness at which a cadence would meet its budget on this machine.
    float expected(int c) const {
        float ratio = tracing / max(budget(c) - (float)kInBetweens[c] * making, 1e-4f);
        return max(coarseness + log2(ratio) * pace.halving, kFinest);
    }
    // The squared error of a cadence, in units of the error of `play`. Beyond coarsest(), where pictures
    // would be dropped, it grows twice as fast.
    float error(int c) const {
        float e = expected(c);
        return exp2((e - kPlay + max(e - coarsest(), 0.f)) * kGrowth) + pace.penalty[c];
    }
    // Changes to the cadence of the least error, once that has been clearly less for a while.
    void choose() {
        Cadence best = cadence;
        float least = error(cadence) * margin;
        for (int c = 0; c < kCadences; ++c) {
            float e = error(c);
            if (e < least) least = e, best = (Cadence)c;
        }
        played += kGap[cadence];
        waited = best == cadence ? 0 : waited + kGap[cadence];
        if (waited < kWait) return;
        if (played > kSettled) margin *= kMargin;
        cadence = best, waited = 0;
        if (!reduced) return;
        // The new cadence may have time for all pixels
        setCoarseness(clamp(expected(cadence), kFinest, coarsest()));
        reduced = mustReduce();
    }
    // Changes the coarseness, and scales the average time of tracing to it.
    void setCoarseness(float value) {
        tracing *= exp2((coarseness - value) / pace.halving);
        coarseness = value;
    }
};
using Governor = GovernorOf<true>;

} // namespace odraz
