#include "tools/radiosity/read/mesh_builder.h"

#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/read/gltf_materials.h"
#include "tools/radiosity/read/gltf_nodes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odraz::radiosity {

using common::need;

namespace {

constexpr size_t kMostTriangles = 1 << 26;
constexpr double kBallShare = 1e-3; // a lamp's diameter, as a share of the model's size
constexpr char kLights[] = "KHR_lights_punctual";
// FB_ngon_encoding only groups triangles, which are joined in any case
const std::set<std::string> kExtensions = {kLights,
                                           "KHR_materials_emissive_strength",
                                           "KHR_materials_unlit",
                                           "KHR_materials_pbrSpecularGlossiness",
                                           "KHR_mesh_quantization",
                                           "KHR_texture_transform",
                                           "FB_ngon_encoding"};
enum Mode { kTriangles = 4, kStrip, kFan };

class GltfReader {
public:
    GltfReader(const std::string &path, std::vector<std::string> &notes)
        : path(path), notes(notes), file(path) {
        polygons.unit = "triangle";
        checkExtensions();
        materials = readMaterials(file, path, kinds, notes);
    }

    std::vector<MeshMaterial> meshMaterials() {
        std::vector<MeshMaterial> all;
        for (const GltfMaterial &m : materials) all.push_back(m.mesh);
        return all;
    }

    void readScene() {
        nodes = findTransforms(file);
        if (const size_t scenes = file.root["scenes"].size(); scenes > 1)
            notes.push_back(path + ": one of its " + std::to_string(scenes) + " scenes is read");
        const json &all = objectsOf(extensionOf(file.root, kLights), "lights");
        for (int i : nodes.order) {
            const json &n = file.root["nodes"][(size_t)i];
            if (n.contains("mesh")) readMesh(n, i);
            if (const int light = indexOf(extensionOf(n, kLights), "light"); light >= 0)
                readLight(itemOf(all, light, "light"), nodes.transforms[(size_t)i]);
        }
        need(!polygons.polygons.empty(), "holds no triangle");
        addBalls();
        int animations = 0;
        for (const json &animation : file.root["animations"])
            kinds["animations are not used"].push_back(named("animation", animation, animations++));
        noteKinds(path, kinds, notes);
    }

    Polygons polygons;
    Surroundings lights;

private:
    const std::string &path;
    std::vector<std::string> &notes;
    GltfFile file;
    std::vector<GltfMaterial> materials;
    NotedKinds kinds;
    GltfNodes nodes;
    std::vector<std::pair<Vec3d, Vec3d>> bulbs; // point and spot lights: centre and candela
    int spots = 0;

    void checkExtensions() {
        auto names = [&](const char *list) { return valueOf(file.root, list, std::vector<std::string>()); };
        for (const std::string &name : names("extensionsRequired"))
            need(kExtensions.count(name),
                 "needs " + name + ", which is not read: export the model without it");
        for (const std::string &name : names("extensionsUsed"))
            if (!kExtensions.count(name)) kinds["extensions that are not used"].push_back(name);
    }

    // The items of an accessor, and their indices in `polygons`; -1: not added yet.
    struct Points {
        std::vector<double> given;
        std::vector<int> indices;
    };
    using Coordinates = Points;
    // The points of a node, by their accessor and those of morph targets
    using PointSets = std::map<std::pair<int, std::vector<int>>, Points>;

    void readMesh(const json &n, int node) {
        const int number = indexOf(n, "mesh");
        const json &mesh = itemOf(file.root["meshes"], number, "mesh");
        Transform transform = nodes.transforms[(size_t)node];
        if (n.contains("skin")) {
            // In the bind pose, all joints give the mesh the same transform: use the first
            const json &skin = itemOf(file.root["skins"], indexOf(n, "skin"), "skin");
            kinds["skins are not deformed: meshes keep their bind pose"].push_back(named("node", n, node));
            if (const auto joints = valueOf(skin, "joints", std::vector<int>()); !joints.empty()) {
                itemOf(file.root["nodes"], joints[0], "node");
                transform = nodes.transforms[(size_t)joints[0]];
                if (skin.contains("inverseBindMatrices")) {
                    auto bound = file.numbers(indexOf(skin, "inverseBindMatrices"), "MAT4");
                    need(bound.size() >= 16, "a skin has no matrix");
                    transform = transform * transformOf(bound.data());
                }
            }
        }
        const std::string name = textOf(n, "name");
        polygons.objects.push_back({name.empty() ? textOf(mesh, "name") : name, ""});
        const auto weights = valueOf(n, "weights", valueOf(mesh, "weights", std::vector<double>()));
        PointSets points;
        for (const json &p : objectsOf(mesh, "primitives"))
            readPrimitive(p, named("mesh", mesh, number), transform, weights, points);
    }

    // Adds the weighted morph targets, which are accessors or -1, to the points.
    void morph(const std::vector<int> &targets, const std::string &name, const std::vector<double> &weights,
               std::vector<double> &points) {
        for (size_t i = 0; i < std::min(weights.size(), targets.size()); ++i) {
            if (weights[i] == 0 || targets[i] < 0) continue;
            const std::vector<double> moved = file.numbers(targets[i], "VEC3");
            need(moved.size() == points.size(), name + " has a morph target with another number of points");
            for (size_t k = 0; k < moved.size(); ++k) points[k] += weights[i] * moved[k];
        }
    }

    void readPrimitive(const json &p, const std::string &name, const Transform &transform,
                       const std::vector<double> &weights, PointSets &pointSets) {
        const int mode = valueOf(p, "mode", (int)kTriangles);
        if (mode < kTriangles) return kinds["points and lines are left out"].push_back(name);
        need(mode <= kFan, name + " has a primitive of an unknown mode");
        const json &attributes = objectOf(p, "attributes");
        if (attributes.contains("COLOR_0")) kinds["colours of points (COLOR_0) are not used"].push_back(name);
        const int accessor = indexOf(attributes, "POSITION"), number = indexOf(p, "material");
        if (accessor < 0) return kinds["primitives without POSITION are left out"].push_back(name);
        std::vector<int> targets;
        for (const json &target : objectsOf(p, "targets")) targets.push_back(indexOf(target, "POSITION"));
        auto [entry, added] = pointSets.try_emplace({accessor, targets});
        Points &points = entry->second;
        if (added) {
            points.given = file.numbers(accessor, "VEC3");
            morph(targets, name, weights, points.given);
            points.indices.assign(points.given.size() / 3, -1);
        }
        if (number >= 0) itemOf(file.root["materials"], number, "material");
        const GltfMaterial *material = number < 0 ? nullptr : &materials[(size_t)number];
        Coordinates coordinates;
        if (material && material->mesh.hasPicture())
            if (int set = indexOf(attributes, ("TEXCOORD_" + std::to_string(material->set)).c_str());
                set >= 0)
                coordinates.given = file.numbers(set, "VEC2");
        coordinates.indices.assign(coordinates.given.size() / 2, -1);
        readTriangles(p, name, transform.mirrors(), points.indices.size(), [&](size_t i) {
            return Polygons::Corner{pointIndex(points, i, transform, name),
                                    coordinateIndex(coordinates, i, material)};
        });
    }

    // Adds the triangles. `cornerOf` returns the corner at one of the `count` points.
    template <class CornerOf>
    void readTriangles(const json &p, const std::string &name, bool mirrored, size_t count,
                       const CornerOf &cornerOf) {
        const int mode = valueOf(p, "mode", (int)kTriangles), material = indexOf(p, "material"),
                  indices = indexOf(p, "indices");
        std::vector<double> order;
        if (indices >= 0) order = file.numbers(indices, "SCALAR");
        const size_t corners = indices >= 0 ? order.size() : count, step = mode == kTriangles ? 3 : 1;
        for (size_t i = 0; i + 2 < corners; i += step) {
            std::array<size_t, 3> three = {i, i + 1, i + 2};
            if (mode == kStrip && i % 2) std::swap(three[1], three[2]);
            if (mode == kFan) three[0] = 0;
            if (mirrored) std::swap(three[1], three[2]);
            for (size_t &k : three) {
                if (indices < 0) continue;
                if (!(order[k] >= 0 && order[k] < (double)count))
                    throw common::Refused(name + " has an index beyond its " + std::to_string(count) +
                                          " points");
                k = (size_t)order[k];
            }
            // Skip the triangles without area that join strips
            if (step == 1 && (three[0] == three[1] || three[1] == three[2] || three[2] == three[0])) continue;
            const size_t before = polygons.polygons.size();
            need(before < kMostTriangles, "has more than 2^26 triangles");
            polygons.polygons.push_back(
                {polygons.corners.size(), material, (int)before + 1, (int)polygons.objects.size() - 1});
            for (size_t k : three) polygons.corners.push_back(cornerOf(k));
        }
        if (step == 3 && corners % 3) kinds["corners that make no triangle are left out"].push_back(name);
    }

    int pointIndex(Points &points, size_t i, const Transform &transform, const std::string &name) {
        int &index = points.indices[i];
        if (index >= 0) return index;
        const double *given = &points.given[3 * i];
        const Vec3d q = transform({given[0], given[1], given[2]});
        for (size_t k = 0; k < 3; ++k)
            if (!(std::fabs(q[k]) < 1e18))
                throw common::Refused(name + " has a coordinate that is not a number below 1e18");
        polygons.points.push_back(q);
        return index = (int)polygons.points.size() - 1;
    }

    int coordinateIndex(Coordinates &coordinates, size_t i, const GltfMaterial *material) {
        if (i >= coordinates.indices.size()) return -1;
        int &index = coordinates.indices[i];
        if (index >= 0) return index;
        const double u = coordinates.given[2 * i], v = coordinates.given[2 * i + 1];
        const auto &m = material->uv;
        // In glTF, v points down
        polygons.coordinates.push_back(
            {(float)(m[0] * u + m[1] * v + m[2]), (float)(1 - (m[3] * u + m[4] * v + m[5]))});
        return index = (int)polygons.coordinates.size() - 1;
    }

    void readLight(const json &light, const Transform &transform) {
        const std::vector<double> c = numbersOf(light, "color", {1, 1, 1});
        const Vec3d colour = Vec3d{c[0], c[1], c[2]} * valueOf(light, "intensity", 1.);
        const std::string type = textOf(light, "type");
        for (size_t k = 0; k < 3; ++k)
            need(colour[k] >= 0 && colour[k] <= kMostPower, "a light's intensity must be 0 to 1e12");
        if (colour == Vec3d{}) return;
        if (type == "directional") {
            // It shines along -z; lux over pi is the radiance of a white surface
            need(length(transform.z) > 0 && length(transform.z) < 1e18, "a sun has no direction");
            lights.suns.push_back({toFloat(normalize(transform.z)), toFloat(colour / std::numbers::pi)});
            return;
        }
        need(type == "point" || type == "spot", "a light is of an unknown type: " + type);
        spots += type == "spot";
        bulbs.push_back({transform.origin, colour});
    }

    // Makes a ball of each point and spot light, with radiance = candela / area of its disc.
    void addBalls() {
        if (bulbs.empty()) return;
        double largest = 0;
        auto [lo, hi] = boxOf(polygons.points);
        const double radius = std::max(length(hi - lo) * kBallShare / 2, 1e-12);
        for (const auto &[centre, candela] : bulbs) {
            for (size_t k = 0; k < 3; ++k)
                need(std::fabs(centre[k]) < 1e18, "a light lies further than 1e18 from the origin");
            // Enlarge bright balls, so that their radiance is at most kMostPower / 2
            const double most = std::max({candela.x, candela.y, candela.z}),
                         size = std::max(radius, std::sqrt(most / (std::numbers::pi * kMostPower / 2)));
            largest = std::max(largest, size);
            lights.lamps.push_back(
                ballLamp(centre, size, toFloat(candela / (std::numbers::pi * size * size))));
        }
        notes.push_back(
            path +
            common::format(": %zu point or spot light%s, up to %.3g across", bulbs.size(),
                           bulbs.size() == 1 ? " becomes a ball" : "s become balls", 2 * largest) +
            (spots
                 ? common::format("; %d spot%s in all directions", spots, spots == 1 ? " shines" : "s shine")
                 : ""));
    }
};

} // namespace

Mesh readGltf(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes) {
    GltfReader reader = common::inFile(path, [&] { return GltfReader(path, notes); });
    common::inFile(path, [&] { reader.readScene(); });
    Mesh mesh = buildMesh(path, std::move(reader.polygons), reader.meshMaterials(), settings, notes);
    mesh.lights = std::move(reader.lights);
    mesh.lights.scale(settings.scale);
    return mesh;
}

} // namespace odraz::radiosity
