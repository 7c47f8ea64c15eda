// A model solved once for all lights: the light, with all bounces, that every band of an environment and
// every lamp brings to every texel. The light of any moment is then a weighted sum (transfer/relight.h).
//
// A basis is one light: first the bands' functions, bands x bands of them, with radiance 1 times the
// function; then the lamps at full strength in their colours. Planes hold irradiance / pi, as Solution does.
// The clusters are the compressed planes. Both are kept, and either can be shown.
#pragma once

#include "radiosity/light_bases.h"
#include "tools/radiosity/solution/solution.h"
#include "tools/radiosity/transfer/bands.h"
#include "tools/radiosity/transfer/clusters.h"
#include "tools/radiosity/transfer/gloss.h"

#include <string>
#include <vector>

namespace odraz::radiosity {

struct TransferRoom {
    int bands = 0; // 1 .. kMostBands
    bool upIsZ = false;
    Solution model;                 // without light; `emits` has every lamp at full strength
    std::vector<std::string> lamps; // their names, up to kMaxLamps
    std::vector<int> lampOf;        // of each chart: the lamp that it belongs to, or -1
    std::vector<float> planes;      // [bases][3][stride()]
    Clusters clusters;
    std::vector<GlossyChart> gloss; // of the glossy material's charts; may be empty
    float polish = kPolish;         // its reflectance as seen from above (gloss.h)

    int functions() const { return bands * bands; }
    int bases() const { return functions() + (int)lamps.size(); }
    int columns() const { return (3 * bases() + 7) & ~7; } // of a texel's row: 3 basis + channel, padded
    size_t texels() const { return model.texels.size(); }
    size_t stride() const { return (texels() + 15) & ~(size_t)7; } // of a plane
    float *plane(int basis, int channel) { return &planes[((size_t)basis * 3 + (size_t)channel) * stride()]; }
    const float *plane(int basis, int channel) const {
        return const_cast<TransferRoom *>(this)->plane(basis, channel);
    }

    // The planes as a matrix for the compression: [texels][columns()].
    std::vector<float> rows() const;

    // Reads a file. Throws std::runtime_error, with the file's name first, if it cannot be read or is
    // damaged.
    static TransferRoom read(const std::string &path);
    // Whether a file begins like a room's.
    static bool is(const std::string &path);
    // Writes beside the file and renames. Throws likewise.
    void save(const std::string &path) const;
    // The bytes of a file whose part after the checksum is `body`.
    static std::string withChecksum(const std::string &body);
};

} // namespace odraz::radiosity
