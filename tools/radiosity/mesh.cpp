#include "tools/radiosity/mesh.h"

#include "tools/common/whole_file.h"

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

std::string at(const std::string &path, size_t line) { return path + ":" + std::to_string(line) + ": "; }

// tinyobjloader reads what it can and forgets where it stood. So the text is looked through first for what
// would be read wrongly, and said with its line.
struct Text {
    std::string all;
    bool materials = false;

    // Lines end with LF, CR LF, or CR alone; after this with LF, so that the parser sees the same ones
    explicit Text(std::string read) : all(std::move(read)) {
        for (size_t i = 0; i < all.size(); ++i)
            if (all[i] == '\r')
                all[i] = i + 1 < all.size() && all[i + 1] == '\n' ? ' ' : '\n';
            else if (all[i] == 0)
                all[i] = ' '; // the parser would end its line there
    }

    void check(const std::string &path) {
        std::istringstream in(all);
        std::string line;
        size_t number = 0;
        long points = 0;
        while (std::getline(in, line)) {
            ++number;
            const char *p = line.c_str();
            while (*p == ' ' || *p == '\t') ++p;
            if (p[0] == 'v' && (p[1] == ' ' || p[1] == '\t')) {
                ++points;
                ++p;
                for (int k = 0; k < 3; ++k) {
                    char *end;
                    double x = std::strtod(p, &end);
                    if (end == p) throw ModelError(at(path, number) + "a point needs three coordinates");
                    if (!(std::fabs(x) < 1e18))
                        throw ModelError(at(path, number) + "a coordinate is not a number below 1e18");
                    p = end;
                }
            } else if (p[0] == 'f' && (p[1] == ' ' || p[1] == '\t')) {
                int corners = 0;
                for (++p;; ++corners) {
                    char *end;
                    long index = std::strtol(p, &end, 10);
                    if (end == p) break;
                    if (index == 0 || index > points || index < -points)
                        throw ModelError(at(path, number) + "there is no point " + std::to_string(index) +
                                         " before this polygon");
                    for (p = end; *p && *p != ' ' && *p != '\t'; ++p) {
                    }
                }
                if (corners < 3) throw ModelError(at(path, number) + "a polygon needs three points");
            } else if (!std::strncmp(p, "mtllib", 6)) {
                materials = true;
            }
        }
    }
};

// Materials out of regular files alone.
struct Materials : tinyobj::MaterialReader {
    std::string folder;

    explicit Materials(const std::string &path) : folder(path.substr(0, path.rfind('/') + 1)) {}
    bool operator()(const std::string &name, std::vector<tinyobj::material_t> *materials,
                    std::map<std::string, int> *numbers, std::string *warning, std::string *) override {
        try {
            std::istringstream in(Text(odraz::readWhole(folder + name)).all);
            std::string wrong;
            tinyobj::LoadMtl(numbers, materials, &in, warning, &wrong);
            return true;
        } catch (const odraz::Refused &e) {
            *warning += e.what();
            return false;
        }
    }
};

} // namespace

Vec3d normalOf(const Mesh &m, const Triangle &t) {
    Vec3d a = m.points[(size_t)t.corners[0]];
    return cross(m.points[(size_t)t.corners[1]] - a, m.points[(size_t)t.corners[2]] - a);
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

Mesh readObj(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes) {
    Text text{odraz::readWhole(path)};
    text.check(path);

    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::istringstream stream(text.all);
    std::string warning, error;
    Materials reader(path);
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream, &reader, true))
        throw ModelError(path + ": is not a model: " + error.substr(0, error.find('\n')));
    if (attributes.vertices.empty()) throw ModelError(path + ": holds no point");
    if (text.materials && materials.empty())
        notes.push_back(path + ": its materials cannot be read: " + warning.substr(0, warning.find('\n')));

    Mesh mesh;
    bool plain = false;
    for (const auto &m : materials) {
        MeshMaterial to = {m.name, {}, {}};
        // Before there was Ke, lamps were written with an ambient colour above 1
        const float *shines = m.emission;
        float ambient = std::max({m.ambient[0], m.ambient[1], m.ambient[2]});
        if (ambient > 1 && m.emission[0] + m.emission[1] + m.emission[2] == 0) {
            shines = m.ambient;
            notes.push_back(path + ": material " + m.name + ": its Ka above 1 is taken for Ke");
        }
        for (size_t k = 0; k < 3; ++k) {
            double reflects = (double)m.diffuse[k], emits = (double)shines[k];
            if (!(reflects >= 0 && reflects <= 1) || !(emits >= 0 && emits < 1e12))
                throw ModelError(path + ": material " + m.name +
                                 ": Kd must lie between 0 and 1, Ke must not be negative");
            to.reflects[k] = (float)reflects, to.emits[k] = (float)emits;
        }
        mesh.materials.push_back(to);
    }

    // Weld points that lie within a millionth of the model's size
    size_t count = attributes.vertices.size() / 3;
    std::vector<Vec3d> given(count);
    for (size_t i = 0; i < count; ++i)
        for (size_t k = 0; k < 3; ++k) given[i][k] = (double)attributes.vertices[3 * i + k] * settings.scale;
    Vec3d lo, hi;
    std::tie(lo, hi) = boxOf(given);
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
    std::vector<std::array<int, 4>> seen;
    for (const auto &shape : shapes)
        for (size_t i = 0; i < shape.mesh.indices.size() / 3; ++i) {
            Triangle t = {};
            for (size_t k = 0; k < 3; ++k) {
                size_t index = (size_t)shape.mesh.indices[3 * i + k].vertex_index;
                if (index >= count) throw ModelError(path + ": a polygon has a point that is not there");
                t.corners[k] = number[index];
            }
            t.material = i < shape.mesh.material_ids.size() ? shape.mesh.material_ids[i] : -1;
            if (t.material < 0 || t.material >= (int)materials.size())
                t.material = (int)materials.size(), plain = true;
            double longest = 0;
            for (size_t k = 0; k < 3; ++k)
                longest = std::max(longest, length(mesh.points[(size_t)t.corners[k]] -
                                                   mesh.points[(size_t)t.corners[(k + 1) % 3]]));
            if (!(length(normalOf(mesh, t)) > longest * grid * 2)) { // lower than two grid steps
                ++mesh.flat;
                continue;
            }
            mesh.triangles.push_back(t);
            if (settings.twoSided) {
                std::swap(t.corners[1], t.corners[2]);
                mesh.triangles.push_back(t);
            }
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
        if (!drop[i]) mesh.triangles[kept++] = mesh.triangles[i];
    mesh.triangles.resize(kept);
    if (mesh.triangles.empty()) throw ModelError(path + ": holds no polygon with an area");
    std::vector<bool> used(mesh.materials.size());
    for (const Triangle &t : mesh.triangles) used[(size_t)t.material] = true;
    for (size_t i = 0; i < used.size(); ++i) {
        const MeshMaterial &m = mesh.materials[i];
        auto none = [](const std::array<float, 3> &c) { return c[0] + c[1] + c[2] == 0; };
        if (used[i] && none(m.reflects) && none(m.emits))
            notes.push_back(path + ": material " + m.name +
                            " stays black: its Kd is 0, as mirrors' and glass's are");
    }
    if (mesh.flat)
        notes.push_back(path + ": " + std::to_string(mesh.flat) + " triangles without area left out");
    if (mesh.twice)
        notes.push_back(path + ": " + std::to_string(mesh.twice) + " triangles given twice left out");
    return mesh;
}
