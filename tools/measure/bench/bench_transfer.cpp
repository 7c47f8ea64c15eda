// bench_transfer: times the hall's transfer, at start-up and per frame.
#include "tools/common/clock.h"
#include "tools/common/command_line.h"
#include "tools/common/statistics.h"
#include "tools/measure/reference/reference_hall.h"
#include "tools/support/machine.h"

#include <cstdio>

namespace odraz::measure {

namespace {

constexpr int kRounds = 5; // number of measured starts

// Times the steps of a solution by its progress reports.
struct StepClock {
    struct Step {
        const char *name;
        float end;
        double seconds;
    };
    std::vector<Step> steps = {{"elements", 0.05f, 0},
                               {"hemicubes, form factors", 0.635f, 0},
                               {"direct light", 0.92f, 0},
                               {"bounces of all bases", 0.965f, 0},
                               {"to the elements", 1, 0}};
    size_t now = 0;
    double last = common::processorSeconds();

    Progress progress() {
        return {[](float done, void *p) {
                    StepClock &c = *(StepClock *)p;
                    while (c.now < c.steps.size() && done >= c.steps[c.now].end - 1e-4f) {
                        double t = common::processorSeconds();
                        c.steps[c.now++].seconds = t - c.last;
                        c.last = t;
                    }
                },
                this};
    }
};

// Prints the time of each step of start-up, and returns the solved hall.
std::unique_ptr<SolvedHall> timeStartUp(const Gl &gl, Workers &workers) {
    std::vector<std::pair<std::string, std::vector<double>>> steps;
    for (const StepClock::Step &step : StepClock().steps) steps.push_back({step.name, {}});
    steps.push_back({"the floor's matrices", {}});
    std::unique_ptr<SolvedHall> solved;
    for (int round = 0; round < kRounds; ++round) {
        StepClock clock;
        solved = std::make_unique<SolvedHall>(kHallSettings, kDrawnHemicubes, gl, workers, kRoomBytes,
                                              nullptr, clock.progress());
        // The first step does not report its start, so it gets the time that the others leave
        clock.steps[0].seconds = solved->seconds;
        for (size_t i = 1; i < clock.steps.size(); ++i) clock.steps[0].seconds -= clock.steps[i].seconds;
        size_t at = 0;
        for (const StepClock::Step &step : clock.steps) steps[at++].second.push_back(step.seconds);
        HeapArena memory((size_t)64 << 20);
        double began = common::processorSeconds();
        solved->solveGloss(memory.arena, workers);
        steps[at].second.push_back(common::processorSeconds() - began);
    }
    const Hall &hall = *solved->hall;
    std::printf("%d texels, %d patches, %d lights, each in red, green and blue.\n\n"
                "| start-up | processor s, the median of %d |\n|---|---|\n",
                hall.model.texelCount, hall.model.patchCount, hall.radiosity.bases.count(), kRounds);
    double sum = 0;
    for (const auto &[name, times] : steps) {
        std::printf("| %s | %.3f |\n", name.c_str(), common::median(times));
        sum += common::median(times);
    }
    std::printf("| all | %.3f |\n", sum);
    return solved;
}

void timeRelighting(SolvedHall &solved, Workers &workers) {
    const Hall &hall = *solved.hall;
    TexelPlanes planes(hall.model.texelCount);
    HeapArena memory((size_t)64 << 20);
    solved.solveGloss(memory.arena, workers);
    std::printf("\n| a picture, ms of one thread | light vector | all texels | the floor's gloss |\n"
                "|---|---|---|---|\n");
    auto show = [&](const char *name, const HallLight &light) {
        LightVector v;
        double vector = common::medianMs([&] { v = lightVector(light); }),
               rows = common::medianMs([&] { relight(hall.radiosity, hall.model, v, planes.plane); }),
               floor = common::medianMs([&] {
                   relightGlossy(hall.gloss, v, {3, 1.55f, 3}, 0.06f, 1);
               });
        std::printf("| %s | %.3f | %.3f | %.3f |\n", name, vector, rows, floor);
    };
    show("noon", {kNoon, {}, {}, 1});
    show("three lanterns, night", {kNight, {1, 1, 1}, {}, 1});
    show("door of light, night", {kNight, {}, {1, 1, 1, 1, 1, 1, 1, 1}, 1});
}

int run(common::CommandLine &line) {
    line.about("Times the hall's transfer. Prints tables in Markdown.");
    line.parse();
    Gl gl = openGl();
    Workers workers = allProcessors();
    std::unique_ptr<SolvedHall> solved = timeStartUp(gl, workers);
    timeRelighting(*solved, workers);
    return 0;
}

} // namespace

} // namespace odraz::measure

int main(int argc, char **argv) {
    return common::runProgram("bench_transfer", argc, argv, odraz::measure::run);
}
