// A solved model: its charts, elements and light, in memory and as a .rad file.
//
// Light is irradiance / pi, radiosity is shown as radiance; both are red, green and blue, linear. Light is
// kept at texels, the corners of cells, and is bilinear within a cell. README.md describes the file.
#pragma once

#include "radiosity/model.h"

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
    std::vector<Chart> charts;
    std::vector<Facet> facets;
    std::vector<Cell> cells;
    std::vector<Texel> texels;
    std::vector<Rgb> light;           // of each texel: what arrives
    std::vector<Rgb> reflects, emits; // of each chart; a mean where its material has a picture
    std::vector<Rgb> cellReflects;    // of each cell; empty where no material has a picture
    std::vector<Rgb>
        gloss; // of each texel: what a polish sends to one eye, as radiance; mostly empty. Files lack it

    Solution() = default;
    // Reads a file. Throws std::runtime_error with a line that begins with the file's name where it cannot be
    // read or is not valid().
    explicit Solution(const std::string &path);
    // Writes beside the file and renames. Throws likewise.
    void save(const std::string &path) const;
    // Appends the arrays of a file, and reads them from `at` on; false if they cannot be worked with.
    void put(std::string &to) const;
    bool get(const std::string &from, size_t &at);
    // The bytes of a file whose part behind the checksum is `body`.
    static std::string withChecksum(const std::string &body);

    // Visits the part of every element that lies on each facet: a convex outline. Where a neighbour is
    // divided more finely, its corners on the common side are points of the outline too.
    void forPieces(
        const std::function<void(int chart, int cell, const std::vector<SolutionPoint> &)> &visit) const;

    // How many elements have at least one piece.
    size_t elements() const;

    // Share of light that a cell reflects.
    Rgb reflectsOf(int cell) const;
    // Light and radiosity at a place of the cell's chart that lies in the cell; u and v in world units along
    // the chart's axes.
    Rgb lightIn(int cell, float u, float v) const;
    Rgb radiosityIn(int cell, float u, float v) const;
    // The same at a place of a chart.
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

// Whether a solution can be worked with: every index lies within its list, every number is finite and below
// 1e18, no cell is its own descendant. Files need this besides their checksum, which a forger can compute.
bool valid(const Solution &solution);
// The same for a model that is divided but has no light yet.
bool validGeometry(const std::vector<Chart> &charts, const std::vector<Facet> &facets,
                   const std::vector<Cell> &cells, const std::vector<Texel> &texels);

// The checksum that a solution's file has in its head. Throws std::runtime_error if it is none.
uint64_t sumOfSolution(const std::string &path);

} // namespace odraz::radiosity
