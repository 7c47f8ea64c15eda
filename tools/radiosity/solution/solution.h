// A solved model: its charts, elements and light, in memory and as a .rad file.
//
// Light is irradiance / pi. Radiosity is given as radiance. Both are linear red, green and blue. Light is
// stored at texels, the corners of cells, and is bilinear within a cell. METHOD.md describes the file.
#pragma once

#include "radiosity/model.h"
#include "tools/support/vec3d.h"

#include <functional>
#include <string>
#include <vector>

namespace odraz::radiosity {

// A point of an element's outline, and the radiosity there.
struct SolutionPoint {
    Vec3 p;
    Rgb radiosity;
};

// The first line of a file.
inline constexpr char kSolutionMagic[] = "odraz radiosity 6\n";

struct Solution {
    Vec3 origin = {}; // in model coordinates, which files and options use; all points are relative to it
    std::vector<Chart> charts;
    std::vector<Facet> facets;
    std::vector<Cell> cells;
    std::vector<Texel> texels;
    std::vector<Rgb> light;           // light that arrives at each texel
    std::vector<Rgb> reflects, emits; // one per chart; the mean if its material has a picture
    std::vector<Rgb> cellReflects;    // one per cell; empty if no material has a picture
    // Per chart, the offset in `names` of its material's name, and of the model's names for the part to which
    // it belongs (OBJ's `o` and `g`); empty: unknown
    std::vector<int> material, object, group;
    std::vector<char> names; // each followed by a 0
    std::vector<Rgb> gloss;  // per texel, the radiance that a polished surface sends to one eye; usually
                             // empty, not in files

    Solution() = default;
    // Reads a file. Throws std::runtime_error, with the file's name first, also if it is not valid().
    explicit Solution(const std::string &path);
    // Writes a temporary file next to `path` and renames it. Throws likewise, also if it is not valid().
    void save(const std::string &path) const;
    // Appends the arrays of a file to `to`.
    void put(std::string &to) const;
    // Reads them from offset `at` on. False if they are damaged or not valid().
    bool get(const std::string &from, size_t &at);

    // Cuts every element by the facets that it overlaps, and visits the convex outline of each piece.
    void forPieces(
        const std::function<void(int chart, int cell, const std::vector<SolutionPoint> &)> &visit) const;

    // A point in model coordinates, and the number of digits that it needs as text.
    Vec3d inModel(const Vec3 &p) const { return toDouble(origin) + toDouble(p); }
    int digits() const { return digitsAt(origin); }
    static int digitsAt(const Vec3 &origin) { return length(origin) > 0 ? 13 : 7; }

    // The names of a chart's material, object and group, in printable characters; empty if unknown.
    std::string materialOf(int chart) const { return nameOf(material, chart); }
    std::string objectOf(int chart) const { return nameOf(object, chart); }
    std::string groupOf(int chart) const { return nameOf(group, chart); }

    // The number of elements with at least one piece.
    size_t elements() const;

    // A cell's reflectance.
    Rgb reflectsOf(int cell) const;
    // Light and radiosity at a point in a cell. u and v are in world units along the chart's axes.
    Rgb lightIn(int cell, float u, float v) const;
    Rgb radiosityIn(int cell, float u, float v) const;
    // Light and radiosity at a point on a chart.
    Rgb lightAt(int chart, const Vec3 &p) const;
    Rgb radiosityAt(int chart, const Vec3 &p) const;

    struct CellPoint {
        int cell;
        float u, v;
    };

private:
    std::string nameOf(const std::vector<int> &offsets, int chart) const;
    Rgb bilinear(const std::vector<Rgb> &texelValues, int cell, float u, float v) const;
    CellPoint cellPointAt(int chart, const Vec3 &p) const;
};

// The area of pieces, and the integrals of position and radiosity over that area.
struct PieceSum {
    double area = 0;
    Vec3d p = {}, radiosity = {};
    void add(const std::vector<SolutionPoint> &piece);
};

// Whether a solution is safe to use: every index lies within its list, and every number is finite and below
// 1e18. A checksum is not enough for files, because a forger can compute it.
bool valid(const Solution &solution);

} // namespace odraz::radiosity
