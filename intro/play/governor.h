// Decides how well the next pictures are traced, and how many of them, from the time that the last ones took,
// so that any machine keeps up. All times are in seconds. It has no clock of its own: the same times in, the
// same decisions out.
//
// It changes two things. The coarseness says how much each traced picture does without: first quality, from
// `film` over `play` down to `draft`; then pixels, which are scaled up. It changes a little with every
// picture, so that nobody sees a step. The way says which pictures are traced, and how many are made between
// two of them:
//
//   kSixty           all sixty of a second are traced
//   kPairs           every other one is traced, and one is made between two
//   kFours, kSixes   every fourth or sixth one is traced, and three or five are made between two
//   kThirty          every fourth one is traced, and one is made between two: thirty are shown
//
// The fewer are traced, the better each of them is, and the worse are those between, by how the scene moves.
// So choose() estimates the error of each way: that of the coarseness that it would have on this machine, by
// what tracing and making took, and what the scene loses by it (Pace in intro.h). If even the coarsest
// pictures take too long, next() leaves some out.
#pragma once

#include "base/maths.h"
#include "intro.h"

namespace odraz {

struct Governor {
    enum Way { kSixty, kPairs, kFours, kSixes, kThirty };
    static constexpr int kApart[kWays] = {1, 2, 4, 6, 4};   // sixtieths from one traced picture to the next
    static constexpr int kBetween[kWays] = {0, 1, 3, 5, 1}; // pictures made between two
    static_assert(kBetween[kSixes] <= kPlaces);

    // What a traced picture may take, with those made before it: a share of the time until the next one. The
    // rest is for showing them, and for pictures that take longer than those before them.
    static constexpr float kShare = 0.87f;
    // Each new picture counts a quarter in the averages: they are those of the last four or so. Fewer would
    // follow noise, more would see a costly scene too late.
    static constexpr float kFollow = 0.25f;
    // Tracing or making a picture counts as at most this many times the average. What takes longer is a
    // hiccup of the system or of another program, and says nothing about the pictures after it.
    static constexpr float kMost = 4;
    // Where none are made, what making one took is forgotten within a second, for what it mostly takes: this
    // share of tracing.
    static constexpr float kForget = 0.03f, kGuess = 0.5f;
    // How far the coarseness moves in a sixtieth of a second, where a picture takes twice its budget; from
    // `play` to `draft` that is a seventh of a second. It improves at half that speed at most: viewers notice
    // a late picture, but hardly a coarse one. At pictures that take kFarTooLong times their budget it moves
    // by a whole step.
    static constexpr float kMove = 0.12f, kMostBetter = -0.5f, kMostWorse = 1, kFarTooLong = 2.5f;
    // Not quite `film`, which takes more samples of textures: that step would be seen.
    static constexpr float kBest = 0.1f;
    static constexpr float kPlay = 1;
    // Squared error grows by 2 to this power in a step of coarseness: by 7.5 dB, the mean of the film's
    // scenes.
    static constexpr float kGrowth = 2.5f;
    // Another way is taken where its error is less than this share of that of now, for kWait sixtieths of a
    // second; at the first picture of a scene at once. Changes in the first kSettled sixtieths of a scene are
    // free; each later one makes the next harder, so the way cannot swing.
    static constexpr float kClearly = 0.65f;
    static constexpr int kWait = 20, kSettled = 90;
    // The next picture may be this late before pictures are left out for it.
    static constexpr double kTolerance = 0.004;
    static constexpr double kSixtieth = 1 / 60.0;
    static constexpr double kNotBegun = -1e9; // the film's time before it begins: no picture is late

    static constexpr QualityName kRange[] = {QualityName::Film, QualityName::Play, QualityName::Draft};
    static constexpr int kSteps = sizeof kRange / sizeof *kRange - 1;
    // The share of a picture's width that a step of coarseness takes: about half of the time.
    static constexpr float kShrink = 0.35f;
    // Pixels. Where fewer are traced than shown, quality stays as it is, and the coarseness does not move
    // while pictures take within kCalm of their budget, so that their size does not go to and fro. Scaling up
    // blurs all alike, so fewer than kLeastFewer steps are not worth it. Quality better than `draft` samples
    // within pixels and costs kCliff times as much: it is tried where there is time for that.
    static constexpr int kWidthStep = 16;
    static constexpr float kCalm = 0.06f, kLeastFewer = 0.06f, kCliff = 1.28f;

    int width = 0, height = 0; // of the pictures that are shown, where fewer pixels may be traced; else 0
    Pace pace = {};            // of the scene

    Way way = kPairs;
    float coarseness = kPlay; // kBest .. coarsest()
    // Averages of tracing a picture and of making one, at the coarseness of now
    float tracing = 0.05f, making = 0.02f;
    float weight = 1;   // that the next picture has in them
    int waited = kWait; // for how many sixtieths another way was better
    float clearly = 1;  // better, in this scene
    int played = 0;     // sixtieths of this scene
    bool fewer = false; // whether it is as coarse as `draft`, and pixels are traded
    int scene = -1;

    // From one traced picture to the next.
    double step() const { return kSixtieth * kApart[way]; }
    // What a traced picture takes of the time until the next one, with all that are made before it.
    float average() const { return tracing + kBetween[way] * making; }
    float budget(int w) const { return kShare * (float)kSixtieth * (float)kApart[w]; }
    // How far pixels may go, in steps of coarseness.
    float pixelSteps() const {
        return width ? max(1 - (float)pace.leastWidth / (float)width, 0.f) / kShrink : 0;
    }
    float coarsest() const { return kSteps + pixelSteps(); }
    float withoutPixels() const {
        float steps = coarseness - kSteps;
        return steps < kLeastFewer ? 0 : steps;
    }
    bool wantsFewer() const { return coarseness >= kSteps && coarsest() > kSteps; }
    // Along kRange.
    float level() const { return min(coarseness, (float)kSteps); }
    Quality quality() const {
        int from = min((int)level(), kSteps - 1);
        return blend(kQualities[(int)kRange[from]], kQualities[(int)kRange[from + 1]], level() - (float)from);
    }
    TracedSize size() const {
        int w = (int)((1 - kShrink * withoutPixels()) * (float)width);
        if (w < width) w &= -kWidthStep;
        return {w, width ? (w * height + width / 2) / width : 0};
    }

    // The coarseness that a way would have here.
    float expected(int w) const {
        float more = tracing / max(budget(w) - (float)kBetween[w] * making, 1e-4f);
        return max(coarseness + log2(more) * pace.halving, kBest);
    }
    // The squared error of a way, in units of that of `play`: it grows with that coarseness, and the scene
    // adds what it loses by the way. Beyond the coarsest, pictures are left out: that counts twice.
    float error(int w) const {
        float c = expected(w);
        return exp2((c - kPlay + max(c - coarsest(), 0.f)) * kGrowth) + pace.lost[w];
    }
    // Takes the best way, once it was clearly better for a while.
    void choose() {
        Way best = way;
        float least = error(way) * clearly;
        for (int w = 0; w < kWays; ++w) {
            float its = error(w);
            if (its < least) least = its, best = (Way)w;
        }
        played += kApart[way];
        waited = best == way ? 0 : waited + kApart[way];
        if (waited < kWait) return;
        if (played > kSettled) clearly *= kClearly;
        way = best, waited = 0;
        if (!fewer) return;
        // In this way there may be time for all pixels
        become(clamp(expected(way), kBest, coarsest()));
        fewer = wantsFewer();
    }
    void become(float coarser) {
        tracing *= exp2((coarseness - coarser) / pace.halving);
        coarseness = coarser;
    }

    // The picture to trace next is of this scene.
    void enter(int next, const Pace &itsPace) {
        if (scene == next) return;
        pace = itsPace;
        coarseness = min(coarseness, coarsest());
        fewer = wantsFewer();
        weight = 1;
        waited = kWait;
        scene = next;
        played = 0;
        clearly = 1;
    }

    // The times that the last picture took: to trace it, and to make each of `count` pictures before it.
    void spent(float trace, float make, int count) {
        auto follow = [&](float &average, float time) {
            average += (min(time, kMost * average) - average) * weight;
        };
        follow(tracing, trace);
        if (count)
            follow(making, make);
        else
            making += (tracing * kGuess - making) * kForget;
        weight = max(weight / (1 + weight), kFollow);
        float off = average() / budget(way) - 1;
        if (fewer) off -= clamp(off, -kCalm, kCalm);
        float move = clamp(off, kMostBetter, kMostWorse) * kMove * (float)kApart[way];
        if (off > kFarTooLong - 1 && coarseness + 1 < coarsest()) move = 1;
        fewer &= coarseness > kSteps || tracing * kCliff + (float)kBetween[way] * making > budget(way);
        become(clamp(coarseness + move, fewer ? kSteps : kBest, coarsest()));
        fewer |= wantsFewer();
        choose();
        clearly = min(clearly, kClearly);
    }

    // How many pictures are made between two that are `gap` sixtieths apart: none after a hiccup.
    int between(int gap) const { return gap > 2 * kApart[way] ? 0 : kBetween[way]; }
    // The sixtieths from the i-th of them to the traced one behind them.
    int ahead(int i) const { return (kBetween[way] + 1 - i) * kApart[way] / (kBetween[way] + 1); }

    // The film's time of the picture to trace next, after the picture of `time`, when the film is at `now`.
    // All that are made between the two must be ready when their time comes. Pictures that are left out leave
    // whole sixtieths out: else all later ones would come between those of the screen, and wait there for the
    // next.
    double next(double time, double now) const {
        int count = kBetween[way];
        float first = tracing, last = average();
        if (count) first += making + (float)(ahead(1) * kSixtieth), last += (float)(ahead(count) * kSixtieth);
        double soonest = now + max(first, last) - kTolerance;
        for (time += step(); time < soonest;) time += kSixtieth;
        return time;
    }
};

} // namespace odraz
