// bench_between: in-betweens at every fraction, compared with `draft` and `play` traced at the same moment.
#include "tools/common/clock.h"
#include "tools/common/command_line.h"
#include "tools/common/text.h"
#include "tools/measure/detect/screening.h"
#include "tools/picture/psnr.h"

#include <algorithm>
#include <cstdio>

namespace odraz::measure {

namespace {

constexpr double kSixtieth = 1 / 60.0;

// The rows of a moment
void measure(Intro &intro, double s, const std::vector<int> &gaps) {
    const Quality &play = kQualities[(int)QualityName::Play], &draft = kQualities[(int)QualityName::Draft];
    Quality exact = kQualities[(int)QualityName::Reference];
    exact.depth = 8, exact.cutoff = 1 / 256.f;
    std::vector<uint8_t> truth = rgbOf(picture(intro, 0, s, exact));
    auto row = [&](const std::string &name, int tries, auto &&make) {
        tracedAnew(intro.between);
        double ms = 1e9; // the fastest counts
        std::vector<uint8_t> rgb;
        for (int i = 0; i < tries; ++i) {
            double began = common::threadSeconds();
            Picture made = make();
            ms = std::min(ms, (common::threadSeconds() - began) * 1e3);
            rgb = rgbOf(made);
        }
        double anew = (double)tracedAnew(intro.between) / tries / (intro.width * intro.height);
        std::printf("%s,%g,%s,%.2f,%.2f,%.1f,%.4f\n", sceneName(sceneAt(s)), s, name.c_str(),
                    pictures::linearPsnr(rgb, truth), pictures::psnr(rgb, truth), ms, anew);
        std::fflush(stdout);
    };
    row("draft", 1, [&] { return picture(intro, 0, s, draft); });
    row("play", 1, [&] { return picture(intro, 0, s, play); });
    for (int gap : gaps)
        for (int k = 1; k < gap; ++k) {
            picture(intro, 0, s - k * kSixtieth, play);
            picture(intro, 1, s + (gap - k) * kSixtieth, play);
            row(common::format("%d/%d", k, gap), 3, [&] { return between(intro, 0, 1, (double)k / gap); });
        }
}

int run(common::CommandLine &line) {
    IntroSettings settings = {1280, 720};
    std::vector<int> gaps;
    std::vector<std::string> seconds;
    std::vector<double> moments;
    line.about("Makes the film's picture of each moment between two of `play` that are a gap apart, with the "
               "moment at each\n"
               "sixtieth of a second between them, and traces it as `draft` and as `play`. Prints a CSV: "
               "\"1/4\" is a\n"
               "quarter of the way between two that are four sixtieths apart; PSNR in dB is of the picture "
               "as it is\n"
               "shown, against 64 samples in every pixel; milliseconds are one thread's for all of the "
               "picture; anew is\n"
               "the share of its pixels that an in-between traced.");
    line.arguments("SECONDS", seconds, "moments of the film");
    sizeOption(line, "--size", settings, "the pictures' size");
    line.option(
        "--gap", "N",
        [&](const std::string &text) {
            gaps.push_back((int)common::numberOf("--gap", text, {2, 60}));
        },
        "sixtieths of a second from one picture to the other (default 4); repeatable");
    line.parse();
    if (gaps.empty()) gaps = {4};
    double most = *std::max_element(gaps.begin(), gaps.end()) * kSixtieth;
    for (const std::string &s : seconds)
        moments.push_back(common::numberOf("SECONDS", s, {most, duration() - most}));
    settings.pairs = true;
    Workers workers = serialWorkers();
    auto [first, last] = std::minmax_element(moments.begin(), moments.end());
    LoadedFilm film(settings, workers, needsHall(*first - most, *last + most));
    std::puts("scene,seconds,picture,linear_db,srgb_db,ms,anew");
    for (double s : moments) measure(*film.intro, s, gaps);
    return 0;
}

} // namespace

} // namespace odraz::measure

int main(int argc, char **argv) {
    return common::runProgram("bench_between", argc, argv, odraz::measure::run);
}
