// stillness: where the film stands still, and how often it cuts.
#include "show/show.h"
#include "tools/common/arguments.h"
#include "tools/measure/detect/screening.h"
#include "tools/measure/detect/still.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace odraz;

static constexpr char kUsage[] =
    "usage: stillness [--fps N=25] [--hold S=4] [--below LEVELS=2] [--aside S=4] [--quality NAME=draft]\n"
    "                 [--size WxH=320x180] [--list]\n"
    "Tells for each scene how many cuts begin or interrupt it, and for how many seconds it stands still: "
    "these\n"
    "are the pieces of --hold seconds or more in which the mean picture of a second differs by less than\n"
    "--below levels (of 255) from that of the next second, on average. Pictures are without grain. Seconds\n"
    "that fade are left out, and the last --aside seconds.\n"
    "Writes a CSV to stdout: a row for each scene, or with --list for each second, with the change to the\n"
    "next one (nan: left out).\n";

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
std::vector<double> meanOf(Screening &screening, int second, const Options &o, const Quality &quality) {
    std::vector<double> mean;
    int count = (int)std::lround(o.fps);
    for (int i = 0; i < count; ++i) {
        std::vector<float> levels = screening.shown(second + i / o.fps, quality);
        mean.resize(levels.size());
        for (size_t k = 0; k < levels.size(); ++k) mean[k] += (double)levels[k] / count;
    }
    return mean;
}

std::vector<double> changesOf(const Options &o) {
    Screening screening(sizeFrom(o.size), 0, duration());
    const Quality &quality = qualityFrom(o.qualities.back());
    std::vector<double> changes, before;
    for (int second = 0; second < (int)duration() - o.aside; ++second) {
        std::vector<double> now;
        if (!fades(second)) now = meanOf(screening, second, o, quality);
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

int run(common::Arguments &words) {
    Options o;
    o.size = "320x180";
    o.qualities = {"draft"};
    while (const char *word = words.next()) {
        std::string w = word;
        if (w == "--fps")
            o.fps = words.number(w, 1, 100);
        else if (w == "--hold")
            o.hold = words.whole(w, 2, 100);
        else if (w == "--below")
            o.below = words.number(w, 0, 255);
        else if (w == "--aside")
            o.aside = words.whole(w, 0, (int)duration());
        else if (w == "--list")
            o.list = true;
        else if (!o.take(w, words))
            words.refuse(w);
    }
    std::vector<double> changes = changesOf(o);
    if (o.list) {
        std::puts("second,scene,change");
        for (size_t i = 0; i < changes.size(); ++i)
            std::printf("%d,%s,%.2f\n", (int)i, sceneName(sceneAt((double)i)), changes[i]);
        return 0;
    }
    std::puts("scene,seconds,cuts,cuts a minute,seconds that stand still,longest of them");
    auto tell = [&](const char *name, double seconds, int cuts, int still, int longest) {
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
        tell(kScenes[scene].name, seconds, cuts, still, longest);
        allCuts += cuts, allStill += still, longestOfAll = std::max(longestOfAll, longest);
    }
    tell("all", duration(), allCuts, allStill, longestOfAll);
    return 0;
}

} // namespace

int main(int argc, char **argv) { return common::runProgram("stillness", kUsage, argc, argv, run); }
