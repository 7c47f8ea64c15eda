// The hall's transfer, measured: its rows as a matrix, compressed in several ways, and its light against
// radiosity solutions made for that very light.
#pragma once

#include "tools/measure/reference_hall.h"

#include <memory>
#include <string>
#include <vector>

namespace odraz {

// Rows of texels: for each basis red, green and blue, the sky's with direct light, the strips' too; skies,
// suns and lamps scaled to weigh alike.
struct TransferRows {
    int rows, columns;
    std::vector<float> data;
};
TransferRows rowsOf(const SolvedHall &hall, bool suns);
// Texels divided into `clusters` blocks of as many, by where they are and what way they face.
std::vector<int> blocksOf(const Model &model, int clusters);

struct Compressed {
    std::unique_ptr<HeapArena> memory;
    ClusteredPca pca;
    double seconds;      // processor time
    double errorPercent; // of the matrix, Frobenius
    size_t bytes() const {
        return ((size_t)pca.clusters * (size_t)(1 + pca.dimensions) * (size_t)pca.columns +
                (size_t)pca.rows * (size_t)pca.dimensions) *
               sizeof(float);
    }
};
Compressed compressed(const TransferRows &rows, const std::vector<int> &seeds, const PcaSettings &settings,
                      Workers &workers);

// Light from compressed rows: `light` weighs their columns. Planes of as many texels as there are rows.
void relightRows(const ClusteredPca &pca, const float *light, float *const plane[3]);

// Solutions made for the very skies and suns of hours of the day, from the same form factors; and how far the
// relit hall is from them.
struct DayError {
    float hour;
    int bands;              // of the sky's that are used
    double lightmap, whole; // rms, percent of the light in the lightmap; with the sun's own light
};
std::vector<DayError> dayErrors(const std::vector<float> &hours, const std::vector<int> &bands, const Gl &gl,
                                Workers &workers);

// The floor's gloss without compression: a cluster for each of its squares.
PcaSettings uncompressedFloor(const Hall &hall);

} // namespace odraz
