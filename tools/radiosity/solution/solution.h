// A solved model: its charts, elements and light, in memory and as a .rad file.
//
// Light is irradiance / pi, radiosity is given as radiance; both are linear red, green and blue. Light is
// kept at texels, the corners of cells, and is bilinear within a cell. METHOD.md describes the file.
#pragma once

#include "radiosity/model.h"
#include "tools/engine/vec3d.h"

#include <functional>
#include <string>
#include <vector>

namespace odraz::radiosity {

// A point of an element's outline, and the radiosity there.
struct SolutionPoint {
    Vec3 p;
    Rgb radiosity;
};

struct Solution {
    Vec3 place = {}; // the origin of its coordinates in the model's; files and options have the model's
    std::vector<Chart> charts;
    std::vector<Facet> facets;
    std::vector<Cell> cells;
    std::vector<Texel> texels;
    std::vector<Rgb> light;           // that arrives at each texel
    std::vector<Rgb> reflects, emits; // of each chart; the mean if its material has a picture
    std::vector<Rgb> cellReflects;    // of each cell; empty if no material has a picture
    std::vector<int> material; // for each chart: where its material's name begins in `names`; empty: unknown
    std::vector<char> names;   // materials' names, each with a 0 behind it
    std::vector<Rgb> gloss;    // for each texel: radiance that a polished surface sends to one eye; usually
                               // empty, not in files

    Solution() = default;
    // Reads a file. Throws std::runtime_error, with the file's name first, if it cannot be read or is not
    // valid().
    explicit Solution(const std::string &path);
    // Writes beside the file and renames. Throws likewise, also if it is not valid().
    void save(const std::string &path) const;
    // Appends the arrays of a file; reads them from `at` on. False if they are damaged or not valid().
    void put(std::string &to) const;
    bool get(const std::string &from, size_t &at);
    // The bytes of a file whose part after the checksum is `body`.
    static std::string withChecksum(const std::string &body);

    // Visits the convex outline of every element's part on each facet.
    void forPieces(
        const std::function<void(int chart, int cell, const std::vector<SolutionPoint> &)> &visit) const;

    // A point in the model's coordinates, and the digits that it needs as text.
    Vec3d inModel(const Vec3 &p) const { return toDouble(place) + toDouble(p); }
    int digits() const { return digitsAt(place); }
    static int digitsAt(const Vec3 &place) { return length(place) > 0 ? 13 : 7; }

    // The name of a chart's material, in printable characters; empty if it is not known.
    std::string materialOf(int chart) const;

    // The number of elements with at least one piece.
    size_t elements() const;

    // The share of light that a cell reflects.
    Rgb reflectsOf(int cell) const;
    // Light and radiosity at a point in the cell; u and v in world units along the chart's axes.
    Rgb lightIn(int cell, float u, float v) const;
    Rgb radiosityIn(int cell, float u, float v) const;
    // The same at a point of a chart.
    Rgb lightAt(int chart, const Vec3 &p) const;
    Rgb radiosityAt(int chart, const Vec3 &p) const;

private:
    Rgb bilinear(const std::vector<Rgb> &of, int cell, float u, float v) const;
    struct Spot {
        int cell;
        float u, v;
    };
    Spot spotAt(int chart, const Vec3 &p) const;
};

// The area of pieces, and the integrals of the place and the radiosity over it.
struct PieceSum {
    double area = 0, p[3] = {}, radiosity[3] = {};
    void add(const std::vector<SolutionPoint> &piece);
};

// Whether a solution is safe to use: every index lies within its list, every number is finite and below 1e18,
// no cell is its own descendant. A checksum is not enough for files, because a forger can compute it.
bool valid(const Solution &solution);

} // namespace odraz::radiosity
