// A model solved once for all lights: the light, with all bounces, that each function of the bands and each
// lamp adds to each texel. The light of any moment is a weighted sum of these (transfer/relight.h).
//
// A basis is one light. The first bands x bands bases are the bands' functions, with radiance 1 times the
// function; the others are the lamps at full strength in their colours. Planes hold irradiance / pi, as in
// Solution. The clusters are the compressed planes. Both are stored, and either can be shown.
#pragma once

#include "radiosity/light_bases.h"
#include "tools/radiosity/solution/solution.h"
#include "tools/radiosity/transfer/bands.h"
#include "tools/radiosity/transfer/clusters.h"
#include "tools/radiosity/transfer/gloss.h"

#include <string>
#include <vector>

namespace odraz::radiosity {

// The first line of a file.
inline constexpr char kTransferMagic[] = "odraz transfer 6\n";

struct TransferRoom {
    int bands = 0; // 1 .. kMostBands
    bool upIsZ = false;
    Solution model;                 // without light; `emits` has each lamp at full strength
    std::vector<std::string> lamps; // names of the lamps, up to kMaxLamps
    std::vector<int> lampOf;        // the lamp that each chart belongs to; -1: none
    std::vector<float> planes;      // [bases][3][stride()]
    Clusters clusters;
    std::vector<GlossyChart> gloss; // the glossy material's charts; may be empty
    float polish = kPolish;         // the polish's reflectance as seen from above (gloss.h)

    int functions() const { return bands * bands; }
    int bases() const { return functions() + (int)lamps.size(); }
    // Padded columns of a texel's row; the column of a basis and channel is 3 * basis + channel.
    int columns() const { return (3 * bases() + 7) & ~7; }
    size_t texels() const { return model.texels.size(); }
    size_t stride() const { return (texels() + 15) & ~(size_t)7; } // floats in a plane
    float *plane(int basis, int channel) { return &planes[((size_t)basis * 3 + (size_t)channel) * stride()]; }
    const float *plane(int basis, int channel) const {
        return const_cast<TransferRoom *>(this)->plane(basis, channel);
    }

    // The planes as a matrix for compression: [texels][columns()].
    std::vector<float> rows() const;

    // Reads a file. Throws std::runtime_error, with the file's name first.
    static TransferRoom read(const std::string &path);
    // Whether a file begins like a room file.
    static bool is(const std::string &path);
    // Writes a temporary file next to `path` and renames it. Throws likewise.
    void save(const std::string &path) const;
};

} // namespace odraz::radiosity
