// bench_between: in-betweens at every fraction, compared with `draft` and `play` traced at the same moment.
#include "tools/common/arguments.h"
#include "tools/common/clock.h"
#include "tools/common/text.h"
#include "tools/measure/detect/screening.h"
#include "tools/picture/psnr.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

using namespace odraz;

namespace {

constexpr char kUsage[] =
    "usage: bench_between [--size WxH=1280x720] [--gap N]... [SECONDS...]\n"
    "For every moment of the film (default: three of each scene) it makes the picture between two of `play`\n"
    "that are N sixtieths of a second apart (default: 2, 4 and 6), with the moment at each sixtieth between\n"
    "them; and traces it as `draft` and as `play`. Writes a CSV to stdout: \"1/4\" is a quarter of the way\n"
    "between two that are four sixtieths apart; PSNR is of the picture as it is shown, against 64 samples "
    "in\n"
    "every pixel, in linear light and in sRGB, in dB; milliseconds are those of one thread for all of the\n"
    "picture; anew is the share of an in-between's pixels that was traced.\n";
constexpr double kSixtieth = 1 / 60.0;

struct Asked {
    std::string size = "1280x720";
    std::vector<int> gaps;
    std::vector<double> moments;
};

Asked read(common::Arguments &words) {
    Asked asked;
    while (const char *word = words.next()) {
        std::string option = word;
        if (option == "--size")
            asked.size = words.value(option);
        else if (option == "--gap")
            asked.gaps.push_back(words.whole(option, 2, 60));
        else {
            char *end;
            asked.moments.push_back(std::strtod(word, &end));
            if (end == word || *end) words.refuse(option);
        }
    }
    if (asked.gaps.empty()) asked.gaps = {2, 4, 6};
    if (asked.moments.empty())
        asked.moments = {8,  11.5, 18,  20,  30,  44,  52,  62,  70.5, 78, 84,
                         93, 98,   110, 121, 131, 138, 144, 150, 156,  159};
    return asked;
}

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
            std::string name;
            common::append(name, "%d/%d", k, gap);
            row(name, 3, [&] { return between(intro, 0, 1, (double)k / gap); });
        }
}

int run(common::Arguments &words) {
    Asked asked = read(words);
    IntroSettings settings = sizeFrom(asked.size);
    settings.pairs = true;
    Workers workers = serialWorkers();
    auto [first, last] = std::minmax_element(asked.moments.begin(), asked.moments.end());
    double most = *std::max_element(asked.gaps.begin(), asked.gaps.end()) * kSixtieth;
    if (*first < most || *last > duration() - most)
        throw common::Refused("such a moment is not between two pictures");
    Theatre theatre(settings, workers, *first - most, *last + most);
    std::puts("scene,seconds,picture,linear_db,srgb_db,ms,anew");
    for (double s : asked.moments) measure(*theatre.intro, s, asked.gaps);
    return 0;
}

} // namespace

int main(int argc, char **argv) { return common::runProgram("bench_between", kUsage, argc, argv, run); }
