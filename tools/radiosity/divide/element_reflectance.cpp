#include "tools/radiosity/divide/element_reflectance.h"

#include "tools/picture/picture_file.h"
#include "tools/radiosity/divide/facets.h"
#include "tools/radiosity/read/reflectance_picture.h"

#include <algorithm>
#include <map>

namespace odraz::radiosity {

namespace {

// A triangle on its chart, and its texture coordinates there.
class ChartTriangle {
public:
    ChartTriangle(const Mesh &mesh, size_t number, const Chart &c, const MeshPicture &picture) {
        const std::array<Vec3d, 3> points = cornersOf(mesh, mesh.triangles[number]);
        for (size_t k = 0; k < 3; ++k) {
            const Vec3d from = points[k] - toDouble(c.corner);
            corners.push_back({(float)dot(from, toDouble(c.u)), (float)dot(from, toDouble(c.v))});
            for (size_t i = 0; i < 2; ++i)
                at[k][i] = (double)mesh.coordinates[number][k * 2 + i] * (double)picture.scale[i] +
                           (double)picture.offset[i];
        }
        if (areaOf(corners) < 0) std::swap(corners[1], corners[2]), std::swap(at[1], at[2]);
        twice = 2 * areaOf(corners);
    }

    Outline corners; // counter-clockwise
    bool flat() const { return !(twice > 0); }

    TexturePoint coordinates(PlanePoint p) const {
        double share[3];
        for (size_t k = 0; k < 3; ++k) {
            PlanePoint a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
            share[k] = (((double)a.u - (double)p.u) * ((double)b.v - (double)p.v) -
                        ((double)b.u - (double)p.u) * ((double)a.v - (double)p.v)) /
                       twice;
        }
        return {share[0] * at[0][0] + share[1] * at[1][0] + share[2] * at[2][0],
                share[0] * at[0][1] + share[1] * at[1][1] + share[2] * at[2][1]};
    }

private:
    std::array<TexturePoint, 3> at;
    double twice; // twice the area
};

struct ColourSum {
    double area = 0;
    Vec3d light = {};
    void add(double part, const Rgb &c) { area += part, light = light + toDouble(c) * part; }
    void add(const ColourSum &s) { area += s.area, light = light + s.light; }
    Rgb mean() const { return toFloat(light / area); }
};

// Adds the part of a triangle inside a cell.
void addTo(ColourSum &sum, const Outline &cell, const ChartTriangle &t, const ReflectancePicture &texture,
           bool clamp) {
    Outline part = cell;
    for (size_t k = 0; k < 3 && part.size() > 2; ++k) part = cut(part, t.corners[k], t.corners[(k + 1) % 3]);
    if (part.size() < 3) return;
    double area = areaOf(part);
    if (!(area > 0)) return;
    std::vector<TexturePoint> covered;
    for (PlanePoint p : part) covered.push_back(t.coordinates(p));
    sum.add(area, texture.mean(covered, clamp));
}

// Adds a triangle to the cells that it touches.
void addTriangle(std::vector<ColourSum> &sums, const Chart &c, const ChartTriangle &t,
                 const ReflectancePicture &texture, bool clamp) {
    if (t.flat()) return;
    auto [left, right] = std::minmax({t.corners[0].u, t.corners[1].u, t.corners[2].u});
    auto [low, high] = std::minmax({t.corners[0].v, t.corners[1].v, t.corners[2].v});
    float cellWidth = c.width / (float)c.across, cellHeight = c.height / (float)c.down;
    auto first = [](float x, int count) { return std::clamp((int)x, 0, count - 1); };
    for (int y = first(low / cellHeight, c.down); y <= first(high / cellHeight, c.down); ++y)
        for (int x = first(left / cellWidth, c.across); x <= first(right / cellWidth, c.across); ++x) {
            float u0 = (float)x * cellWidth, v0 = (float)y * cellHeight, u1 = (float)(x + 1) * cellWidth,
                  v1 = (float)(y + 1) * cellHeight;
            addTo(sums[(size_t)(c.firstCell + y * c.across + x)], {{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}}, t,
                  texture, clamp);
        }
}

// The sum of the pictures' colours in each cell; empty if no picture can be read.
std::vector<ColourSum> sumPictures(const Mesh &mesh, const std::vector<int> &chartOf,
                                   std::span<const Chart> charts, std::span<const Cell> cells,
                                   std::vector<std::string> &notes) {
    // Read one picture at a time, to save memory
    std::map<std::string, std::vector<size_t>> trianglesOf; // by picture
    for (size_t i = 0; i < mesh.triangles.size() && !mesh.coordinates.empty(); ++i) {
        const std::string &path = mesh.materials[(size_t)mesh.triangles[i].material].picture.path;
        if (!path.empty() && chartOf[i] >= 0) trianglesOf[path].push_back(i);
    }
    std::vector<ColourSum> sums;
    for (const auto &[path, triangles] : trianglesOf) try {
            ReflectancePicture texture(
                mesh.materials[(size_t)mesh.triangles[triangles[0]].material].picture.read());
            sums.resize(cells.size());
            for (size_t i : triangles) {
                const Chart &c = charts[(size_t)chartOf[i]];
                const MeshPicture &picture = mesh.materials[(size_t)mesh.triangles[i].material].picture;
                addTriangle(sums, c, ChartTriangle(mesh, i, c, picture), texture, picture.clamp);
            }
        } catch (const common::Refused &e) {
            notes.push_back(std::string(e.what()) + "; the material's colour is used");
        }
    return sums;
}

} // namespace

void ElementReflectance::compute(const Mesh &mesh, const std::vector<int> &chartOf,
                                 std::span<const Chart> charts, std::span<const Cell> cells,
                                 std::vector<std::string> &notes) {
    ofCell.clear(), ofChart.clear();
    std::vector<ColourSum> sums = sumPictures(mesh, chartOf, charts, cells, notes);
    if (sums.empty()) return;
    std::vector<ColourSum> all(charts.size());
    for (size_t i = 0; i < sums.size(); ++i) all[(size_t)cells[i].chart].add(sums[i]);
    std::vector<const MeshMaterial *> material(charts.size());
    for (size_t i = 0; i < chartOf.size(); ++i)
        if (chartOf[i] >= 0)
            material[(size_t)chartOf[i]] = &mesh.materials[(size_t)mesh.triangles[i].material];
    // The colour of a part of a chart; `otherwise` if the picture does not cover it
    auto colourOf = [&](const ColourSum &sum, size_t chart, const Rgb &otherwise) {
        if (!(sum.area > 0)) return otherwise;
        const auto &tint = material[chart]->picture.tint;
        return sum.mean() * Rgb{tint[0], tint[1], tint[2]};
    };
    for (size_t i = 0; i < all.size(); ++i) {
        const auto kd =
            material[i] ? material[i]->reflects : std::array<float, 3>{}; // it may have no triangle
        ofChart.push_back(colourOf(all[i], i, {kd[0], kd[1], kd[2]}));
    }
    for (size_t i = 0; i < sums.size(); ++i) {
        const auto chart = (size_t)cells[i].chart;
        ofCell.push_back(colourOf(sums[i], chart, ofChart[chart]));
    }
}

void ElementReflectance::toPatches(Model &m) const {
    if (ofCell.empty()) return;
    std::vector<ColourSum> sums((size_t)m.patchCount);
    for (size_t i = 0; i < ofCell.size(); ++i) {
        const Cell &c = m.cells[i];
        int quarters = 0; // number of visible quarters of the cell
        for (int k = 0; k < 4; ++k) quarters += m.quarterVisible(c, k);
        if (quarters) sums[(size_t)c.patch].add((double)c.area * quarters, ofCell[i]);
    }
    for (int i = 0; i < m.patchCount; ++i)
        if (sums[(size_t)i].area > 0) m.patches[i].reflects = sums[(size_t)i].mean();
}

} // namespace odraz::radiosity
