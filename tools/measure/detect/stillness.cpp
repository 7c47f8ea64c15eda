// stillness: where the film stands still, and how often it cuts.
#include "show/show.h"
#include "tools/measure/detect/screening.h"
#include "tools/measure/detect/still.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace odraz::measure {

namespace {

struct Options : ScreeningOptions {
    double fps = 25, below = 2;
    int hold = 4, aside = 4;
    bool list = false;
};

bool fades(int second) {
    for (int row = 0; row <= (int)kRowsPerSecond; ++row)
        if (momentAt(kFilm, second * kRowsPerSecond + row).fade < 1) return true;
    return false;
}

// The mean of a second's pictures.
std::vector<double> meanOf(Screening &screening, int second, const Options &o) {
    std::vector<double> mean;
    int count = (int)std::lround(o.fps);
    for (int i = 0; i < count; ++i) {
        std::vector<float> levels = screening.shown(second + i / o.fps, o.chosen());
        mean.resize(levels.size());
        for (size_t k = 0; k < levels.size(); ++k) mean[k] += (double)levels[k] / count;
    }
    return mean;
}

std::vector<double> changesOf(const Options &o) {
    Screening screening(o.size, 0, duration());
    std::vector<double> changes, before;
    for (int second = 0; second < (int)duration() - o.aside; ++second) {
        std::vector<double> now;
        if (!fades(second)) now = meanOf(screening, second, o);
        double change = std::numeric_limits<double>::quiet_NaN();
        if (!now.empty() && !before.empty()) {
            change = 0;
            for (size_t k = 0; k < now.size(); ++k)
                change += std::fabs(now[k] - before[k]) / (double)now.size();
        }
        if (second) changes.push_back(change);
        before = std::move(now);
    }
    return changes;
}

int run(common::CommandLine &line) {
    Options o;
    o.size = {320, 180}, o.quality = QualityName::Draft;
    line.about(
        "Prints a CSV of the film's scenes: the cuts that begin or interrupt each, and the seconds for which "
        "it "
        "stands\n"
        "still. These are the pieces of --hold seconds or more in which the mean picture of a second differs "
        "by\n"
        "less than --below levels from the next second's, on average. Pictures are without grain. Seconds "
        "that\n"
        "fade are left out.");
    o.addTo(line);
    line.option("--fps", "N", o.fps, {1, 100}, "pictures a second");
    line.option("--hold", "S", o.hold, {2, 100}, "the shortest piece");
    line.option("--below", "LEVELS", o.below, {0, 255}, "the most change, of 255");
    line.option("--aside", "S", o.aside, {0, duration()}, "seconds at the end that are left out");
    line.flag("--list", o.list, "print each second with the change to the next one (nan: left out)");
    line.parse();
    std::vector<double> changes = changesOf(o);
    if (o.list) {
        std::puts("second,scene,change");
        for (size_t i = 0; i < changes.size(); ++i)
            std::printf("%d,%s,%.2f\n", (int)i, sceneName(sceneAt((double)i)), changes[i]);
        return 0;
    }
    std::puts("scene,seconds,cuts,cuts_a_minute,still_seconds,longest");
    auto print = [&](const char *name, double seconds, int cuts, int still, int longest) {
        std::printf("%s,%.0f,%d,%.1f,%d,%d\n", name, seconds, cuts, 60 * cuts / seconds, still, longest);
    };
    std::vector<Piece> pieces = stillPieces(changes, o.hold, o.below);
    int allCuts = 0, allStill = 0, longestOfAll = 0;
    for (int scene = 0; scene < kSceneCount; ++scene) {
        double seconds = 0;
        int cuts = 0, still = 0, longest = 0;
        for (const Span &shot : shots())
            if (shot.scene == scene) seconds += shot.to - shot.from, cuts += shot.from > 0;
        for (const Piece &p : pieces) {
            if (sceneAt(p.from) != scene) continue;
            still += p.to - p.from, longest = std::max(longest, p.to - p.from);
        }
        print(kScenes[scene].name, seconds, cuts, still, longest);
        allCuts += cuts, allStill += still, longestOfAll = std::max(longestOfAll, longest);
    }
    print("all", duration(), allCuts, allStill, longestOfAll);
    return 0;
}

} // namespace

} // namespace odraz::measure

int main(int argc, char **argv) { return common::runProgram("stillness", argc, argv, odraz::measure::run); }
