// Measures the hall's transfer in two ways: its rows as a matrix that is compressed by several methods, and
// its light against radiosity solutions made for exactly that light.
#pragma once

#include "tools/measure/oracle/reference_hall.h"
#include "tools/radiosity/transfer/clustered_pca.h"
#include "tools/radiosity/transfer/clusters.h"

#include <memory>
#include <string>
#include <vector>

namespace odraz::measure {

// A row for each texel. The columns are red, green and blue of each light basis; those of the sky and the
// strips include direct light. Skies, suns and lamps are scaled to have equal weight.
struct TransferRows {
    int rows, columns;
    std::vector<float> data;
};
TransferRows rowsOf(const SolvedHall &hall, bool suns);
// Blocks of the hall's texels (clusters.h); a right angle counts like several metres.
inline std::vector<int> blocksOf(const Model &m, int count) {
    return radiosity::blocksOf({m.texels, (size_t)m.texelCount}, m.charts, count, 6);
}

struct Compressed {
    std::unique_ptr<HeapArena> memory;
    radiosity::ClusteredPca pca;
    double seconds;      // of processor time
    double errorPercent; // of the whole matrix, Frobenius norm
    size_t bytes() const {
        return ((size_t)pca.clusters * (size_t)(1 + pca.dimensions) * (size_t)pca.columns +
                (size_t)pca.rows * (size_t)pca.dimensions) *
               sizeof(float);
    }
};
Compressed compressed(const TransferRows &rows, const std::vector<int> &seeds,
                      const radiosity::PcaSettings &settings, Workers &workers);

// Light from compressed rows. `light` has the weight of each column; each plane has one value for each row.
void relightRows(const radiosity::ClusteredPca &pca, const float *light, float *const plane[3]);

// The relit hall's errors over the day. Each reference is solved for the exact sky and sun of its hour, from
// the same form factors.
struct DayError {
    float hour;
    int bands;              // how many bands of the sky are used
    double lightmap, whole; // rms, percent: of the light in the lightmap; of all light, the sun's included
};
std::vector<DayError> dayErrors(const std::vector<float> &hours, const std::vector<int> &bands, const Gl &gl,
                                Workers &workers);

} // namespace odraz::measure
