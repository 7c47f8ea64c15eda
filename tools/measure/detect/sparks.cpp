// sparks: counts the sparks in the film.
#include "show/show.h"
#include "tools/measure/detect/screening.h"
#include "tools/measure/detect/spark.h"
#include "tools/picture/picture.h"

#include <algorithm>
#include <cmath>

namespace odraz::measure {

namespace {

// Seconds from a picture to its neighbours; how many of 255 levels a spark is brighter; within how many
// pixels a neighbour must show it
constexpr double kApart = 0.005;
constexpr int kLeast = 24, kReach = 3;

struct Count {
    int pictures = 0, marked = 0, sparks = 0, most = 0;
    void add(size_t found) {
        ++pictures;
        marked += found > 0;
        sparks += (int)found;
        most = std::max(most, (int)found);
    }
    void print(const char *name) const {
        if (pictures) std::printf("%s,%d,%d,%d,%d\n", name, pictures, marked, sparks, most);
        std::fflush(stdout);
    }
};

struct Options : ScreeningOptions {
    double from = 0, to = duration(), fps = 25; // seconds; pictures a second
    std::string keep;
};

void lookAtFilm(const Options &o) {
    const Quality &quality = o.chosen();
    // Neighbours may lie in other scenes
    Screening screening(o.size, std::max(o.from - kApart, 0.), std::min(o.to + kApart, duration()));
    auto see = [&](double seconds) {
        Picture p = screening.picture(std::clamp(seconds, 0., duration()), quality);
        return greyOf(p.width, p.height, p.rgba, 4);
    };
    std::vector<Count> scenes(kMaxScenes);
    for (int64_t n = (int64_t)std::ceil(o.from * o.fps - 1e-6); (double)n / o.fps < o.to; ++n) {
        double seconds = (double)n / o.fps;
        Grey now = see(seconds);
        std::vector<Spark> sparks = pointsOf(now, kLeast);
        if (!sparks.empty()) {
            Grey before = see(seconds - kApart), after = see(seconds + kApart);
            sparks = sparksOf(sparks, now, &before, &after, kReach);
        }
        scenes[(size_t)sceneAt(seconds)].add(sparks.size());
        if (!o.keep.empty() && !sparks.empty()) {
            Picture p = screening.picture(seconds, quality);
            pictures::writePng(o.keep + "/" + std::to_string(n) + ".png", {p.width, p.height, rgbOf(p)});
        }
    }
    Count all;
    for (int i = 0; i < kMaxScenes; ++i) {
        const Count &c = scenes[(size_t)i];
        if (c.pictures) c.print(sceneName(i));
        all = {all.pictures + c.pictures, all.marked + c.marked, all.sparks + c.sparks,
               std::max(all.most, c.most)};
    }
    all.print("all");
}

int run(common::CommandLine &line) {
    Options o;
    line.about(
        "Counts sparks: points of one to three pixels that are much brighter than what surrounds them, and "
        "that\n"
        "a neighbouring picture lacks: it shows nothing half as bright near them. Prints a CSV: a row for "
        "each\n"
        "scene of the film.");
    o.addTo(line);
    line.option("--from", "S", o.from, {0, duration()}, "the film's first second");
    line.option("--to", "S", o.to, {0, duration()}, "its last second");
    line.option("--fps", "N", o.fps, {0.01, 1000}, "pictures a second");
    line.option("--keep", "FOLDER", o.keep, "write the film's pictures that have sparks, as PNG");
    line.parse();
    std::puts("scene,pictures,with_sparks,sparks,most");
    lookAtFilm(o);
    return 0;
}

} // namespace

} // namespace odraz::measure

int main(int argc, char **argv) { return common::runProgram("sparks", argc, argv, odraz::measure::run); }
