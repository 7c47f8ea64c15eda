// Adaptive against uniform elements.
#include "tools/radiosity/study/study.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

void studyElements(Study &study) {
    Page &page = study.page;
    page.heading("Adaptive and uniform elements");
    pictures::Plot plot = errorPlot("elements: error against time", "processor time, s", "error (rms), %",
                                    {"uniform", "adaptive"});
    PageTable table = {"elements",
                       {"elements", "kind", "processor_s", "rms_percent", "median_percent"},
                       {"elements", "", "processor, s", "error (rms), %", "median, %"}};
    // Rows by hemicubes if the time allows it, otherwise by rays
    constexpr int kRays = 128;
    double each = study.left() / 7;
    bool rays = 1.5 * study.hemicubeSeconds(16) * study.patchesFor(6000) > each - study.divideSeconds();
    page.text(
        "Lamps are seen by shadow rays, patches by " +
        (rays ? std::to_string(kRays) + " rays, since hemicubes of all of them would take too long"
              : std::string("hemicubes of 16 pixels")) +
        ". Adaptive solutions begin with elements of sixteen times the area and divide those across which "
        "direct light changes.");
    struct Best {
        double seconds, rms;
        size_t elements;
    };
    std::vector<Best> uniform, adaptive;
    double longest = 0;
    struct Size {
        bool adaptive;
        int elements; // of a uniform one with the adaptive one's finest elements
    };
    for (auto [isAdaptive, elements] : {Size{false, 7500},
                                        {true, 30000},
                                        {false, 30000},
                                        {true, 120000},
                                        {false, 120000},
                                        {true, 480000}}) {
        std::string kind = isAdaptive ? "adaptive" : "uniform";
        if (!study.fits(longest)) {
            study.leftOut.push_back("elements: about " + std::to_string(elements) + ", " + kind);
            continue;
        }
        SolveSettings s = study.settings.solve;
        s.way = Way::kPatches;
        s.element = study.area / elements;
        s.adaptive = isAdaptive;
        if (rays) s.findRows = rowsByRays(kRays);
        std::string options =
            "--hemicube 16 --element " + shown(s.element, 6) + (isAdaptive ? " --adaptive" : "");
        Solved b = study.measure(rays ? kind + ", with rows by rays" : kind, options, s);
        const MeasuredSolution &r = study.measured.back();
        longest = std::max(longest, 1.5 * r.wall);
        size_t count = b.solution.elements();
        table.rows.push_back(
            {std::to_string(count), kind, shown(r.seconds), shown(r.errors.rms), shown(r.errors.median)});
        plot.points.push_back({r.seconds, r.errors.rms, std::to_string(count), false, isAdaptive});
        (isAdaptive ? adaptive : uniform).push_back({r.seconds, r.errors.rms, count});
    }
    page.table(table);
    page.plot("elements", plot);
    if (uniform.empty() || adaptive.empty()) {
        study.advice.push_back("Elements: there was no time to compare adaptive with uniform ones.");
        return;
    }
    // Compare the cheapest of each kind within an error that both kinds reach
    constexpr double kAsGood = 1.05;
    auto least = [](const std::vector<Best> &all) {
        double rms = INFINITY;
        for (const Best &b : all) rms = std::min(rms, b.rms);
        return rms;
    };
    double reached = kAsGood * std::max(least(uniform), least(adaptive));
    auto cheapest = [&](const std::vector<Best> &all) {
        const Best *best = nullptr;
        for (const Best &b : all)
            if (b.rms <= reached && (!best || b.seconds < best->seconds)) best = &b;
        return best ? *best : all[0];
    };
    Best u = cheapest(uniform), a = cheapest(adaptive);
    study.advice.push_back("Elements: " + std::string(a.seconds < u.seconds ? "adaptive" : "uniform") + ": " +
                           std::to_string(a.elements) + " adaptive ones are " + shown(a.rms) +
                           " % off after " + shown(a.seconds) + " s, " + std::to_string(u.elements) +
                           " uniform ones " + shown(u.rms) + " % after " + shown(u.seconds) + " s.");
}

} // namespace odraz::radiosity
