#include "tools/common/statistics.h"
#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/measure/bench/setting.h"
#include "tools/measure/bench/subject.h"
#include "tools/measure/sweep/tradeoff.h"
#include "tools/picture/flip.h"
#include "tools/picture/psnr.h"

#include <algorithm>
#include <unistd.h>

namespace odraz::measure {

namespace {

using TraceSetting = Setting<Quality>;

struct TraceSweep : Sweep {
    std::vector<std::string> scenes, settings; // none: all
    int width = 1280;
    std::string references;
};

enum Series { kQuality, kGrid, kSquare, kThreshold, kEdge, kPaths };
constexpr const char *kSeries[] = {[kQuality] = "qualities", [kGrid] = "samples in every pixel",
                                   [kSquare] = "squares",    [kThreshold] = "thresholds",
                                   [kEdge] = "edge",         [kPaths] = "what rays follow and mark"};

// The named qualities, the steps between them that the governor takes, plain grids, and `play` with one knob
// turned at a time.
std::vector<TraceSetting> settings(bool few) {
    std::vector<TraceSetting> all;
    auto named = [](QualityName name) { return kQualities[(int)name]; };
    for (const Quality &q : kQualities)
        if (q.grid == 0) all.push_back({q.name, q, true, kQuality});
    Quality play = named(QualityName::Play);
    auto with = [&](Series series, const std::string &name, auto &&change) {
        Quality q = play;
        change(q);
        all.push_back({name, q, false, series});
    };
    for (int n : {1, 2})
        with(kGrid, std::to_string(n) + "x" + std::to_string(n) + " samples",
             [&](Quality &q) { q.grid = n; });
    if (few) return all;
    auto text = [](const char *knob, float v) { return common::format("%s %g", knob, (double)v); };
    for (float share : {0.25f, 0.5f, 0.75f}) {
        all.push_back({text("to film", 1 - share), blend(named(QualityName::Film), play, share)});
        all.push_back({text("to draft", share), blend(play, named(QualityName::Draft), share)});
    }
    for (int fine : {8, 4})
        with(kSquare, text("smallest square", (float)fine / 4), [&](Quality &q) { q.fine = fine; });
    with(kSquare, "twelve samples inside pixels", [&](Quality &q) { q.fine = 1; });
    for (int coarse : {4, 8, 32})
        with(kSquare, text("largest square", (float)coarse / 4), [&](Quality &q) { q.coarse = coarse; });
    for (float v : {0.01f, 0.02f, 0.08f})
        with(kThreshold, text("threshold", v), [&](Quality &q) { q.threshold = v; });
    for (float v : {0.f, 0.02f, 0.1f})
        with(kThreshold, text("markThreshold", v), [&](Quality &q) { q.markThreshold = v; });
    for (float v : {0.03f, 0.06f, 0.2f, 0.4f}) with(kEdge, text("edge", v), [&](Quality &q) { q.edge = v; });
    for (float v : {0.05f, 0.1f, 0.4f})
        with(kPaths, text("markWeight", v), [&](Quality &q) { q.markWeight = v; });
    for (int v : {2, 3, 9}) with(kPaths, text("bounces", (float)v), [&](Quality &q) { q.depth = v; });
    for (float v : {1 / 10.f, 1 / 160.f}) with(kPaths, text("cutoff", v), [&](Quality &q) { q.cutoff = v; });
    return all;
}

// The settings that the sweep asks for
std::vector<TraceSetting> askedSettings(const TraceSweep &sweep) {
    if (sweep.settings.empty()) return settings(sweep.quick);
    std::vector<TraceSetting> all;
    for (std::string words : sweep.settings) {
        Quality q = settingOf(words);
        std::replace(words.begin(), words.end(), ',', ' '); // commas would separate columns of the table
        all.push_back({words, q});
    }
    return all;
}

// The reference, read from a folder or traced
std::vector<uint8_t> referenceOf(Subject &subject, const std::string &folder, const std::string &name) {
    if (folder.empty()) return subject.reference();
    std::string file = folder + "/" + name + "-" + std::to_string(subject.width());
    if (access(file.c_str(), R_OK) == 0) {
        std::string bytes = common::readWhole(file);
        return {bytes.begin(), bytes.end()};
    }
    std::vector<uint8_t> traced = subject.reference();
    common::writeWhole(file, {(const char *)traced.data(), traced.size()});
    return traced;
}

// The results of a setting on a picture
struct Measured {
    std::vector<double> times;
    double samples, flip, linear, shown;
};

std::vector<Measured> measure(Subject &subject, const std::vector<TraceSetting> &settings, int rounds,
                              const std::vector<uint8_t> &reference) {
    pictures::SeenPicture truth = pictures::see(reference, subject.width(), subject.height());
    std::vector<Measured> all(settings.size());
    // All settings in each round, so that a disturbance of the machine affects them alike
    for (int round = 0; round < rounds; ++round)
        for (size_t i = 0; i < settings.size(); ++i) {
            Measured &m = all[i];
            m.times.push_back(subject.trace(settings[i].value));
            if (round > 0) continue;
            std::vector<uint8_t> picture = subject.picture();
            m.samples = subject.samplesPerPixel();
            m.flip = pictures::meanFlip(truth, pictures::see(picture, subject.width(), subject.height()));
            m.linear = std::min(pictures::linearPsnr(picture, reference),
                                99.); // finite, so that equal pictures are plotted, too
            m.shown = std::min(pictures::psnr(picture, reference), 99.);
        }
    return all;
}

// The scenes that the sweep asks for
std::vector<SubjectName> askedScenes(const TraceSweep &sweep) {
    if (sweep.scenes.empty()) return subjectNames();
    std::vector<SubjectName> all;
    for (const std::string &scene : sweep.scenes) all.push_back(findSubject(scene));
    return all;
}

} // namespace

int tradeoffTrace(common::CommandLine &line) {
    TraceSweep sweep;
    line.about(
        "Settings of the tracer: processor time against mean FLIP and PSNR, in linear light and in sRGB,\n"
        "compared with 256 samples a pixel.");
    line.option("--scene", "NAME", sweep.scenes, "only this scene");
    line.option("--setting", "WORDS", sweep.settings,
                "only this setting, as play or draft,threshold=0.02,cutoff=1/64");
    line.option("--width", "PIXELS", sweep.width, {64, 3840}, "the pictures' width");
    line.option("--references", "FOLDER", sweep.references,
                "keep the reference pictures there, for further runs of the same commit");
    sweep.read(line);
    std::vector<SubjectName> names = askedScenes(sweep);
    std::vector<TraceSetting> all = askedSettings(sweep);
    // A small picture costs little and gives the same ranking
    int width = sweep.quick ? 256 : sweep.width / 16 * 16, height = width * 9 / 16;
    bool one = names.size() == 1;
    pictures::Plot plot = {"trace: " + (one ? "scene " + names[0].name : "several scenes") + ", " +
                               std::to_string(width) + "x" + std::to_string(height),
                           "processor time of a picture, ms",
                           "mean FLIP to 256 samples a pixel",
                           one ? std::vector<std::string>(std::begin(kSeries), std::end(kSeries))
                               : std::vector<std::string>{},
                           {},
                           true,
                           true,
                           true,
                           true};
    plot.frontOfEach = !one;
    Table table("scene,setting,shipped,samples_per_pixel,cpu_ms,mean_flip,linear_psnr_db,srgb_psnr_db,"
                "words",
                plot);
    for (size_t n = 0; n < names.size(); ++n) {
        const std::string &name = names[n].name;
        Subject subject(names[n], width, height);
        if (!one) table.plot.series.push_back(name);
        std::vector<uint8_t> reference = referenceOf(subject, sweep.references, name);
        std::vector<Measured> found = measure(subject, all, sweep.quick ? 3 : 5, reference);
        for (size_t i = 0; i < all.size(); ++i) {
            const TraceSetting &s = all[i];
            const Measured &m = found[i];
            double ms = common::median(m.times);
            table.row(common::format("%s,%s,%d,%.3f,%.1f,%.4f,%.2f,%.2f,%s", name.c_str(), s.name.c_str(),
                                     s.shipped, m.samples, ms, m.flip, m.linear, m.shown,
                                     wordsOf(s.value).c_str()));
            table.plot.points.push_back(
                {ms, std::max(m.flip, 1e-4), s.name, s.shipped, one ? s.series : (int)n});
        }
    }
    table.save(sweep);
    return 0;
}

} // namespace odraz::measure
