// Adaptive against uniform elements.
#include "tools/radiosity/study/study.h"

#include <algorithm>

namespace odraz {

void studyElements(Study &study) {
    Page &page = study.page;
    page.heading("Adaptive and uniform elements");
    Plot plot = {"elements: error against time",
                 "processor time, s",
                 "error (rms), %",
                 {"uniform", "adaptive"},
                 {},
                 true,
                 true};
    plot.frontOfEach = true;
    PageTable table = {"elements",
                       {"elements", "kind", "processor_s", "rms_percent", "median_percent"},
                       {"elements", "", "processor, s", "error (rms), %", "median, %"}};
    // Rows where they fit, else so many shots as do
    double hemicube = study.hemicubeSeconds(16), each = study.left() / 7, rest = each - study.divideSeconds();
    int shots = 0;
    if (1.5 * hemicube * study.patchesFor(6000) > rest)
        shots = (int)std::clamp(rest / 2 / std::max(hemicube, 1e-6), 50., 4000.);
    page.text(
        "Lamps are seen by shadow rays, patches by hemicubes of 16 pixels" +
        (shots ? "; " + std::to_string(shots) + " of them shoot the light, since all rows would take too long"
               : std::string()) +
        ". Adaptive solutions begin with elements of sixteen times the area and divide those over which "
        "direct light "
        "changes.");
    struct Best {
        double seconds, rms;
        size_t elements;
    };
    std::vector<Best> uniform, adaptive;
    double longest = 0;
    for (bool isAdaptive : {false, true})
        for (int elements :
             isAdaptive ? std::vector<int>{30000, 120000, 480000} : std::vector<int>{7500, 30000, 120000}) {
            std::string kind = isAdaptive ? "adaptive" : "uniform";
            if (!study.fits(longest)) {
                study.leftOut.push_back("elements: " + kind + ", " + std::to_string(elements));
                continue;
            }
            SolveSettings s = study.settings.solve;
            s.way = Way::kPatches;
            s.element = study.area / elements;
            s.adaptive = isAdaptive;
            s.shots = shots;
            std::string options = "--hemicube 16 --element " + shown(s.element, 6) +
                                  (isAdaptive ? " --adaptive" : "") +
                                  (shots ? " --shots " + std::to_string(shots) : "");
            Solved b = study.measure(std::to_string(elements) + " " + kind + " elements", options, s);
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
    if (uniform.empty() || adaptive.empty()) return;
    // The best uniform one, and the cheapest adaptive one that is as good
    constexpr double kAsGood = 1.05;
    auto less = [](const Best &a, const Best &b) { return a.rms < b.rms; };
    Best u = *std::min_element(uniform.begin(), uniform.end(), less),
         a = *std::min_element(adaptive.begin(), adaptive.end(), less);
    for (const Best &b : adaptive)
        if (b.rms <= kAsGood * u.rms && (a.rms > kAsGood * u.rms || b.seconds < a.seconds)) a = b;
    bool better = a.rms <= kAsGood * u.rms && a.seconds < u.seconds;
    study.advice.push_back("Elements: " + std::string(better ? "adaptive" : "uniform") + ": " +
                           std::to_string(a.elements) + " adaptive ones are " + shown(a.rms) +
                           " % off after " + shown(a.seconds) + " s, " + std::to_string(u.elements) +
                           " uniform ones " + shown(u.rms) + " % after " + shown(u.seconds) + " s.");
}

} // namespace odraz
