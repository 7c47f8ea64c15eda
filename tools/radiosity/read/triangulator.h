// Divides a polygon into triangles by cutting off its ears (Meisters, "Polygons Have Ears", 1975). The
// corners are projected along an axis and become whole numbers of 50 bits, so that every decision is exact
// and the same wherever the polygon lies. Holes may be joined to the outline by a bridge.
#pragma once

#include "tools/engine/vec3d.h"

#include <array>
#include <cstdint>
#include <vector>

namespace odraz::radiosity {

class Triangulator {
public:
    // Divides a polygon of at least three corners; neighbours must differ. Avoids triangles lower than
    // `least`. The time for N corners is about N log N.
    void divide(const std::vector<Vec3d> &corners, double least);

    std::vector<std::array<int, 3>> triangles; // indices of corners; all face the same way as the polygon
    bool crosses = false;                      // the polygon crosses itself

private:
    using Area = __int128;
    struct Point {
        int64_t x, y;
        bool operator==(const Point &) const = default;
    };
    // Which corners may be cut off, from the best to those that only polygons with crossings need: ears that
    // are not thin; any ears; corners without area; any convex corners; any
    enum Choice { kGood, kThin, kFlat, kConvex, kAny };

    std::vector<Point> points;
    std::vector<int> before, after; // the neighbours that are left; -1: the corner is cut off
    int left = 0;                   // corners that are left
    std::vector<int> reflex;        // corners that may lie in an ear, by cells of a grid
    std::vector<int> firstInCell;
    int64_t side = 1; // cells along each axis
    double thin = 0;  // spikes that are thinner have no area

    void project(const std::vector<Vec3d> &corners, double least);
    Area twiceArea(int a, int b, int c) const;
    bool divideQuad(const std::vector<Vec3d> &corners);
    void linkCorners();
    void cutOff(int corner);
    bool isSpike(int corner) const;
    void cutSpikes(int corner);
    int turns() const;
    bool crossesItself() const;
    int64_t cellOf(int64_t x) const;
    void findReflex();
    bool isEar(int corner, Choice choice) const;
    bool blocks(int reflex, int a, int b, int c) const;
    void cutEars();
    void flipFlat(const std::vector<Vec3d> &corners, double least);
};

} // namespace odraz::radiosity
