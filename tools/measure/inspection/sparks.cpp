// sparks: counts the sparks in the film.
#include "show/show.h"
#include "tools/measure/inspection/screening.h"
#include "tools/measure/inspection/spark.h"
#include "tools/picture/picture.h"

#include <algorithm>
#include <cmath>

namespace odraz::measure {

namespace {

constexpr double kStep = 0.005;        // seconds from a picture to its neighbours
constexpr int kLeast = 24, kReach = 3; // levels above the surroundings; pixels

struct SparkCount {
    int pictures = 0, withSparks = 0, sparks = 0, most = 0;
    void print(const char *name) const {
        if (pictures) std::printf("%s,%d,%d,%d,%d\n", name, pictures, withSparks, sparks, most);
    }
};

int run(common::CommandLine &line) {
    IntroSettings size = {1280, 720};
    QualityName name = QualityName::Play;
    double from = 0, to = duration(), fps = 25;
    std::string folder;
    line.about(
        "Counts sparks: points of one to three pixels that are much brighter than their surroundings and\n"
        "that a picture 5 ms before or after does not show. Prints a CSV with a row for each scene.");
    sizeOption(line, "--size", size, "the pictures' size in pixels");
    std::vector<std::string> names;
    for (const Quality &q : kQualities) names.push_back(q.name);
    line.option("--quality", names, name, "the pictures' quality");
    line.option("--from", "S", from, {0, duration()}, "the film's first second");
    line.option("--to", "S", to, {0, duration()}, "its last second");
    line.option("--fps", "N", fps, {0.01, 1000}, "pictures a second");
    line.option("--keep", "FOLDER", folder, "write the pictures that have sparks, as PNG");
    line.parse();

    Workers workers(allProcessors());
    // Neighbours may be in other scenes
    MeasuredFilm film(size, workers, needsHall(std::max(from - kStep, 0.), std::min(to + kStep, duration())));
    auto trace = [&](double seconds) {
        return picture(*film.intro, 0, std::clamp(seconds, 0., duration()), kQualities[(int)name]);
    };
    auto grey = [&](double seconds) {
        Picture p = trace(seconds);
        return greyOf(p.width, p.height, p.rgba);
    };
    std::puts("scene,pictures,with_sparks,sparks,most");
    std::vector<SparkCount> scenes(kMaxScenes + 1); // the last one: all of the film
    for (int64_t n = (int64_t)std::ceil(from * fps - 1e-6); (double)n / fps < to; ++n) {
        double seconds = (double)n / fps;
        Grey now = grey(seconds);
        std::vector<Spark> sparks = pointsOf(now, kLeast);
        if (!sparks.empty()) {
            Grey before = grey(seconds - kStep), after = grey(seconds + kStep);
            sparks = sparksOf(sparks, now, &before, &after, kReach);
        }
        for (SparkCount *c : {&scenes[(size_t)sceneAt(seconds)], &scenes.back()}) {
            ++c->pictures;
            c->withSparks += !sparks.empty();
            c->sparks += (int)sparks.size();
            c->most = std::max(c->most, (int)sparks.size());
        }
        if (folder.empty() || sparks.empty()) continue;
        Picture p = trace(seconds);
        pictures::writePng(folder + "/" + std::to_string(n) + ".png", {p.width, p.height, rgbOf(p)});
    }
    for (int i = 0; i < kMaxScenes; ++i) scenes[(size_t)i].print(sceneName(i));
    scenes.back().print("all");
    return 0;
}

} // namespace

} // namespace odraz::measure

int main(int argc, char **argv) { return common::runProgram("sparks", argc, argv, odraz::measure::run); }
