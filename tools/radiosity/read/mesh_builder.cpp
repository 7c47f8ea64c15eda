#include "tools/radiosity/read/mesh_builder.h"

#include "tools/common/statistics.h"
#include "tools/common/text.h"
#include "tools/radiosity/read/triangulator.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace odraz::radiosity {

// Adds notes about used materials that are black. If all are black, they become grey.
static void noteBlack(std::vector<MeshMaterial> &materials, const std::vector<bool> &used,
                      const std::string &path, std::vector<std::string> &notes) {
    std::vector<MeshMaterial *> black;
    int visible = 0;
    for (size_t i = 0; i < used.size(); ++i) {
        MeshMaterial &m = materials[i];
        auto none = [](const std::array<float, 3> &c) { return c[0] + c[1] + c[2] == 0; };
        if (!used[i]) continue;
        if (none(m.reflects) && none(m.emits) && !m.hasPicture())
            black.push_back(&m);
        else
            ++visible;
    }
    for (MeshMaterial *m : black) {
        notes.push_back(path + ": material " + m->name +
                        (visible ? " stays black: it reflects nothing diffusely, like a mirror or glass"
                                 : ": no material reflects light, so it is set to 0.7"));
        if (!visible) m->reflects = {0.7f, 0.7f, 0.7f};
    }
}

void setColours(MeshMaterial &m, const std::array<double, 3> &reflects, const std::array<double, 3> &emits,
                const std::array<const char *, 2> &names, const std::string &path,
                std::vector<std::string> &notes) {
    const std::string start = path + ": material " + m.name + ": ";
    bool above = false;
    for (size_t k = 0; k < 3; ++k) {
        if (!(reflects[k] >= 0 && reflects[k] <= kMostPower))
            throw ModelError(start + names[0] + " must lie between 0 and 1");
        if (!(emits[k] >= 0 && emits[k] <= kMostPower))
            throw ModelError(start + names[1] + " must lie between 0 and 1e12");
        above |= reflects[k] > 1;
        m.reflects[k] = (float)std::min(reflects[k], 1.), m.emits[k] = (float)emits[k];
    }
    if (above) notes.push_back(start + "its " + names[0] + " is above 1, and counts as 1");
}

void noteKinds(const std::string &path, const NotedKinds &kinds, std::vector<std::string> &notes) {
    for (const auto &[kind, what] : kinds) {
        const size_t more = std::set<std::string>(what.begin(), what.end()).size() - 1;
        notes.push_back(path + ": " + kind + ": " + what[0] +
                        (more ? " and " + std::to_string(more) + " more" : ""));
    }
}

namespace {

using Indices = std::array<int, 3>;
struct Hash {
    size_t operator()(const Indices &i) const {
        return std::hash<std::string_view>()({(const char *)i.data(), sizeof i});
    }
};

class MeshBuilder {
public:
    MeshBuilder(const std::string &path, Polygons &&given, const ReadSettings &settings,
                std::vector<std::string> &notes)
        : path(path), settings(settings), notes(notes), given(std::move(given)) {}

    Mesh build(std::vector<MeshMaterial> &&materials) {
        mesh.materials = std::move(materials), mesh.objects = std::move(given.objects);
        for (const MeshMaterial &m : mesh.materials) pictured |= m.hasPicture();
        weldPoints();
        collectTriangles();
        dropDuplicates();
        overlaps = cutOverlaps(mesh, polygonOf, grid * 2);
        if (mesh.triangles.empty()) throw ModelError(path + ": holds no polygon with an area");
        divideByEmission(mesh, notes);
        std::vector<bool> used(mesh.materials.size());
        for (const Triangle &t : mesh.triangles) used[(size_t)t.material] = true;
        noteBlack(mesh.materials, used, path, notes);
        changeMaterials(mesh.materials, used, settings.changes);
        noteLeftOut();
        return std::move(mesh);
    }

private:
    const std::string &path;
    const ReadSettings &settings;
    std::vector<std::string> &notes;
    Polygons given;
    Mesh mesh;
    double grid = 0;            // points closer than this are merged
    std::vector<int> number;    // for each point of the file: its point in the mesh
    std::vector<int> polygonOf; // for each triangle; ~polygon if its own triangles may overlap
    std::vector<int> crossing;  // polygons that cross themselves
    std::set<PolygonPair> overlaps;
    std::set<int> unplaced; // materials of polygons that lack texture coordinates
    int shortPolygons = 0;  // polygons with fewer than three points
    bool pictured = false;  // a material has a picture, so texture coordinates are kept

    // The size and the first corner of a small polygon: the 1/16 quantile by size of up to 4096 polygons.
    std::pair<double, size_t> smallPolygon() const {
        std::vector<std::pair<double, size_t>> sizes = {{HUGE_VAL, 0}};
        const auto &all = given.polygons;
        auto point = [&](size_t corner) { return given.points[(size_t)given.corners[corner].point]; };
        for (size_t i = 0; i < all.size(); i += 1 + all.size() / 4096) {
            size_t first = all[i].firstCorner,
                   end = i + 1 < all.size() ? all[i + 1].firstCorner : given.corners.size();
            double size = 0;
            for (size_t k = first; k < end; ++k) size = std::max(size, length(point(k) - point(first)));
            if (size > 0) sizes.push_back({size, first});
        }
        return common::quantile(sizes, 1. / 16);
    }

    // Merges points closer than a millionth of the model's size, or a hundredth of a small polygon's.
    void weldPoints() {
        if (given.points.empty()) throw ModelError(path + ": holds no point");
        if (given.corners.empty()) throw ModelError(path + ": holds no polygon");
        // Move points that no polygon uses, which may be anywhere, to one that is used
        std::vector<bool> used(given.points.size());
        for (const Polygons::Corner &c : given.corners) used[(size_t)c.point] = true;
        const Vec3d some = given.points[(size_t)given.corners[0].point];
        for (size_t i = 0; i < used.size(); ++i)
            given.points[i] = (used[i] ? given.points[i] : some) * settings.scale;
        auto [lo, hi] = boxOf(given.points);
        double size = length(hi - lo);
        if (!(size < 1e9)) throw ModelError(path + ": is larger than 1e9: give --scale");
        if (size > 0 && size < 1e-10) throw ModelError(path + ": is smaller than 1e-10: give --scale");
        auto [small, corner] = smallPolygon();
        grid = std::max({std::min(size * 1e-6, small * 1e-2), size * 1e-9, 1e-300});
        // Place the origin near the model, where floats are finest
        Vec3d middle = (lo + hi) / 2;
        if (small < size * 1e-4)
            mesh.origin = toFloat(given.points[(size_t)given.corners[corner].point]);
        else if (length(middle) >= 4 * size)
            mesh.origin = toFloat(middle);
        if (!(length(middle) < 1e15)) throw ModelError(path + ": lies further than 1e15 from the origin");
        if (size < length(middle) * 1e-11)
            notes.push_back(path + ": lies too far from the origin for precise coordinates: move it closer");
        // Merge points in the same cell of the grid
        std::unordered_map<Indices, int, Hash> pointIn;
        pointIn.reserve(given.points.size()), number.reserve(given.points.size());
        for (const Vec3d &p : given.points) {
            Indices cell;
            for (size_t k = 0; k < 3; ++k) cell[k] = (int)std::lround((p[k] - lo[k]) / grid);
            auto [entry, added] = pointIn.try_emplace(cell, (int)mesh.points.size());
            if (added) mesh.points.push_back(p - toDouble(mesh.origin));
            number.push_back(entry->second);
        }
        given.points = {};
    }

    void collectTriangles() {
        const int materials = (int)mesh.materials.size();
        bool plain = false; // whether a triangle has no material
        Triangulator triangulator;
        std::vector<Polygons::Corner> corners; // corners of the polygon, without repetitions
        std::vector<Vec3d> points;
        for (size_t i = 0; i < given.polygons.size(); ++i) {
            const Polygons::Polygon &p = given.polygons[i];
            size_t end = i + 1 < given.polygons.size() ? given.polygons[i + 1].firstCorner
                                                       : given.corners.size(),
                   count = end - p.firstCorner;
            if (count < 3) {
                ++shortPolygons;
                continue;
            }
            corners.clear(), points.clear();
            for (size_t k = p.firstCorner; k < end; ++k) {
                Polygons::Corner corner = given.corners[k];
                corner.point = number[(size_t)corner.point];
                if (!corners.empty() && corner.point == corners.back().point) continue;
                corners.push_back(corner);
            }
            while (corners.size() > 1 && corners.back().point == corners[0].point) corners.pop_back();
            for (const Polygons::Corner &c : corners) points.push_back(mesh.points[(size_t)c.point]);
            triangulator.triangles.clear();
            if (corners.size() > 2) triangulator.divide(points, grid * 2);
            const bool crosses = corners.size() > 2 && triangulator.crosses;
            if (crosses) crossing.push_back((int)i);
            mesh.flat += (int)(count - 2 - triangulator.triangles.size());
            plain |= p.material < 0;
            for (const auto &triangle : triangulator.triangles)
                add(corners, triangle, p.material < 0 ? materials : p.material, p.object);
            // Do not cut a large polygon that crosses itself: too many of its triangles overlap
            polygonOf.resize(mesh.triangles.size(), crosses && count < 1000 ? ~(int)i : (int)i);
        }
        if (plain) mesh.materials.push_back({"(none)", {0.7f, 0.7f, 0.7f}, {}}); // for polygons without one
    }

    void add(const std::vector<Polygons::Corner> &corners, const std::array<int, 3> &which, int material,
             int object) {
        Triangle t = {{}, material, object};
        std::array<float, 6> at;
        bool placed = true;
        for (size_t k = 0; k < 3; ++k) {
            const Polygons::Corner &corner = corners[(size_t)which[k]];
            t.corners[k] = corner.point;
            if (!pictured) continue;
            bool has = corner.coordinate >= 0 && (size_t)corner.coordinate < given.coordinates.size();
            for (size_t c = 0; c < 2; ++c)
                at[2 * k + c] = has ? given.coordinates[(size_t)corner.coordinate][c] : NAN;
            placed &= !std::isnan(at[2 * k]);
        }
        if (isFlat(t)) {
            ++mesh.flat;
            return;
        }
        if (!placed) unplaced.insert(material);
        mesh.triangles.push_back(t);
        if (pictured) mesh.coordinates.push_back(at);
        if (!settings.twoSided &&
            !((size_t)material < mesh.materials.size() && mesh.materials[(size_t)material].twoSided))
            return;
        std::swap(t.corners[1], t.corners[2]);
        mesh.triangles.push_back(t);
        if (pictured) mesh.coordinates.push_back({at[0], at[1], at[4], at[5], at[2], at[3]});
    }

    // Whether the triangle's height is less than two steps of the grid.
    bool isFlat(const Triangle &t) const {
        auto [a, b, c] = cornersOf(mesh, t);
        const double longest = std::max({length(b - a), length(c - b), length(a - c)});
        return !(length(normalOf(mesh, t)) > longest * grid * 2);
    }

    // Drops triangles that have the same corners in the same order as an earlier one.
    void dropDuplicates() {
        using Key = std::pair<Indices, int>; // corners, the smallest first; triangle
        std::vector<Key> keys;
        for (const Triangle &t : mesh.triangles) {
            auto c = t.corners;
            std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
            keys.push_back({c, (int)keys.size()});
        }
        std::sort(keys.begin(), keys.end());
        std::vector<bool> drop(keys.size());
        for (size_t i = 1; i < keys.size(); ++i)
            if (keys[i].first == keys[i - 1].first) drop[(size_t)keys[i].second] = true, ++mesh.duplicates;
        size_t kept = 0;
        for (size_t i = 0; i < drop.size(); ++i)
            if (!drop[i]) {
                if (pictured) mesh.coordinates[kept] = mesh.coordinates[i];
                polygonOf[kept] = polygonOf[i];
                mesh.triangles[kept++] = mesh.triangles[i];
            }
        mesh.triangles.resize(kept), polygonOf.resize(kept);
        if (pictured) mesh.coordinates.resize(kept);
    }

    void noteLeftOut() {
        auto note = [&](int count, const char *what, const char *which) {
            if (count) notes.push_back(path + ": left out " + common::counted((size_t)count, what) + which);
        };
        note(shortPolygons, "polygon", " with fewer than three points");
        note(mesh.flat, "triangle", " without area");
        note(mesh.duplicates, "triangle", " given twice");
        std::vector<std::string> lines;
        for (int i : crossing) lines.push_back(lineOf(i));
        noteLines("polygons cross themselves, and may be lit wrongly: ", lines);
        lines.clear();
        for (int m : unplaced)
            if (mesh.materials[(size_t)m].hasPicture()) lines.push_back(mesh.materials[(size_t)m].name);
        noteLines("coordinates of pictures are missing, so their mean colours are used: ", lines);
        lines.clear();
        for (auto [front, behind] : overlaps)
            if (front != behind) lines.push_back(lineOf(behind) + " behind " + lineOf(front));
        noteLines("polygons overlap in one plane, and the first is in front: ", lines);
    }

    void noteLines(const std::string &what, const std::vector<std::string> &lines) {
        constexpr size_t kMost = 5;
        std::string text;
        for (size_t i = 0; i < std::min(lines.size(), kMost); ++i) text += (i ? ", " : "") + lines[i];
        if (lines.size() > kMost) text += " and " + std::to_string(lines.size() - kMost) + " more";
        if (!lines.empty()) notes.push_back(path + ": " + what + text);
    }

    // A polygon's line and material.
    std::string lineOf(int polygon) const {
        const Polygons::Polygon &p = given.polygons[(size_t)(polygon < 0 ? ~polygon : polygon)];
        return given.unit + (" " + std::to_string(p.line)) + " (" +
               (p.material < 0 ? std::string("none") : mesh.materials[(size_t)p.material].name) + ")";
    }
};

} // namespace

Mesh buildMesh(const std::string &path, Polygons polygons, std::vector<MeshMaterial> materials,
               const ReadSettings &settings, std::vector<std::string> &notes) {
    return MeshBuilder(path, std::move(polygons), settings, notes).build(std::move(materials));
}

} // namespace odraz::radiosity
