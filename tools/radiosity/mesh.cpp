#include "tools/radiosity/mesh.h"

#include "tools/common/whole_file.h"
#include "tools/radiosity/mtl_reader.h"
#include "tools/radiosity/obj_text.h"

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <sstream>
#include <tuple>
#include <unordered_map>

using odraz::Vec3d;

namespace {

// Tells the parser which material is meant by a name of ObjText.
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

} // namespace

Vec3d normalOf(const Mesh &m, const Triangle &t) {
    Vec3d a = m.points[(size_t)t.corners[0]];
    return cross(m.points[(size_t)t.corners[1]] - a, m.points[(size_t)t.corners[2]] - a);
}

bool shines(const Mesh &m) {
    return std::any_of(m.triangles.begin(), m.triangles.end(), [&](const Triangle &t) {
        const auto &e = m.materials[(size_t)t.material].emits;
        return e[0] + e[1] + e[2] > 0;
    });
}

double areaOf(const Mesh &m) {
    double area = 0;
    for (const Triangle &t : m.triangles) area += length(normalOf(m, t)) / 2;
    return area;
}

static std::pair<Vec3d, Vec3d> boxOf(const std::vector<Vec3d> &points) {
    Vec3d lo = points.at(0), hi = lo;
    for (const Vec3d &p : points)
        for (size_t k = 0; k < 3; ++k) lo[k] = std::min(lo[k], p[k]), hi[k] = std::max(hi[k], p[k]);
    return {lo, hi};
}

double Mesh::size() const {
    auto [lo, hi] = boxOf(points);
    return length(hi - lo);
}

Vec3d Mesh::middle() const {
    auto [lo, hi] = boxOf(points);
    return (lo + hi) / 2;
}

// Of materials that can only be black. Where all are, nothing could be seen: then they are grey.
static void noteBlack(Mesh &mesh, const std::string &path, std::vector<std::string> &notes) {
    std::vector<bool> used(mesh.materials.size());
    for (const Triangle &t : mesh.triangles) used[(size_t)t.material] = true;
    std::vector<MeshMaterial *> black;
    int seen = 0;
    for (size_t i = 0; i < used.size(); ++i) {
        MeshMaterial &m = mesh.materials[i];
        auto none = [](const std::array<float, 3> &c) { return c[0] + c[1] + c[2] == 0; };
        if (!used[i]) continue;
        if (none(m.reflects) && none(m.emits) && m.picture.path.empty())
            black.push_back(&m);
        else
            ++seen;
    }
    for (MeshMaterial *m : black) {
        notes.push_back(path + ": material " + m->name +
                        (seen ? " stays black: its Kd is 0, as mirrors' and glass's are"
                              : ": its Kd is 0, and everything would be black: it reflects 0.7"));
        if (!seen) m->reflects = {0.7f, 0.7f, 0.7f};
    }
}

Mesh readObj(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes) {
    ObjText text(path, odraz::readWhole(path));
    Mesh mesh;
    mesh.materials = readMaterials(path, text.libraries, notes);
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> unused;
    std::istringstream stream(text.all);
    std::string warning, error;
    Numbers numbers(text.used, mesh.materials);
    if (!tinyobj::LoadObj(&attributes, &shapes, &unused, &warning, &error, &stream, &numbers, true))
        throw ModelError(path + ": is not a model: " + error.substr(0, error.find('\n')));
    if (attributes.vertices.empty()) throw ModelError(path + ": holds no point");

    // Weld points that lie within a millionth of the model's size
    size_t count = attributes.vertices.size() / 3;
    std::vector<Vec3d> given(count);
    for (size_t i = 0; i < count; ++i)
        for (size_t k = 0; k < 3; ++k) given[i][k] = (double)attributes.vertices[3 * i + k] * settings.scale;
    Vec3d lo, hi;
    std::tie(lo, hi) = boxOf(given);
    if (!(length(hi - lo) < 1e9)) throw ModelError(path + ": is larger than 1e9: give --scale");
    if (double size = length(hi - lo); size > 0 && size < 1e-10)
        throw ModelError(path + ": is smaller than 1e-10: give --scale");
    double grid = std::max(length(hi - lo) * 1e-6, 1e-300);
    struct Hash {
        size_t operator()(const std::array<long, 3> &a) const {
            return (size_t)a[0] * 73856093u ^ (size_t)a[1] * 19349663u * 64 ^ (size_t)a[2] * 83492791u * 4096;
        }
    };
    std::unordered_map<std::array<long, 3>, int, Hash> known;
    known.reserve(count * 2);
    std::vector<int> number(count);
    for (size_t i = 0; i < count; ++i) {
        std::array<long, 3> cell;
        for (size_t k = 0; k < 3; ++k) cell[k] = std::lround((given[i][k] - lo[k]) / grid);
        auto [entry, added] = known.try_emplace(cell, (int)mesh.points.size());
        if (added) mesh.points.push_back(given[i]);
        number[i] = entry->second;
    }

    // Triangles, each once, and none without area
    int materials = (int)mesh.materials.size();
    bool plain = false, pictured = false;
    for (const MeshMaterial &m : mesh.materials) pictured |= !m.picture.path.empty();
    for (const auto &shape : shapes)
        for (size_t i = 0; i < shape.mesh.indices.size() / 3; ++i) {
            Triangle t = {};
            std::array<float, 6> at;
            for (size_t k = 0; k < 3; ++k) {
                const tinyobj::index_t &corner = shape.mesh.indices[3 * i + k];
                size_t index = (size_t)corner.vertex_index, place = (size_t)corner.texcoord_index * 2;
                if (index >= count) throw ModelError(path + ": a polygon has a point that is not there");
                t.corners[k] = number[index];
                bool known = corner.texcoord_index >= 0 && place + 1 < attributes.texcoords.size();
                for (size_t c = 0; c < 2; ++c) at[2 * k + c] = known ? attributes.texcoords[place + c] : NAN;
            }
            t.material = i < shape.mesh.material_ids.size() ? shape.mesh.material_ids[i] : -1;
            if (t.material < 0 || t.material >= materials) t.material = materials, plain = true;
            double longest = 0;
            for (size_t k = 0; k < 3; ++k)
                longest = std::max(longest, length(mesh.points[(size_t)t.corners[k]] -
                                                   mesh.points[(size_t)t.corners[(k + 1) % 3]]));
            if (!(length(normalOf(mesh, t)) > longest * grid * 2)) { // lower than two grid steps
                ++mesh.flat;
                continue;
            }
            mesh.triangles.push_back(t);
            if (pictured) mesh.coordinates.push_back(at);
            if (!settings.twoSided) continue;
            std::swap(t.corners[1], t.corners[2]);
            mesh.triangles.push_back(t);
            if (pictured) mesh.coordinates.push_back({at[0], at[1], at[4], at[5], at[2], at[3]});
        }
    if (plain) mesh.materials.push_back({"(none)", {0.7f, 0.7f, 0.7f}, {}});
    auto key = [&](size_t i) { // turned so that the least corner is first
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
    if (mesh.triangles.empty()) throw ModelError(path + ": holds no polygon with an area");
    noteBlack(mesh, path, notes);
    if (text.shortPolygons)
        notes.push_back(path + ": " + std::to_string(text.shortPolygons) +
                        " polygons of less than three points left out");
    if (mesh.flat)
        notes.push_back(path + ": " + std::to_string(mesh.flat) + " triangles without area left out");
    if (mesh.twice)
        notes.push_back(path + ": " + std::to_string(mesh.twice) + " triangles given twice left out");
    return mesh;
}
