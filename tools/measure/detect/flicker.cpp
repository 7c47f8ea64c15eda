// flicker: how much the error of a quality changes from picture to picture.
#include "show/show.h"
#include "tools/common/arguments.h"
#include "tools/common/whole_file.h"
#include "tools/measure/detect/screening.h"

#include <cmath>

using namespace odraz;

static constexpr char kUsage[] =
    "usage: flicker [--scene NAME]... [--quality NAME=play]... [--windows N=3] [--pairs N=1] [--rate N=60]\n"
    "               [--size WxH=1280x720] [--grid N=8] [--keep DIR]\n"
    "Tells how much the error of a quality changes from one picture to the next, as a root mean square in\n"
    "levels of 255. The error is the difference from `reference`, with grid x grid samples a pixel; both\n"
    "pictures are as they are shown, but not rounded to levels.\n"
    "Each scene has --windows windows of one second, evenly spaced, and each window --pairs pairs of\n"
    "pictures, 1/rate s apart. A reference takes seconds; 60 pairs measure the whole second.\n"
    "Writes a CSV to stdout. --keep writes pictures of the change, eight times enlarged, as PGM.\n";

namespace {

struct Options : ScreeningOptions {
    std::vector<std::string> scenes;
    int windows = 3, pairs = 1, grid = 8;
    double rate = 60; // pictures a second
};

// A scene from its first shot to its last one.
Span wholeOf(const std::string &scene) {
    std::vector<Span> all = shotsOf(scene);
    return {all[0].scene, all.front().from, all.back().to};
}

struct Meter {
    Screening &screening;
    const Options &options;
    Quality reference = kQualities[(int)QualityName::Reference];

    // Keeps a picture of the largest change of a channel, enlarged eight times.
    void keep(double seconds, const Quality &q, const std::vector<float> &change) const {
        IntroSettings s = sizeFrom(options.size);
        std::string path = options.keep + "/" + std::to_string(seconds) + "-" + q.name + ".pgm",
                    file = "P5\n" + std::to_string(s.width) + " " + std::to_string(s.height) + "\n255\n";
        for (size_t i = 0; i < change.size(); i += (size_t)s.width * 3)
            for (size_t x = i; x < i + (size_t)s.width; ++x) {
                float most = 0;
                for (size_t c = 0; c < 3; ++c)
                    most = std::max(most, std::fabs(change[x + c * (size_t)s.width]));
                file += (char)(uint8_t)std::min(8 * most, 255.f);
            }
        common::writeWhole(path, file);
    }
    // Adds the sum of squares of a pair of pictures, for every quality.
    void add(double seconds, std::vector<double> &sums) const {
        double next = seconds + 1 / options.rate;
        std::vector<float> truth = screening.shown(next, reference),
                           before = screening.shown(seconds, reference);
        for (size_t i = 0; i < truth.size(); ++i) truth[i] -= before[i];
        for (size_t k = 0; k < sums.size(); ++k) {
            const Quality &q = qualityFrom(options.qualities[k]);
            std::vector<float> a = screening.shown(seconds, q), b = screening.shown(next, q);
            for (size_t i = 0; i < truth.size(); ++i) {
                b[i] -= a[i] + truth[i];
                sums[k] += (double)(b[i] * b[i]) / (double)truth.size();
            }
            if (!options.keep.empty()) keep(seconds, q, b);
        }
    }
};

int run(common::Arguments &words) {
    Options o;
    while (const char *word = words.next()) {
        std::string w = word;
        if (w == "--scene")
            o.scenes.push_back(words.value(w));
        else if (w == "--windows")
            o.windows = words.whole(w, 1, 100);
        else if (w == "--pairs")
            o.pairs = words.whole(w, 1, 1000);
        else if (w == "--rate")
            o.rate = words.number(w, 1, 1000);
        else if (w == "--grid")
            o.grid = words.whole(w, 1, 16);
        else if (!o.take(w, words))
            words.refuse(w);
    }
    if (o.qualities.empty()) o.qualities = {"play"};
    if (o.scenes.empty())
        for (const SceneEntry &s : kScenes) o.scenes.push_back(s.name);
    double first = duration(), last = 0;
    for (const std::string &q : o.qualities) qualityFrom(q);
    for (const std::string &s : o.scenes) {
        Span whole = wholeOf(s);
        first = std::min(first, whole.from), last = std::max(last, whole.to);
    }
    Screening screening(sizeFrom(o.size), first, last);
    Meter meter{screening, o};
    meter.reference.grid = o.grid;

    std::puts("scene,from,quality,rms");
    for (const std::string &s : o.scenes)
        for (const Span &window : windowsIn(wholeOf(s), o.windows, 1)) {
            std::vector<double> sums(o.qualities.size());
            for (int k = 0; k < o.pairs; ++k) meter.add(window.from + (k + 0.5) / o.pairs, sums);
            for (size_t k = 0; k < sums.size(); ++k)
                std::printf("%s,%.2f,%s,%.3f\n", s.c_str(), window.from, o.qualities[k].c_str(),
                            std::sqrt(sums[k] / o.pairs));
            std::fflush(stdout);
        }
    return 0;
}

} // namespace

int main(int argc, char **argv) { return common::runProgram("flicker", kUsage, argc, argv, run); }
