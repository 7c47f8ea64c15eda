// How fast radiosity is: hemicubes, and whole solutions of the thesis's sizes beside its table 4.1.
#include "tools/radiosity/generate.h"
#include "tools/measure/measured.h"
#include "tools/measure/reference_hall.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

using namespace odraz;

namespace {

double median(std::vector<double> v) {
    std::sort(v.begin(), v.end());
    return v[v.size() / 2];
}

// Milliseconds of all of the model's hemicubes, drawn and summed, each.
double hemicubeMs(const Model &m, const Gl &gl, int px) {
    std::vector<unsigned char> memory(hemicubeBytes(px) + 64);
    Arena arena = {memory.data() + (64 - (uintptr_t)memory.data() % 64), hemicubeBytes(px), 0};
    Hemicubes h;
    if (!openHemicubes(h, gl, arena, px)) throw std::runtime_error("no hemicubes here");
    std::vector<float> delta((size_t)(3 * px * px)), sums((size_t)(3 * px * (px + 1))),
        row((size_t)m.patchCount);
    deltaFormFactors(px, delta.data());
    accumulateFormFactors(px, delta.data(), sums.data());
    std::vector<Eye> eyes;
    for (int i = 0; i < m.patchCount; ++i)
        if (m.patches[i].share > 0 && !m.charts[m.patches[i].chart].open)
            eyes.push_back(hemicubeEye(m.patches[i].p, m.patches[i].n, (uint32_t)i));
    std::vector<double> times;
    for (int round = 0; round < 5; ++round) {
        double began = processorSeconds();
        for (size_t i = 0; i < eyes.size(); i += (size_t)h.batch) {
            int count = std::min((int)(eyes.size() - i), h.batch);
            drawHemicubes(h, m, &eyes[i], count);
            for (int k = 0; k < count; ++k) sumHemicube(h, k, sums.data(), row.data());
        }
        times.push_back((processorSeconds() - began) * 1e3 / (double)eyes.size());
    }
    closeHemicubes(h);
    return median(times);
}

// The thesis's table 4.1: its sizes, and seconds at 100 x 100 pixels.
struct Size {
    size_t triangles;
    double seconds;
};
constexpr Size kThesis[] = {{26360, 280}, {136512, 3500}, {546048, 34980}};

// The area that gives a model at least so many triangles.
double areaFor(const char *kind, size_t triangles) {
    double low = 1e-4, high = 10;
    for (int i = 0; i < 40; ++i) {
        double middle = std::sqrt(low * high);
        size_t count = 0;
        generateObj(kind, middle, &count);
        (count >= triangles ? low : high) = middle;
    }
    return low;
}

} // namespace

int main(int argc, char **argv) {
    bool quick = argc == 2 && !std::strcmp(argv[1], "--quick");
    if (argc > 1 && !quick) {
        std::fprintf(stderr, "usage: bench_radiosity [--quick]\n");
        return 2;
    }
    static const int never = 0;
    Gl gl;
    Workers workers;
    try {
        openAll(gl, workers);
        std::printf("hemicubes: processor ms each, with their rows\n%-28s %7s %7s %7s %7s\n", "", "16 px",
                    "32 px", "64 px", "128 px");
        SolvedHall hall(kHallSettings, gl, workers);
        auto line = [&](const char *name, const Model &m) {
            std::printf("%-28s", name);
            for (int px : {16, 32, 64, 128}) std::printf(" %7.3f", hemicubeMs(m, gl, px));
            std::printf("\n");
            std::fflush(stdout);
        };
        char name[60];
        std::snprintf(name, sizeof name, "the film's hall, %d polygons", hall.hall->model.facetCount);
        line(name, hall.hall->model);
        for (const char *kind : {"columns", "cube"}) {
            auto b = bake(generatedMesh(kind, 0), {}, gl, workers, &never, {});
            std::snprintf(name, sizeof name, "%s, %d polygons", kind, b->model->facetCount);
            line(name, *b->model);
        }
        std::printf("the film's hall as it ships: %.2f s\n\n", hall.seconds);

        std::printf(
            "whole solutions of \"columns\": processor seconds, reading left out; rms of 1000 places\n"
            "%9s %9s %9s %10s %8s %8s %12s\n",
            "triangles", "elements", "hemicubes", "thesis, s", "here, s", "rms, %", "us/triangle");
        auto solve = [&](const Mesh &mesh, double thesis, BakeSettings s) {
            std::vector<double> times;
            std::unique_ptr<Bake> b;
            for (int round = 0; round < (quick ? 1 : 3); ++round) {
                b.reset();
                b = bake(mesh, s, gl, workers, &never, {});
                times.push_back(b->seconds[4]);
            }
            double rms =
                quick ? 0 : rmsPercent(*b->model, b->light, referenceOf(mesh, gl, workers, 1000, false));
            char before[20];
            std::snprintf(before, sizeof before, thesis > 0 ? "%.0f" : "-", thesis);
            std::printf("%9zu %9d %9d %10s %8.2f %8.2f %12.2f\n", mesh.triangles.size(), b->model->cellCount,
                        b->rows, before, median(times), rms,
                        median(times) * 1e6 / (double)mesh.triangles.size());
            std::fflush(stdout);
        };
        for (const Size &row : kThesis) {
            if (quick && row.triangles > 30000) continue;
            Mesh mesh = generatedMesh("columns", areaFor("columns", row.triangles));
            BakeSettings s;
            // As many elements as there are triangles, or more
            s.element = areaOf(mesh) / (double)row.triangles / 1.1;
            s.memory = (size_t)8 << 30;
            solve(mesh, row.seconds, s);
        }
        std::printf("\na soup: \"cave\", no two triangles in one plane\n");
        solve(generatedMesh("cave", areaFor("cave", quick ? 2000 : 26000)), 0, {});
    } catch (const std::runtime_error &e) {
        std::fprintf(stderr, "bench_radiosity: %s\n", e.what());
        return 1;
    }
    return 0;
}
