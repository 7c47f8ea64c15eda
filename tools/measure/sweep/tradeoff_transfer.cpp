#include "tools/common/clock.h"
#include "tools/common/machine.h"
#include "tools/measure/oracle/transfer.h"
#include "tools/measure/sweep/tradeoff.h"

#include <cmath>

using namespace odraz;

namespace {

struct TransferTable : Table {
    TransferTable()
        : Table("method,bands,clusters,dimensions,shipped,bytes,relight_ms,error_percent",
                {"transfer: PCA, fixed blocks and clustered PCA",
                 "relighting, ms",
                 "error, %",
                 {"pca", "blocks", "cpca", "floor blocks", "floor cpca"},
                 {},
                 true,
                 true,
                 true,
                 true}) {
        plot.frontOfEach = true;
    }
    void put(const char *method, int bands, int clusters, int dimensions, bool shipped, size_t bytes,
             double ms, double error, int series) {
        row("%s,%d,%d,%d,%d,%zu,%.4f,%.3f", method, bands, clusters, dimensions, shipped, bytes, ms, error);
        std::string name = std::to_string(clusters) + " x " + std::to_string(dimensions);
        if (series >= 0 && error > 0) plot.points.push_back({ms, error, name, shipped, series});
    }
};

// The light of an hour, of all lanterns, or of all strips.
LightVector lightOf(int which) {
    HallLight light = {(float)std::min(which, kHours - 1), {}, {}, 1};
    if (which == kHours)
        for (float &lantern : light.lanterns) lantern = 1;
    if (which == kHours + 1)
        for (float &strip : light.strips) strip = 1;
    return lightVector(light);
}

void sweepRows(TransferTable &table, const SolvedHall &solved, const Sweep &sweep, Workers &workers) {
    const Hall &hall = *solved.hall;
    size_t texels = (size_t)hall.model.texelCount;
    TexelPlanes planes(hall.model.texelCount);
    LightVector noon = lightOf(kNoon);
    TransferRows rows = rowsOf(solved, false);
    table.put("uncompressed", kBands, 0, 0, true, texels * (size_t)rows.columns * sizeof(float),
              medianMs([&] { relight(hall.radiosity, hall.model, noon, planes.plane); }), 0, -1);
    std::vector<float> light((size_t)rows.columns, 1.f);
    auto measure = [&](const char *method, PcaSettings settings, int series) {
        Compressed c = compressed(rows, blocksOf(hall.model, settings.clusters), settings, workers);
        double ms = medianMs([&] { relightRows(c.pca, light.data(), planes.plane); });
        table.put(method, kBands, settings.clusters, settings.dimensions, false, c.bytes(), ms,
                  c.errorPercent, series);
    };
    std::vector<int> dimensions = {8, 16, 24, 32}, clusters = {16, 64, 256};
    if (sweep.quick) dimensions = {8, 16}, clusters = {64};
    for (int d : dimensions)
        measure("pca", {.clusters = 1, .dimensions = d, .rounds = 0, .iterations = 12}, 0);
    for (int k : clusters)
        for (int d : dimensions) {
            measure("blocks", {.clusters = k, .dimensions = d, .rounds = 0, .iterations = 8}, 1);
            measure("cpca", {.clusters = k, .dimensions = d, .rounds = 4, .iterations = 4}, 2);
        }
}

// The floor's gloss as the eye sees it under all lights, compared with uncompressed matrices.
void sweepFloor(TransferTable &table, SolvedHall &solved, const Sweep &sweep, Workers &workers) {
    Hall &hall = *solved.hall;
    constexpr int kLights = kHours + 2;
    Vec3 eye = {3, 1.55f, 3};
    std::vector<float> exact[kLights];
    auto measure = [&](const char *method, PcaSettings settings, bool shipped, int series) {
        HeapArena own((size_t)64 << 20);
        GlossySettings glossy;
        glossy.pca = settings;
        solved.polish(glossy, own.arena, workers);
        const Glossy &floor = hall.gloss;
        double error = 0, all = 0;
        for (int i = 0; i < kLights; ++i) {
            relightGlossy(floor, lightOf(i), eye, 0.06f, 1);
            std::vector<float> got;
            for (const float *plane : floor.plane)
                got.insert(got.end(), plane, plane + floor.across * floor.down);
            if (!settings.dimensions) exact[i] = got;
            double e = 0, a = 0;
            for (size_t k = 0; k < got.size(); ++k) {
                e += std::pow((double)(got[k] - exact[i][k]), 2);
                a += std::pow((double)exact[i][k], 2);
            }
            error += e / a, all += 1;
        }
        LightVector noon = lightOf(kNoon);
        double ms = medianMs([&] { relightGlossy(floor, noon, eye, 0.06f, 1); });
        size_t rows = (size_t)settings.clusters * (size_t)(1 + settings.dimensions),
               width = (size_t)floor.pca.columns;
        table.put(method, kBands, settings.dimensions ? settings.clusters : 0, settings.dimensions, shipped,
                  (rows * width + (size_t)floor.pca.rows * (size_t)settings.dimensions) * sizeof(float), ms,
                  100 * std::sqrt(error / all), series);
    };
    PcaSettings uncompressed = uncompressedFloor(hall);
    measure("floor uncompressed", uncompressed, false, -1);
    PcaSettings shipped = GlossySettings().pca;
    measure("floor cpca", shipped, true, 4);
    std::vector<int> dimensions = {8, 16, 24, 32}, clusters = {1, 4, 8, 16};
    if (sweep.quick) dimensions = {16}, clusters = {1, 8};
    for (int k : clusters)
        for (int d : dimensions) {
            if (k * (1 + d) >= uncompressed.clusters) continue; // no saving
            measure("floor blocks", {.clusters = k, .dimensions = d, .rounds = 0}, false, 3);
            if (k > 1 && (k != shipped.clusters || d != shipped.dimensions))
                measure("floor cpca", {.clusters = k, .dimensions = d, .rounds = 3}, false, 4);
        }
}

} // namespace

void odraz::tradeoffTransfer(const Sweep &sweep) {
    TransferTable table;
    Gl gl = openGl();
    Workers workers = allProcessors();
    {
        SolvedHall solved(kHallSettings, gl, workers);
        sweepRows(table, solved, sweep, workers);
        sweepFloor(table, solved, sweep, workers);
    }
    // The error of the day's light with fewer bands, the sun's own light included
    std::vector<float> hours;
    for (int i = 0; i < kHours; ++i) hours.push_back((float)i);
    std::vector<int> bands = {1, 2, 3, 4, kBands};
    std::vector<DayError> errors = dayErrors(hours, bands, gl, workers);
    for (int used : bands) {
        double sum = 0;
        for (const DayError &e : errors)
            if (e.bands == used) sum += e.whole * e.whole;
        table.put("bands", used, 0, 0, used == kBands, 0, 0, std::sqrt(sum / (double)kHours), -1);
    }
    table.save(sweep);
}
