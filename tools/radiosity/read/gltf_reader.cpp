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

class GltfReader {
public:
    GltfReader(const std::string &path, std::vector<std::string> &notes)
        : path(path), notes(notes), file(path), model(file.model) {
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
        nodes = findTransforms(model);
        if (model.scenes.size() > 1)
            notes.push_back(path + ": one of its " + std::to_string(model.scenes.size()) + " scenes is read");
        for (int i : nodes.order) {
            const tinygltf::Node &n = model.nodes[(size_t)i];
            if (n.mesh >= 0) readMesh(n, i);
            auto light = n.extensions.find("KHR_lights_punctual");
            if (light != n.extensions.end() && light->second.Has("light"))
                readLight(GltfFile::at(model.lights, light->second.Get("light").GetNumberAsInt(), "light"),
                          nodes.transforms[(size_t)i]);
        }
        need(!polygons.polygons.empty(), "holds no triangle");
        addBalls();
        for (size_t i = 0; i < model.animations.size(); ++i)
            kinds["animations are not used"].push_back(named("animation", model.animations[i].name, (int)i));
        noteKinds(path, kinds, notes);
    }

    Polygons polygons;
    Surroundings lights;

private:
    const std::string &path;
    std::vector<std::string> &notes;
    GltfFile file;
    const tinygltf::Model &model;
    std::vector<GltfMaterial> materials;
    NotedKinds kinds;
    GltfNodes nodes;
    std::vector<std::pair<Vec3d, Vec3d>> bulbs; // point and spot lights: centre and candela
    int spots = 0;

    void checkExtensions() {
        for (const std::string &name : model.extensionsRequired)
            need(isExtensionRead(name), "needs " + name + ", which is not read: export the model without it");
        for (const std::string &name : model.extensionsUsed)
            if (!isExtensionRead(name)) kinds["extensions that are not used"].push_back(name);
    }

    // The items of an accessor, and their indices in `polygons`; -1: not added yet.
    struct Points {
        std::vector<double> given;
        std::vector<int> indices;
    };
    using Coordinates = Points;
    // The points of a node, by accessor and morph targets
    using PointSets = std::map<std::pair<int, std::vector<std::map<std::string, int>>>, Points>;

    void readMesh(const tinygltf::Node &n, int node) {
        const tinygltf::Mesh &mesh = GltfFile::at(model.meshes, n.mesh, "mesh");
        Transform transform = nodes.transforms[(size_t)node];
        if (n.skin >= 0) {
            // In the bind pose, all joints give the mesh the same transform: use the first
            const tinygltf::Skin &skin = GltfFile::at(model.skins, n.skin, "skin");
            kinds["skins are not deformed: meshes keep their bind pose"].push_back(
                named("node", n.name, node));
            if (!skin.joints.empty()) {
                GltfFile::at(model.nodes, skin.joints[0], "node");
                transform = nodes.transforms[(size_t)skin.joints[0]];
                if (skin.inverseBindMatrices >= 0) {
                    auto bound = file.numbers(skin.inverseBindMatrices, TINYGLTF_TYPE_MAT4);
                    need(bound.size() >= 16, "a skin has no matrix");
                    transform = transform * transformOf(bound.data());
                }
            }
        }
        polygons.objects.push_back({n.name.empty() ? mesh.name : n.name, ""});
        PointSets points;
        for (const tinygltf::Primitive &p : mesh.primitives)
            readPrimitive(p, named("mesh", mesh.name, n.mesh), transform,
                          n.weights.empty() ? mesh.weights : n.weights, points);
    }

    // Adds the weighted morph targets to the points.
    void morph(const tinygltf::Primitive &p, const std::string &name, const std::vector<double> &weights,
               std::vector<double> &points) {
        for (size_t i = 0; i < std::min(weights.size(), p.targets.size()); ++i) {
            auto found = p.targets[i].find("POSITION");
            if (weights[i] == 0 || found == p.targets[i].end()) continue;
            const std::vector<double> moved = file.numbers(found->second, TINYGLTF_TYPE_VEC3);
            need(moved.size() == points.size(), name + " has a morph target with another number of points");
            for (size_t k = 0; k < moved.size(); ++k) points[k] += weights[i] * moved[k];
        }
    }

    static int attribute(const tinygltf::Primitive &p, const std::string &name) {
        auto found = p.attributes.find(name);
        return found == p.attributes.end() ? -1 : found->second;
    }

    void readPrimitive(const tinygltf::Primitive &p, const std::string &name, const Transform &transform,
                       const std::vector<double> &weights, PointSets &pointSets) {
        if (p.mode >= 0 && p.mode < TINYGLTF_MODE_TRIANGLES)
            return kinds["points and lines are left out"].push_back(name);
        need(p.mode <= TINYGLTF_MODE_TRIANGLE_FAN, name + " has a primitive of an unknown mode");
        if (attribute(p, "COLOR_0") >= 0) kinds["colours of points (COLOR_0) are not used"].push_back(name);
        const int accessor = attribute(p, "POSITION");
        if (accessor < 0) return kinds["primitives without POSITION are left out"].push_back(name);
        auto [entry, added] = pointSets.try_emplace({accessor, p.targets});
        Points &points = entry->second;
        if (added) {
            points.given = file.numbers(accessor, TINYGLTF_TYPE_VEC3);
            morph(p, name, weights, points.given);
            points.indices.assign(points.given.size() / 3, -1);
        }
        const GltfMaterial *material =
            p.material < 0 ? nullptr : &GltfFile::at(materials, p.material, "material");
        Coordinates coordinates;
        if (material && material->mesh.hasPicture())
            if (int set = attribute(p, "TEXCOORD_" + std::to_string(material->set)); set >= 0)
                coordinates.given = file.numbers(set, TINYGLTF_TYPE_VEC2);
        coordinates.indices.assign(coordinates.given.size() / 2, -1);
        readTriangles(p, name, transform.mirrors(), points.indices.size(), [&](size_t i) {
            return Polygons::Corner{pointIndex(points, i, transform, name),
                                    coordinateIndex(coordinates, i, material)};
        });
    }

    // Adds the triangles. `cornerOf` returns the corner at one of the `count` points.
    template <class CornerOf>
    void readTriangles(const tinygltf::Primitive &p, const std::string &name, bool mirrored, size_t count,
                       const CornerOf &cornerOf) {
        std::vector<double> order;
        if (p.indices >= 0) order = file.numbers(p.indices, TINYGLTF_TYPE_SCALAR);
        const size_t corners = p.indices >= 0 ? order.size() : count,
                     step = p.mode == TINYGLTF_MODE_TRIANGLES || p.mode < 0 ? 3 : 1;
        for (size_t i = 0; i + 2 < corners; i += step) {
            std::array<size_t, 3> three = {i, i + 1, i + 2};
            if (p.mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2) std::swap(three[1], three[2]);
            if (p.mode == TINYGLTF_MODE_TRIANGLE_FAN) three[0] = 0;
            if (mirrored) std::swap(three[1], three[2]);
            for (size_t &k : three) {
                if (p.indices < 0) continue;
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
                {polygons.corners.size(), p.material, (int)before + 1, (int)polygons.objects.size() - 1});
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

    void readLight(const tinygltf::Light &light, const Transform &transform) {
        Vec3d colour = {1, 1, 1};
        for (size_t k = 0; k < light.color.size(); ++k) colour[k] = light.color[k];
        colour = colour * light.intensity;
        for (size_t k = 0; k < 3; ++k)
            need(colour[k] >= 0 && colour[k] <= kMostPower, "a light's intensity must be 0 to 1e12");
        if (colour == Vec3d{}) return;
        if (light.type == "directional") {
            // It shines along -z; lux over pi is the radiance of a white surface
            need(length(transform.z) > 0 && length(transform.z) < 1e18, "a sun has no direction");
            lights.suns.push_back({toFloat(normalize(transform.z)), toFloat(colour / std::numbers::pi)});
            return;
        }
        need(light.type == "point" || light.type == "spot", "a light is of an unknown type: " + light.type);
        spots += light.type == "spot";
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
