#include "tools/common/clock.h"
#include "tools/common/text.h"
#include "tools/engine/machine.h"
#include "tools/measure/oracle/transfer.h"
#include "tools/measure/sweep/tradeoff.h"

#include <cmath>

namespace odraz::measure {

using namespace radiosity;

namespace {

struct TransferTable : Table {
    TransferTable()
        : Table("method,bands,clusters,dimensions,shipped,bytes,relight_ms,error_percent",
                {"transfer: PCA, fixed blocks and clustered PCA",
                 "relighting, ms",
                 "error, %",
                 {"pca", "blocks", "cpca"},
                 {},
                 true,
                 true,
                 true,
                 true}) {
        plot.frontOfEach = true;
    }
    void put(const char *method, int bands, int clusters, int dimensions, bool shipped, size_t bytes,
             double ms, double error, int series) {
        row(common::format("%s,%d,%d,%d,%d,%zu,%.4f,%.3f", method, bands, clusters, dimensions, shipped,
                           bytes, ms, error));
        std::string name = std::to_string(clusters) + " x " + std::to_string(dimensions);
        if (series >= 0 && error > 0) plot.points.push_back({ms, error, name, shipped, series});
    }
};

void sweepRows(TransferTable &table, const SolvedHall &solved, const Sweep &sweep, Workers &workers) {
    const Hall &hall = *solved.hall;
    size_t texels = (size_t)hall.model.texelCount;
    TexelPlanes planes(hall.model.texelCount);
    LightVector noon = lightVector({kNoon, {}, {}, 1});
    TransferRows rows = rowsOf(solved, false);
    table.put("uncompressed", kBands, 0, 0, true, texels * (size_t)rows.columns * sizeof(float),
              common::medianMs([&] { relight(hall.radiosity, hall.model, noon, planes.plane); }), 0, -1);
    std::vector<float> light((size_t)rows.columns, 1.f);
    auto measure = [&](const char *method, PcaSettings settings, int series) {
        Compressed c = compressed(rows, blocksOf(hall.model, settings.clusters), settings, workers);
        double ms = common::medianMs([&] { relightRows(c.pca, light.data(), planes.plane); });
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

} // namespace

int tradeoffTransfer(common::CommandLine &line) {
    Sweep sweep;
    line.about("The hall's transfer, compressed: time of relighting against the error of the rows "
               "(Frobenius), and the\n"
               "day's light by fewer bands (rms).");
    sweep.read(line);
    TransferTable table;
    Gl gl = openGl();
    Workers workers = allProcessors();
    {
        SolvedHall solved(kHallSettings, gl, workers);
        sweepRows(table, solved, sweep, workers);
    }
    // The error of the day's light with fewer bands, the sun's own light included. The night has none
    std::vector<float> hours;
    for (int i = 0; i < kNight; ++i) hours.push_back((float)i);
    std::vector<int> bands = {1, 2, 3, 4, kBands};
    std::vector<DayError> errors = dayErrors(hours, bands, gl, workers);
    for (int used : bands) {
        double sum = 0;
        for (const DayError &e : errors)
            if (e.bands == used) sum += e.whole * e.whole;
        table.put("bands", used, 0, 0, used == kBands, 0, 0, std::sqrt(sum / (double)hours.size()), -1);
    }
    table.save(sweep);
    return 0;
}

} // namespace odraz::measure
