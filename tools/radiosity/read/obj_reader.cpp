// Reads a Wavefront OBJ by tinyobjloader, after ObjText has prepared the text.
#include "tools/radiosity/read/obj_reader.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/read/mtl_reader.h"
#include "tools/radiosity/read/obj_text.h"

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>
#include <unordered_map>

namespace odraz::radiosity {

namespace {

// Returns to the parser the material for a name from ObjText.
struct Numbers : tinyobj::MaterialReader {
    std::map<std::string, int> all;

    Numbers(const std::vector<std::string> &used, const std::vector<MeshMaterial> &materials) {
        std::map<std::string, int> known;
        for (size_t i = 0; i < materials.size(); ++i) known.try_emplace(materials[i].name, (int)i);
        for (size_t i = 0; i < used.size(); ++i) {
            auto found = known.find(used[i]);
            if (found != known.end()) all[std::to_string(i)] = found->second;
        }
    }
    bool operator()(const std::string &, std::vector<tinyobj::material_t> *, std::map<std::string, int> *to,
                    std::string *, std::string *) override {
        *to = all;
        return true;
    }
};

constexpr char kNone[] = "(none)"; // the material of polygons without one
MeshMaterial noMaterial() { return {kNone, {0.7f, 0.7f, 0.7f}, {}}; }

// Adds notes about materials that are black. If all are, they become grey, because nothing would be visible.
void noteBlack(std::vector<MeshMaterial> &materials, const std::vector<bool> &used, const std::string &path,
               std::vector<std::string> &notes) {
    std::vector<MeshMaterial *> black;
    int seen = 0;
    for (size_t i = 0; i < used.size(); ++i) {
        MeshMaterial &m = materials[i];
        auto none = [](const std::array<float, 3> &c) { return c[0] + c[1] + c[2] == 0; };
        if (!used[i]) continue;
        if (none(m.reflects) && none(m.emits) && m.picture.path.empty())
            black.push_back(&m);
        else
            ++seen;
    }
    for (MeshMaterial *m : black) {
        notes.push_back(path + ": material " + m->name +
                        (seen ? " stays black: its Kd is 0, as it is for mirrors and glass"
                              : ": its Kd is 0, and everything would be black: it reflects 0.7"));
        if (!seen) m->reflects = {0.7f, 0.7f, 0.7f};
    }
}

// Turns a model from text into triangles, step by step.
class ObjReader {
public:
    ObjReader(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes)
        : path(path), settings(settings), notes(notes), text(path, common::readWhole(path)) {}

    Mesh read() {
        mesh.materials = readMaterials(path, text.libraries, notes);
        parse();
        weldPoints();
        collectTriangles();
        dropTwice();
        if (mesh.triangles.empty()) throw ModelError(path + ": holds no polygon with an area");
        std::vector<bool> used(mesh.materials.size());
        for (const Triangle &t : mesh.triangles) used[(size_t)t.material] = true;
        noteBlack(mesh.materials, used, path, notes);
        changeMaterials(mesh.materials, used, settings.changes);
        mesh.names.libraries = text.libraries, mesh.names.asked = text.used;
        for (const MeshMaterial &m : mesh.materials) mesh.names.all.push_back(m.name);
        mesh.names.used.assign(used.begin(), used.end());
        noteLeftOut();
        return std::move(mesh);
    }

private:
    const std::string &path;
    const ReadSettings &settings;
    std::vector<std::string> &notes;
    ObjText text;
    Mesh mesh;
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    double grid = 0;         // points closer than this are merged
    std::vector<int> number; // for each point of the file: its point in the mesh
    bool pictured = false;   // a material has a picture, so texture coordinates are kept

    void parse() {
        std::vector<tinyobj::material_t> unused;
        std::istringstream stream(text.all);
        std::string warning, error;
        Numbers numbers(text.used, mesh.materials);
        for (size_t i = 0; i < text.used.size(); ++i)
            mesh.names.known.push_back(numbers.all.count(std::to_string(i)) != 0);
        if (!tinyobj::LoadObj(&attributes, &shapes, &unused, &warning, &error, &stream, &numbers, true))
            throw ModelError(path + ": is not a model: " + error.substr(0, error.find('\n')));
        if (attributes.vertices.empty()) throw ModelError(path + ": holds no point");
        for (const MeshMaterial &m : mesh.materials) pictured |= !m.picture.path.empty();
    }

    // Merges points within a millionth of the model's size.
    void weldPoints() {
        size_t count = attributes.vertices.size() / 3;
        std::vector<Vec3d> given(count);
        for (size_t i = 0; i < count; ++i)
            for (size_t k = 0; k < 3; ++k)
                given[i][k] = (double)attributes.vertices[3 * i + k] * settings.scale;
        Vec3d lo, hi;
        std::tie(lo, hi) = boxOf(given);
        if (!(length(hi - lo) < 1e9)) throw ModelError(path + ": is larger than 1e9: give --scale");
        if (double size = length(hi - lo); size > 0 && size < 1e-10)
            throw ModelError(path + ": is smaller than 1e-10: give --scale");
        grid = std::max(length(hi - lo) * 1e-6, 1e-300);
        struct Hash {
            size_t operator()(const std::array<long, 3> &a) const {
                return (size_t)a[0] * 73856093u ^ (size_t)a[1] * 19349663u * 64 ^
                       (size_t)a[2] * 83492791u * 4096;
            }
        };
        std::unordered_map<std::array<long, 3>, int, Hash> known;
        known.reserve(count * 2);
        number.resize(count);
        for (size_t i = 0; i < count; ++i) {
            std::array<long, 3> cell;
            for (size_t k = 0; k < 3; ++k) cell[k] = std::lround((given[i][k] - lo[k]) / grid);
            auto [entry, added] = known.try_emplace(cell, (int)mesh.points.size());
            if (added) mesh.points.push_back(given[i]);
            number[i] = entry->second;
        }
    }

    void collectTriangles() {
        int materials = (int)mesh.materials.size();
        bool plain = false; // a triangle has no material
        for (const auto &shape : shapes)
            for (size_t i = 0; i < shape.mesh.indices.size() / 3; ++i) {
                Triangle t = {};
                std::array<float, 6> at = readCorners(&shape.mesh.indices[3 * i], t);
                t.material = i < shape.mesh.material_ids.size() ? shape.mesh.material_ids[i] : -1;
                if (t.material < 0 || t.material >= materials) t.material = materials, plain = true;
                if (isFlat(t))
                    ++mesh.flat;
                else
                    add(t, at);
            }
        if (plain) mesh.materials.push_back(noMaterial());
    }

    // Sets the points of a triangle; returns the texture coordinates of its corners.
    std::array<float, 6> readCorners(const tinyobj::index_t *corners, Triangle &t) const {
        std::array<float, 6> at;
        for (size_t k = 0; k < 3; ++k) {
            const tinyobj::index_t &corner = corners[k];
            size_t index = (size_t)corner.vertex_index, place = (size_t)corner.texcoord_index * 2;
            if (index >= number.size()) throw ModelError(path + ": a polygon has a point that is not there");
            t.corners[k] = number[index];
            bool known = corner.texcoord_index >= 0 && place + 1 < attributes.texcoords.size();
            for (size_t c = 0; c < 2; ++c) at[2 * k + c] = known ? attributes.texcoords[place + c] : NAN;
        }
        return at;
    }

    // Whether the triangle is less than two steps of the grid high.
    bool isFlat(const Triangle &t) const {
        double longest = 0;
        for (size_t k = 0; k < 3; ++k)
            longest = std::max(longest, length(mesh.points[(size_t)t.corners[k]] -
                                               mesh.points[(size_t)t.corners[(k + 1) % 3]]));
        return !(length(normalOf(mesh, t)) > longest * grid * 2);
    }

    void add(Triangle t, const std::array<float, 6> &at) {
        mesh.triangles.push_back(t);
        if (pictured) mesh.coordinates.push_back(at);
        if (!settings.twoSided) return;
        std::swap(t.corners[1], t.corners[2]);
        mesh.triangles.push_back(t);
        if (pictured) mesh.coordinates.push_back({at[0], at[1], at[4], at[5], at[2], at[3]});
    }

    // Keeps only the first of triangles with the same corners in the same direction.
    void dropTwice() {
        auto key = [&](size_t i) { // rotated so that the least corner is first
            auto c = mesh.triangles[i].corners;
            std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
            return c;
        };
        std::vector<size_t> order(mesh.triangles.size());
        for (size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
            auto x = key(a), y = key(b);
            return x != y ? x < y : a < b;
        });
        std::vector<bool> drop(order.size());
        for (size_t i = 1; i < order.size(); ++i)
            if (key(order[i]) == key(order[i - 1])) drop[order[i]] = true, ++mesh.twice;
        size_t kept = 0;
        for (size_t i = 0; i < order.size(); ++i)
            if (!drop[i]) {
                if (pictured) mesh.coordinates[kept] = mesh.coordinates[i];
                mesh.triangles[kept++] = mesh.triangles[i];
            }
        mesh.triangles.resize(kept);
        if (pictured) mesh.coordinates.resize(kept);
    }

    void noteLeftOut() {
        auto note = [&](int count, const char *what) {
            if (count) notes.push_back(path + ": " + std::to_string(count) + what);
        };
        note(text.shortPolygons, " polygons of less than three points left out");
        note(mesh.flat, " triangles without area left out");
        note(mesh.twice, " triangles given twice left out");
    }
};

} // namespace

Mesh readObj(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes) {
    return ObjReader(path, settings, notes).read();
}

std::vector<MeshMaterial> readObjMaterials(const std::string &path, const MaterialNames &names,
                                           const std::vector<MaterialChange> &changes,
                                           std::vector<std::string> &notes) {
    std::vector<MeshMaterial> given = readMaterials(path, names.libraries, notes);
    std::map<std::string, const MeshMaterial *> known;
    for (const MeshMaterial &m : given) known.try_emplace(m.name, &m);
    for (size_t i = 0; i < names.asked.size(); ++i)
        if ((known.count(names.asked[i]) != 0) != (names.known[i] != 0))
            throw ModelError(path + ": the material " + names.asked[i] +
                             (names.known[i] ? " is no longer in its files" : " is new in its files") +
                             ": solve the model again");
    std::vector<MeshMaterial> all;
    std::vector<bool> used(names.used.begin(), names.used.end());
    for (size_t i = 0; i < names.all.size(); ++i) {
        auto found = known.find(names.all[i]);
        all.push_back(!used[i]               ? MeshMaterial{names.all[i], {}, {}}
                      : found != known.end() ? *found->second
                                             : noMaterial());
    }
    noteBlack(all, used, path, notes);
    changeMaterials(all, used, changes);
    return all;
}

} // namespace odraz::radiosity
