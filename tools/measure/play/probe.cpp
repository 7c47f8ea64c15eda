// probe: prints what pictures of the film cost, in instructions, and how far they are from `film`. It counts
// only if tools/measure/play/costs has built it.
#include "tools/common/text.h"
#include "tools/measure/bench/screening.h"
#include "tools/measure/bench/setting.h"
#include "tools/picture/psnr.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

// Instructions so far. The code of tools/measure/play/counting_as uses the first 16 counters in turn: each
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

// Traced pictures of a setting, or in-betweens of two such pictures, `gap` sixtieths of a second apart.
struct Kind {
    int gap;
    std::string name;
    Quality quality;
};
Kind ofLevel(int gap, const char *level) { return {gap, level, settingOf(std::string("level=") + level)}; }

// The kinds in costs.csv. Between two levels the cost is nearly linear. At `play` it drops, since pixels
// take three samples there, not twelve. How much of an in-between is traced again depends on gap and level.
std::vector<Kind> countedKinds(bool large) {
    std::vector<Kind> kinds = {ofLevel(0, "1"), ofLevel(0, "2")};
    for (const char *level : {"0", "0.99"})
        if (!large) kinds.push_back(ofLevel(0, level));
    for (int gap : {2, 4, 6})
        for (const char *level : {"1", "2", "0"})
            if (!large || *level == '1') kinds.push_back(ofLevel(gap, level));
    return kinds;
}

struct ProbeOptions {
    std::vector<double> at;
    std::vector<int> gaps;
    std::vector<std::string> settings;
    IntroSettings size = {};
    bool errors = false, list = false;
};

// Makes pictures of a moment and prints their rows.
void probe(Intro &intro, double seconds, const std::vector<Kind> &kinds, bool errors) {
    std::vector<uint8_t> truth; // the film's picture, in sRGB
    if (errors) truth = rgbOf(picture(intro, 0, seconds, kQualities[(int)QualityName::Film]));
    for (const auto &[gap, name, quality] : kinds) {
        for (int i = 0; gap && i < 2; ++i) picture(intro, i, seconds + kSixtieth * gap * (i - 0.5), quality);
        parallel = 0;
        uint64_t before = counted();
        Picture made = gap ? between(intro, 0, 1) : picture(intro, 0, seconds, quality);
        std::printf("%g,%d,%s,%d,%d,%.0f,%.0f", seconds, gap, name.c_str(), intro.width, intro.height,
                    (double)(counted() - before - parallel) / 1e3, (double)parallel / 1e3);
        if (errors) std::printf(",%s,%.2f", sceneName(sceneAt(seconds)), pictures::psnr(rgbOf(made), truth));
        std::puts("");
        std::fflush(stdout);
    }
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
    ProbeOptions o;
    line.about(
        "Counts the instructions of traced pictures of the film, and of in-betweens half-way between two.\n"
        "Without --setting it prints rows of tools/measure/play/costs.csv.");
    line.option(
        "--at", "S",
        [&](const std::string &text) {
            o.at.push_back(common::numberOf("--at", text, {0, duration()}));
        },
        "probe this moment; repeatable");
    line.option("--setting", "WORDS", o.settings,
                "probe pictures of this quality, such as play, level=1.5 or 'draft edge=0.1'; repeatable");
    line.option(
        "--gap", "N",
        [&](const std::string &text) {
            o.gaps.push_back((int)common::numberOf("--gap", text, {0, 60}));
        },
        "probe in-betweens of pictures N sixtieths of a second apart; 0, the default: traced pictures; "
        "repeatable");
    sizeOption(line, "--size", o.size, "the size of the pictures that are probed (default 1280x720)");
    line.flag("--errors", o.errors, "add the scene and the sRGB PSNR to `film`");
    line.flag("--list", o.list, "only print the moments to count in every shot");
    line.parse();
    if (o.list) {
        for (double seconds : moments()) std::printf("%g\n", seconds);
        return 0;
    }
    if (!o.gaps.empty() && o.settings.empty()) throw common::Refused("--gap needs --setting");
    if (o.at.empty()) o.at = moments();
    std::vector<Kind> kinds;
    if (o.gaps.empty()) o.gaps = {0};
    for (std::string &words : o.settings) std::replace(words.begin(), words.end(), ',', ' '); // as tradeoff
    for (int gap : o.gaps)
        for (const std::string &words : o.settings) kinds.push_back({gap, words, settingOf(words)});
    if (!o.size.width && !kinds.empty()) o.size = {1280, 720};
    std::vector<IntroSettings> sizes = {{480, 270}, {1280, 720}};
    if (o.size.width) sizes = {o.size};
    std::printf("seconds,gap,level,width,height,serial,parallel%s\n", o.errors ? ",scene,srgb_db" : "");
    Workers workers = oneWorker();
    for (IntroSettings size : sizes) {
        size.pairs = true;
        MeasuredFilm film(size, workers, true);
        for (double seconds : o.at)
            probe(*film.intro, seconds, kinds.empty() ? countedKinds(size.width == 1280) : kinds, o.errors);
    }
    if (!counted() && !o.errors)
        throw std::runtime_error("this build does not count: run tools/measure/play/costs");
    return 0;
}

} // namespace

} // namespace odraz::measure

int main(int argc, char **argv) { return common::runProgram("probe", argc, argv, odraz::measure::run); }
