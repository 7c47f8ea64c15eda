#include "tools/common/arguments.h"
#include "tools/common/statistics.h"
#include "tools/measure/subject.h"
#include "tools/measure/tradeoff.h"

#include <algorithm>
#include <cstdio>

using namespace odraz;

namespace {

struct Setting {
    std::string name;
    int series;
    Quality quality;
    bool shipped;
};

const std::vector<std::string> kSeries = {
    "qualities", "samples in every pixel", "smallest square", "threshold", "edge", "marks"};

// The named points, the ways between them that the governor takes, plain grids, and one knob of `play` after
// the other.
std::vector<Setting> settings(bool few) {
    std::vector<Setting> all;
    auto named = [](QualityName name) { return kQualities[(int)name]; };
    for (const Quality &q : kQualities)
        if (q.grid == 0) all.push_back({q.name, 0, q, true});
    Quality play = named(QualityName::Play);
    auto with = [&](int series, const std::string &name, auto &&change) {
        Quality q = play;
        change(q);
        all.push_back({name, series, q, false});
    };
    for (int n : {1, 2, 3, 4})
        if (!few || n < 3)
            with(1, std::to_string(n) + "x" + std::to_string(n) + " samples",
                 [&](Quality &q) { q.grid = n; });
    if (few) return all;
    auto text = [](const char *knob, float v) {
        char s[60];
        std::snprintf(s, sizeof s, "%s %g", knob, (double)v);
        return std::string(s);
    };
    for (float share : {0.25f, 0.5f, 0.75f}) {
        all.push_back({text("to film", 1 - share), 0, between(named(QualityName::Film), play, share), false});
        all.push_back({text("to draft", share), 0, between(play, named(QualityName::Draft), share), false});
        all.push_back({text("to least", share), 0,
                       between(named(QualityName::Draft), named(QualityName::Least), share), false});
    }
    for (int fine : {8, 4, 1})
        with(2, text("smallest square", (float)fine / 4), [&](Quality &q) { q.fine = fine; });
    for (int coarse : {4, 8, 16})
        with(2, text("largest square", (float)coarse / 4), [&](Quality &q) { q.coarse = coarse; });
    for (float v : {0.01f, 0.02f, 0.1f}) with(3, text("threshold", v), [&](Quality &q) { q.threshold = v; });
    for (float v : {0.f, 0.01f, 0.04f, 0.08f}) with(3, text("mild", v), [&](Quality &q) { q.mild = v; });
    for (float v : {0.03f, 0.06f, 0.2f, 0.4f}) with(4, text("edge", v), [&](Quality &q) { q.edge = v; });
    for (float v : {0.03f, 0.06f, 0.25f}) with(5, text("mark", v), [&](Quality &q) { q.mark = v; });
    for (int v : {2, 3, 9}) with(5, text("bounces", (float)v), [&](Quality &q) { q.depth = v; });
    for (float v : {1 / 10.f, 1 / 160.f}) with(5, text("cutoff", v), [&](Quality &q) { q.cutoff = v; });
    return all;
}

} // namespace

void odraz::tradeoffTrace(const Sweep &sweep, const std::string &scene) {
    std::vector<SubjectName> names;
    std::string known;
    for (const SubjectName &n : subjectNames()) {
        if (scene.empty() || scene == n.name) names.push_back(n);
        known += std::string(" ") + n.name;
    }
    if (names.empty()) throw Refused("there is no scene '" + scene + "'; there are:" + known);
    // A small picture costs little, and shows the same order
    int width = sweep.quick ? 256 : 1280, height = width * 9 / 16;
    Plot plot = {"trace: " + (scene.empty() ? "all scenes" : "scene " + scene) + ", " +
                     std::to_string(width) + "x" + std::to_string(height),
                 "processor time of a picture, ms",
                 "PSNR to 256 samples a pixel, dB",
                 scene.empty() ? std::vector<std::string>{} : kSeries,
                 {},
                 true,
                 false,
                 true,
                 false};
    plot.frontOfEach = scene.empty();
    Table table("scene,setting,shipped,samples_per_pixel,cpu_ms,psnr_db", plot);
    for (size_t i = 0; i < names.size(); ++i) {
        Subject subject(names[i], width, height);
        if (scene.empty()) table.plot.series.push_back(names[i].name);
        for (const Setting &s : settings(sweep.quick || sweep.named)) {
            std::vector<double> times;
            for (int round = 0; round < (sweep.quick ? 3 : 7); ++round)
                times.push_back(subject.trace(s.quality));
            double ms = median(times), samples = subject.samplesPerPixel();
            std::vector<uint8_t> picture = subject.picture(); // before the reference, once, replaces it
            double db = std::min(psnr(picture, subject.reference()), 99.); // equal ones shall be drawn too
            table.row("%s,%s,%d,%.3f,%.1f,%.2f", names[i].name, s.name.c_str(), s.shipped, samples, ms, db);
            table.plot.points.push_back({ms, db, scene.empty() ? names[i].name + (" " + s.name) : s.name,
                                         s.shipped, scene.empty() ? (int)i : s.series});
        }
    }
    table.save(sweep);
}
