// tradeoff: measures the processor time of settings of the tracer, and their errors against 256 samples a
// pixel.
#include "tools/common/statistics.h"
#include "tools/common/text.h"
#include "tools/measure/bench/setting.h"
#include "tools/measure/bench/subject.h"
#include "tools/picture/flip.h"
#include "tools/picture/psnr.h"

#include <algorithm>
#include <cstdio>

namespace odraz::measure {

namespace {

struct TradeoffOptions {
    std::vector<std::string> scenes, settings; // empty: all scenes; draft, play and film
    int width = 1280, rounds = 3;
};

// Traces a scene and prints a row for each setting. Each round tries all settings, so that a disturbance of
// the machine affects all of them.
void measure(const std::string &scene, const TradeoffOptions &o) {
    int height = o.width * 9 / 16;
    Subject subject(findSubject(scene), o.width, height);
    std::vector<uint8_t> reference = subject.reference();
    pictures::SeenPicture seenReference = pictures::see(reference, o.width, height);
    std::vector<std::vector<double>> times(o.settings.size());
    for (int round = 1; round <= o.rounds; ++round)
        for (size_t i = 0; i < o.settings.size(); ++i) {
            times[i].push_back(subject.trace(settingOf(o.settings[i])));
            if (round < o.rounds) continue;
            std::vector<uint8_t> picture = subject.picture();
            std::string words = o.settings[i];
            std::replace(words.begin(), words.end(), ',', ' '); // commas would separate columns
            std::printf("%s,%s,%.3f,%.1f,%.4f,%.2f,%.2f\n", scene.c_str(), words.c_str(),
                        subject.samplesPerPixel(), common::median(times[i]),
                        pictures::meanFlip(seenReference, pictures::see(picture, o.width, height)),
                        std::min(pictures::linearPsnr(picture, reference), 99.),
                        std::min(pictures::psnr(picture, reference), 99.));
            std::fflush(stdout);
        }
}

int run(common::CommandLine &line) {
    TradeoffOptions o;
    line.about("Measures the processor time of settings of the tracer, and their errors against 256 samples "
               "a pixel: mean\nFLIP, PSNR in linear light and in sRGB. Prints a CSV.");
    line.option("--scene", "NAME", o.scenes, "trace this scene (default: all)");
    line.option(
        "--setting", "WORDS", o.settings,
        "use this setting: play, level=1.5 or draft,threshold=0.02,cutoff=0.015 (default: draft, play, "
        "film)");
    line.option("--width", "PIXELS", o.width, {64, 3840}, "width of the pictures, a multiple of 16");
    line.option("--rounds", "N", o.rounds, {1, 99}, "print the median time of N rounds");
    line.parse();
    o.width = o.width / 16 * 16;
    if (o.settings.empty()) o.settings = {"draft", "play", "film"};
    for (const std::string &words : o.settings) settingOf(words); // refuse wrong ones at once
    for (const std::string &scene : o.scenes) findSubject(scene);
    if (o.scenes.empty())
        for (const SubjectName &subject : subjectNames()) o.scenes.push_back(subject.name);
    std::puts("scene,setting,samples_per_pixel,cpu_ms,mean_flip,linear_psnr_db,srgb_psnr_db");
    for (const std::string &scene : o.scenes) measure(scene, o);
    return 0;
}

} // namespace

} // namespace odraz::measure

int main(int argc, char **argv) { return common::runProgram("tradeoff", argc, argv, odraz::measure::run); }
