// flicker: by how much the error of a quality changes from picture to picture.
#include "show/show.h"
#include "tools/common/arguments.h"
#include "tools/common/whole_file.h"
#include "tools/measure/screening.h"

#include <cmath>

using namespace odraz;

static constexpr char kUsage[] =
    "usage: flicker [--scene NAME]... [--quality NAME=play]... [--windows N=3] [--pairs N=1] [--rate N=60]\n"
    "               [--size WxH=1280x720] [--grid N=8] [--keep DIR]\n"
    "For every scene and window the pictures of --pairs neighbours, 1/rate s apart, evenly over a second: "
    "the error\n"
    "against `reference` (grid x grid samples a pixel) as it is shown, but not rounded to levels, and the "
    "root mean\n"
    "square of its change, in levels of 255. Windows stand evenly in the scene. A reference takes seconds: "
    "more "
    "pairs\n"
    "are nearer to the truth, 60 is all of it. Writes a CSV to stdout; --keep writes where it changes, eight "
    "times enlarged, as PGM.\n";

namespace {

struct Wishes {
    std::vector<std::string> scenes, qualities;
    int windows = 3, pairs = 1, grid = 8;
    double rate = 60;
    std::string size = "1280x720", keep;
};

// From when to when a scene plays, seconds; false where it does not.
bool spanOf(const std::string &name, double &from, double &to) {
    from = to = -1;
    for (int i = 0; i < kFilm.count; ++i) {
        if (name != kScenes[kFilm.shots[i].scene].name) continue;
        if (from < 0) from = (double)kFilm.shots[i].row / kRowsPerSecond;
        to = (i + 1 < kFilm.count ? (double)kFilm.shots[i + 1].row : (double)kFilm.endRow) / kRowsPerSecond;
    }
    return from >= 0;
}

struct Meter {
    Screening &screening;
    const Wishes &wishes;
    Quality reference = kQualities[(int)QualityName::Reference];

    // The largest change of a channel, eight times enlarged.
    void keep(double seconds, const Quality &q, const std::vector<float> &change) const {
        IntroSettings s = sizeFrom(wishes.size);
        std::string path = wishes.keep + "/" + std::to_string(seconds) + "-" + q.name + ".pgm",
                    file = "P5\n" + std::to_string(s.width) + " " + std::to_string(s.height) + "\n255\n";
        for (size_t i = 0; i < change.size(); i += (size_t)s.width * 3)
            for (size_t x = i; x < i + (size_t)s.width; ++x) {
                float most = 0;
                for (size_t c = 0; c < 3; ++c)
                    most = std::max(most, std::fabs(change[x + c * (size_t)s.width]));
                file += (char)(uint8_t)std::min(8 * most, 255.f);
            }
        writeWhole(path, file);
    }
    // The sum of squares over a pair of pictures, for every quality.
    void add(double seconds, std::vector<double> &sums) const {
        double next = seconds + 1 / wishes.rate;
        std::vector<float> truth = screening.shown(next, reference),
                           before = screening.shown(seconds, reference);
        for (size_t i = 0; i < truth.size(); ++i) truth[i] -= before[i];
        for (size_t k = 0; k < sums.size(); ++k) {
            const Quality &q = qualityFrom(wishes.qualities[k]);
            std::vector<float> a = screening.shown(seconds, q), b = screening.shown(next, q);
            for (size_t i = 0; i < truth.size(); ++i) {
                b[i] -= a[i] + truth[i];
                sums[k] += (double)(b[i] * b[i]) / (double)truth.size();
            }
            if (!wishes.keep.empty()) keep(seconds, q, b);
        }
    }
};

int run(Arguments &words) {
    Wishes w;
    while (const char *word = words.next()) {
        std::string o = word;
        if (o == "--scene")
            w.scenes.push_back(words.value(o));
        else if (o == "--quality")
            w.qualities.push_back(words.value(o));
        else if (o == "--windows")
            w.windows = words.whole(o, 1, 100);
        else if (o == "--pairs")
            w.pairs = words.whole(o, 1, 1000);
        else if (o == "--rate")
            w.rate = words.number(o, 1, 1000);
        else if (o == "--grid")
            w.grid = words.whole(o, 1, 16);
        else if (o == "--keep")
            w.keep = words.value(o);
        else if (o == "--size")
            w.size = words.value(o);
        else
            words.refuse(o);
    }
    if (w.qualities.empty()) w.qualities = {"play"};
    if (w.scenes.empty())
        for (const SceneEntry &s : kScenes) w.scenes.push_back(s.name);
    double first = duration(), last = 0;
    for (const std::string &q : w.qualities) qualityFrom(q);
    for (const std::string &s : w.scenes) {
        double from, to;
        if (!spanOf(s, from, to)) throw Refused("there is no scene '" + s + "'");
        first = std::min(first, from), last = std::max(last, to);
    }
    Screening screening(sizeFrom(w.size), first, last);
    Meter meter{screening, w};
    meter.reference.grid = w.grid;

    std::puts("scene,from,quality,rms");
    for (const std::string &s : w.scenes) {
        double from, to;
        spanOf(s, from, to);
        for (int i = 0; i < w.windows; ++i) {
            double begin = from + (to - from) * (i + 0.5) / w.windows - 0.5;
            std::vector<double> sums(w.qualities.size());
            for (int k = 0; k < w.pairs; ++k) meter.add(begin + (k + 0.5) / w.pairs, sums);
            for (size_t k = 0; k < sums.size(); ++k)
                std::printf("%s,%.2f,%s,%.3f\n", s.c_str(), begin, w.qualities[k].c_str(),
                            std::sqrt(sums[k] / w.pairs));
            std::fflush(stdout);
        }
    }
    return 0;
}

} // namespace

int main(int argc, char **argv) { return runProgram("flicker", kUsage, argc, argv, run); }
