// hall_light: compares the film's hall with path tracing, finds what its errors come from, and measures
// settings.
#include "tools/common/command_line.h"
#include "tools/common/statistics.h"
#include "tools/common/whole_file.h"
#include "tools/measure/reference/hall_paths.h"
#include "tools/picture/plot.h"
#include "tools/support/machine.h"

#include <cmath>
#include <cstdio>

namespace odraz::measure {

namespace {

using namespace radiosity;

struct HallSetting {
    int px = kHallSettings.px, block = kHallSettings.block;
    float residual = kHallSettings.residual;
    float cells = 1; // factor for the number of cells along each side of a chart
    bool traced = false;

    bool operator==(const HallSetting &) const = default;
};
constexpr float kExact = 1e-6f; // a residual that leaves no error

// The share of texels, in percent, that are off by more than 5 % of the reference.
double shareOff(const std::vector<float> &values, const std::vector<float> &reference) {
    int off = 0;
    for (size_t i = 0; i < values.size(); ++i)
        off += std::fabs(values[i] - reference[i]) > 0.05f * reference[i];
    return 100. * off / (double)values.size();
}

class HallMeasure {
public:
    HallMeasure(int count, int side)
        : gl(openGl()), workers(allProcessors()), shipped(solved({})), lights(lightsOf(*shipped.hall)),
          texels(placeTexels(*shipped.hall, count)) {
        for (const LightOfHall &light : lights)
            paths.push_back(tracedLight(*shipped.hall, *shipped.scene, light, texels, side, workers));
    }

    void printErrors() const {
        std::printf(
            "| %zu texels | reflected light: rms %% | 95 of 100 below %% | more than 5 %% off, %% | mean "
            "%% | noise of the paths | all light: rms %% | 95 of 100 below %% |\n"
            "|---|---|---|---|---|---|---|---|\n",
            texels.size());
        for (size_t i = 0; i < lights.size(); ++i) {
            TexelLight found = at(shipped, i);
            MeshErrors reflected = reflectedErrors(found, i),
                       all = errorsOf(found.all, paths[i].all, paths[i].noise2);
            std::printf("| %s | %.2f | %.1f | %.1f | %+.2f | %.2f | %.2f | %.1f |\n", lights[i].name.c_str(),
                        reflected.rms, reflected.worst20, shareOff(found.reflected, paths[i].reflected),
                        reflected.bias, reflected.noise, all.rms, all.worst20);
        }
    }

    // Improves one thing at a time. The differences are the errors that each of them causes.
    void printCauses() {
        std::printf("\n| reflected light, rms %% | noon | evening | lanterns | strips | the point |\n"
                    "|---|---|---|---|---|---|\n");
        SolvedHall exact = solved({.residual = kExact}), fine = solved({.px = 48, .residual = kExact});
        print("the residual", shipped, exact);
        print("the raster, against 128 pixels", exact, solved({.px = 128, .residual = kExact}));
        print("elements, against half as wide ones", fine,
              solved({.px = 48, .block = 2 * kHallSettings.block, .residual = kExact, .cells = 2}));
        SolvedHall half = solved({.px = 48, .residual = kExact, .cells = 2});
        print("patches, against half as wide ones", fine, half);
        std::printf("| the rest: half as wide patches, against paths |");
        for (size_t i = 0; i < lights.size(); ++i)
            std::printf(" %.2f |", reflectedErrors(at(half, i), i).rms);
        std::printf("\n");
        printHidden();
    }

    // Prints the errors and times of settings, and writes a plot.
    void printTrade(const std::string &file) {
        pictures::Plot plot = {
            .title = "the hall's reflected light at noon and in the evening: error against time",
            .xName = "processor time of solving, s",
            .yName = "rms error against path tracing, %",
            .series = {"OpenGL", "rays"},
            .points = {},
            .logarithmicX = true,
            .logarithmicY = true};
        std::printf(
            "\n| pixels | cells along a patch | samples in it | patches | noon, rms %% | evening, rms %% | s "
            "by OpenGL | s by rays |\n|---|---|---|---|---|---|---|---|\n");
        auto tryAll = [&](std::initializer_list<int> rasters, int block, float cells = 1) {
            for (int px : rasters) printSetting({.px = px, .block = block, .cells = cells}, plot);
        };
        tryAll({8, 16, 24, 32, 48, 64}, 2);
        tryAll({8, 16}, 1), tryAll({16, 24, 32}, 3), tryAll({16, 32}, 4);
        // The patches that ship, with other cells in them
        tryAll({16}, 1, 0.5f), tryAll({16}, 4, 2);
        common::writeWhole(file, pictures::svg(plot));
    }

private:
    Gl gl;
    Workers workers;
    SolvedHall shipped;
    std::vector<LightOfHall> lights;
    std::vector<HallTexel> texels;
    std::vector<TexelLight> paths; // an entry for each light

    SolvedHall solved(const HallSetting &s) {
        RadiositySettings settings = kHallSettings;
        settings.px = s.px, settings.block = s.block, settings.residual = s.residual;
        settings.links = (size_t)80 << 20;
        return {settings,
                s.traced ? kTracedHemicubes : kDrawnHemicubes,
                gl,
                workers,
                (size_t)2 << 30,
                [&](Hall &hall) {
                    for (int i = 0; i < hall.model.chartCount; ++i) {
                        Chart &c = hall.model.charts[i];
                        c.across = (int16_t)std::lround((float)c.across * s.cells);
                        c.down = (int16_t)std::lround((float)c.down * s.cells);
                    }
                }};
    }
    TexelLight at(const SolvedHall &solved, size_t light) const {
        return solvedLight(*solved.hall, lights[light], texels, paths[light].drawn);
    }
    MeshErrors reflectedErrors(const TexelLight &found, size_t light) const {
        return errorsOf(found.reflected, paths[light].reflected, paths[light].reflectedNoise2);
    }
    void print(const char *what, const SolvedHall &a, const SolvedHall &b) const {
        std::printf("| %s |", what);
        for (size_t i = 0; i < lights.size(); ++i)
            std::printf(" %.2f |", errorsOf(at(a, i).reflected, at(b, i).reflected).rms);
        std::printf("\n");
        std::fflush(stdout);
    }
    // Prints how much of the others' view hidden patches fill: patches of which no sample point is visible.
    void printHidden() const {
        const Model &m = shipped.hall->model;
        auto hidden = [&](int i) { return m.patches[i].share == 0 && !m.charts[m.patches[i].chart].open; };
        double sum = 0, most = 0;
        int count = 0, rows = 0;
        for (int i = 0; i < m.patchCount; ++i) {
            const FormFactorRow &row = shipped.hall->radiosity.factors.rows[i];
            count += hidden(i);
            if (!row.known) continue;
            double share = 0;
            for (int k = 0; k < row.count; ++k)
                share += hidden((int)row.links[k].patch) ? (double)row.links[k].share : 0;
            sum += share, most = std::fmax(most, share), ++rows;
        }
        std::printf("\n%d of %d patches show no sample point and are lit as their neighbours. They fill %.2f "
                    "%% of the "
                    "others' view, %.1f %% at most.\n",
                    count, m.patchCount, 100 * sum / rows, 100 * most);
    }
    // Solves by OpenGL and by rays. The error is OpenGL's: that of rays differs by less than the paths'
    // noise.
    void printSetting(HallSetting s, pictures::Plot &plot) {
        bool ships = s == HallSetting();
        double noon = 0, evening = 0, seconds[2];
        int patches = 0, samples = 4 * s.block * s.block;
        for (bool traced : {false, true}) {
            s.traced = traced;
            SolvedHall hall = solved(s);
            if (!traced)
                noon = reflectedErrors(at(hall, 0), 0).rms, evening = reflectedErrors(at(hall, 1), 1).rms;
            patches = hall.hall->model.patchCount, seconds[traced] = hall.seconds;
            plot.points.push_back({hall.seconds, std::sqrt((noon * noon + evening * evening) / 2),
                                   std::to_string(s.px) + " pixels, " + std::to_string(patches) +
                                       " patches, " + std::to_string(samples) + " samples",
                                   ships && !traced, traced});
        }
        const char *mark = ships ? "**" : "", *wide = s.cells == 1  ? ""
                                                      : s.cells < 1 ? ", twice as wide"
                                                                    : ", half as wide";
        std::printf("| %s%d%s | %s%d%s%s | %d | %d | %.2f | %.2f | %.2f | %.2f |\n", mark, s.px, mark, mark,
                    s.block, mark, wide, samples, patches, noon, evening, seconds[0], seconds[1]);
        std::fflush(stdout);
    }
};

int run(common::CommandLine &line) {
    int texels = 1500, side = 24;
    bool causes = false;
    std::string trade;
    line.about("Compares the light of the film's hall with path tracing. Prints tables in "
               "Markdown.");
    line.option("--texels", "N", texels, {10, 100000}, "compare at about N texels");
    line.option("--side", "N", side, {2, 4096}, "trace two sets of N x N paths from each sample point");
    line.flag("--causes", causes, "find what the errors come from");
    line.option("--trade", "FILE", trade,
                "measure other rasters and patches, and write a plot of them, an SVG");
    line.parse();
    HallMeasure measure(texels, side);
    measure.printErrors();
    if (causes) measure.printCauses();
    if (!trade.empty()) measure.printTrade(trade);
    return 0;
}

} // namespace

} // namespace odraz::measure

int main(int argc, char **argv) { return common::runProgram("hall_light", argc, argv, odraz::measure::run); }
