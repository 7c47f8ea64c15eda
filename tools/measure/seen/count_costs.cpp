// count_costs: counts the instructions of pictures of the film, and prints rows of costs.csv. It counts only
// if tools/measure/seen/costs has built it.
#include "tools/measure/detect/screening.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

// Instructions so far. The code of tools/measure/seen/counting/as uses the first 16 counters in turn: each
// addition to a single counter would have to wait for the one before
extern "C" {
volatile uint64_t odraz_counted[17];
}

namespace odraz::measure {

namespace {

constexpr double kSixtieth = 1 / 60.0; // seconds

uint64_t counted() {
    uint64_t sum = 0;
    for (int i = 0; i < 16; ++i) sum += odraz_counted[i];
    return sum;
}

uint64_t parallel; // instructions that threads can share

Workers oneWorker() {
    Workers workers = serialWorkers();
    workers.run = [](Workers &w, int count, int size, void (*body)(const void *, int, int, int),
                     const void *context) {
        uint64_t before = counted();
        serialWorkers().run(w, count, size, body, context);
        parallel += counted() - before;
    };
    return workers;
}

// Makes a picture and prints its row.
template <class Make>
void count(double seconds, int gap, float level, const IntroSettings &size, const Make &make) {
    parallel = 0;
    uint64_t before = counted();
    make();
    std::printf("%g,%d,%g,%d,%d,%.0f,%.0f\n", seconds, gap, level, size.width, size.height,
                (double)(counted() - before - parallel) / 1e3, (double)parallel / 1e3);
    std::fflush(stdout);
}

// Moments of every shot, two seconds apart. Interpolation between them has an error of 7 % (rms) and a mean
// error of 1 %.
std::vector<double> moments() {
    std::vector<double> all;
    for (const Span &shot : shots())
        for (const Span &at : windowsIn(shot, std::max(1, (int)std::lround((shot.to - shot.from) / 2)), 0))
            all.push_back(at.from);
    return all;
}

int run(common::CommandLine &line) {
    std::vector<double> at;
    bool list = false;
    line.about("Counts the instructions of traced pictures of the film, and of in-betweens. Prints rows of\n"
               "tools/measure/seen/costs.csv.");
    auto read = [&](const std::string &text) {
        at.push_back(common::numberOf("--at", text, {0, duration()}));
    };
    line.option("--at", "S", read, "count this moment; repeatable");
    line.flag("--list", list, "only print the moments to count in every shot");
    line.parse();
    if (list) {
        for (double seconds : moments()) std::printf("%g\n", seconds);
        return 0;
    }
    Workers workers = oneWorker();
    for (IntroSettings size : {IntroSettings{480, 270}, IntroSettings{1280, 720}}) {
        bool large = size.width == 1280;
        size.pairs = true;
        MeasuredFilm film(size, workers, true);
        Intro &intro = *film.intro;
        for (double seconds : at) {
            // Between two levels the cost is nearly linear. At `play` and `draft` it drops, since only there
            // the smallest squares become larger
            for (float level : {1.f, 2.f, 0.f, 0.99f, 1.99f}) {
                if (large && level != 1 && level != 2) break;
                count(seconds, 0, level, size, [&] { picture(intro, 0, seconds, qualityOf(level)); });
            }
            // How much of an in-between is traced again depends on the gap and the level
            for (int gap : {2, 4, 6})
                for (float level : {1.f, 2.f, 0.f}) {
                    if (large && level != 1) break;
                    picture(intro, 0, seconds - kSixtieth * gap / 2, qualityOf(level));
                    picture(intro, 1, seconds + kSixtieth * gap / 2, qualityOf(level));
                    count(seconds, gap, level, size, [&] { between(intro, 0, 1); });
                }
        }
    }
    if (!counted()) throw std::runtime_error("this build does not count: run tools/measure/seen/costs");
    return 0;
}

} // namespace

} // namespace odraz::measure

int main(int argc, char **argv) { return common::runProgram("count_costs", argc, argv, odraz::measure::run); }
