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
constexpr double kBallShare = 1e-3; // the width of a lamp, as a share of the model's size

class GltfReader {
public:
    GltfReader(const std::string &path, std::vector<std::string> &notes)
        : path(path), notes(notes), file(path), model(file.model) {
        polygons.unit = "triangle";
        checkExtensions();
        materials = readMaterials(file, path, kinds, notes);
    }

    // Without the scene
    std::vector<MeshMaterial> takeMaterials() {
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
    std::vector<std::pair<Vec3d, Vec3d>> bulbs; // the centre and candela of lights at points
    int spots = 0;

    void checkExtensions() {
        for (const std::string &name : model.extensionsRequired)
            need(isExtensionRead(name), "needs " + name + ", which is not read: export it without");
        for (const std::string &name : model.extensionsUsed)
            if (!isExtensionRead(name)) kinds["extensions that are not used"].push_back(name);
    }

    // Points that were not used yet are -1.
    struct Points {
        std::vector<double> given;
        std::vector<int> numbers;
    };
    // A node's, by their accessor and the morph targets
    using AllPoints = std::map<std::pair<int, std::vector<std::map<std::string, int>>>, Points>;

    void readMesh(const tinygltf::Node &n, int node) {
        const tinygltf::Mesh &mesh = GltfFile::at(model.meshes, n.mesh, "mesh");
        Transform place = nodes.transforms[(size_t)node];
        if (n.skin >= 0) {
            // All joints agree in the pose in which the mesh was bound
            const tinygltf::Skin &skin = GltfFile::at(model.skins, n.skin, "skin");
            kinds["skins are not bent: meshes stand as they were bound"].push_back(
                named("node", n.name, node));
            if (!skin.joints.empty()) {
                GltfFile::at(model.nodes, skin.joints[0], "node");
                place = nodes.transforms[(size_t)skin.joints[0]];
                if (skin.inverseBindMatrices >= 0) {
                    auto bound = file.numbers(skin.inverseBindMatrices, TINYGLTF_TYPE_MAT4);
                    need(bound.size() >= 16, "a skin has no matrix");
                    place = place * transformOf(bound.data());
                }
            }
        }
        AllPoints points;
        for (const tinygltf::Primitive &p : mesh.primitives)
            readPrimitive(p, named("mesh", mesh.name, n.mesh), place,
                          n.weights.empty() ? mesh.weights : n.weights, points);
    }

    // Adds the morph targets by their weights to the points.
    void morph(const tinygltf::Primitive &p, const std::string &name, const std::vector<double> &weights,
               std::vector<double> &points) {
        for (size_t i = 0; i < std::min(weights.size(), p.targets.size()); ++i) {
            auto found = p.targets[i].find("POSITION");
            if (weights[i] == 0 || found == p.targets[i].end()) continue;
            const std::vector<double> moved = file.numbers(found->second, TINYGLTF_TYPE_VEC3);
            need(moved.size() == points.size(), name + " has a morph target of another number of points");
            for (size_t k = 0; k < moved.size(); ++k) points[k] += weights[i] * moved[k];
        }
    }

    void readPrimitive(const tinygltf::Primitive &p, const std::string &name, const Transform &place,
                       const std::vector<double> &weights, AllPoints &allPoints) {
        auto attribute = [&](const std::string &which) {
            auto found = p.attributes.find(which);
            return found == p.attributes.end() ? -1 : found->second;
        };
        if (p.mode >= 0 && p.mode < TINYGLTF_MODE_TRIANGLES)
            return kinds["points and lines are left out"].push_back(name);
        need(p.mode <= TINYGLTF_MODE_TRIANGLE_FAN, name + " has a primitive of an unknown mode");
        if (attribute("COLOR_0") >= 0) kinds["colours of points (COLOR_0) are not used"].push_back(name);
        const int number = attribute("POSITION");
        if (number < 0) return kinds["primitives without POSITION are left out"].push_back(name);
        auto [entry, added] = allPoints.try_emplace({number, p.targets});
        Points &points = entry->second;
        if (added) {
            points.given = file.numbers(number, TINYGLTF_TYPE_VEC3);
            morph(p, name, weights, points.given);
            points.numbers.assign(points.given.size() / 3, -1);
        }
        const size_t count = points.numbers.size();
        const GltfMaterial *material =
            p.material < 0 ? nullptr : &GltfFile::at(materials, p.material, "material");
        std::vector<double> at; // coordinates
        if (material && material->mesh.hasPicture())
            if (int set = attribute("TEXCOORD_" + std::to_string(material->set)); set >= 0)
                at = file.numbers(set, TINYGLTF_TYPE_VEC2);
        std::vector<int> coordinates(at.size() / 2, -1);
        auto corner = [&](size_t i) -> Polygons::Corner {
            int &point = points.numbers[i];
            if (point < 0) {
                point = (int)polygons.points.size();
                Vec3d q = place({points.given[3 * i], points.given[3 * i + 1], points.given[3 * i + 2]});
                for (size_t k = 0; k < 3; ++k)
                    if (!(std::fabs(q[k]) < 1e18))
                        throw common::Refused(name + " has a coordinate that is not a number below 1e18");
                polygons.points.push_back(q);
            }
            if (i >= coordinates.size()) return {point, -1};
            int &coordinate = coordinates[i];
            if (coordinate < 0) {
                coordinate = (int)polygons.coordinates.size();
                const double u = at[2 * i], v = at[2 * i + 1];
                const auto &m = material->at;
                // Their v is counted from the top
                polygons.coordinates.push_back(
                    {(float)(m[0] * u + m[1] * v + m[2]), (float)(1 - (m[3] * u + m[4] * v + m[5]))});
            }
            return {point, coordinate};
        };
        std::vector<double> order;
        if (p.indices >= 0) order = file.numbers(p.indices, TINYGLTF_TYPE_SCALAR);
        const bool flip = place.mirrors();
        const size_t corners = p.indices >= 0 ? order.size() : count,
                     step = p.mode == TINYGLTF_MODE_TRIANGLES || p.mode < 0 ? 3 : 1;
        for (size_t i = 0; i + 2 < corners; i += step) {
            std::array<size_t, 3> three = {i, i + 1, i + 2};
            if (p.mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2) std::swap(three[1], three[2]);
            if (p.mode == TINYGLTF_MODE_TRIANGLE_FAN) three[0] = 0;
            if (flip) std::swap(three[1], three[2]);
            for (size_t &k : three) {
                if (p.indices < 0) continue;
                if (!(order[k] >= 0 && order[k] < (double)count))
                    throw common::Refused(name + " has an index beyond its " + std::to_string(count) +
                                          " points");
                k = (size_t)order[k];
            }
            // Strips are joined by triangles without area
            if (step == 1 && (three[0] == three[1] || three[1] == three[2] || three[2] == three[0])) continue;
            const size_t before = polygons.polygons.size();
            need(before < kMostTriangles, "has more than 2^26 triangles");
            polygons.polygons.push_back({polygons.corners.size(), p.material, (int)before + 1});
            for (size_t k : three) polygons.corners.push_back(corner(k));
        }
        if (step == 3 && corners % 3) kinds["corners that make no triangle are left out"].push_back(name);
    }

    void readLight(const tinygltf::Light &light, const Transform &place) {
        Vec3d colour = {1, 1, 1};
        for (size_t k = 0; k < light.color.size(); ++k) colour[k] = light.color[k];
        colour = colour * light.intensity;
        for (size_t k = 0; k < 3; ++k)
            need(colour[k] >= 0 && colour[k] <= kMostPower, "a light must lie between 0 and 1e12");
        if (colour == Vec3d{}) return;
        if (light.type == "directional") {
            // It shines along -z; lux over pi is the radiance of a white surface
            need(length(place.z) > 0 && length(place.z) < 1e18, "a sun has no direction");
            lights.suns.push_back({toFloat(normalize(place.z)), toFloat(colour / std::numbers::pi)});
            return;
        }
        need(light.type == "point" || light.type == "spot", "a light is of an unknown type: " + light.type);
        spots += light.type == "spot";
        bulbs.push_back({place.origin, colour});
    }

    // Points that shine become balls, with radiance = candela / area of the disc.
    void addBalls() {
        if (bulbs.empty()) return;
        double largest = 0;
        auto [lo, hi] = boxOf(polygons.points);
        const double radius = std::max(length(hi - lo) * kBallShare / 2, 1e-12);
        for (const auto &[centre, candela] : bulbs) {
            for (size_t k = 0; k < 3; ++k)
                need(std::fabs(centre[k]) < 1e18, "a light lies further than 1e18 from the origin");
            // A bright one is larger, so that its radiance stays within bounds
            const double most = std::max({candela.x, candela.y, candela.z}),
                         own = std::max(radius, std::sqrt(most / (std::numbers::pi * kMostPower / 2)));
            largest = std::max(largest, own);
            lights.lamps.push_back(ballLamp(centre, own, toFloat(candela / (std::numbers::pi * own * own))));
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
    Mesh mesh = buildMesh(path, std::move(reader.polygons), reader.takeMaterials(), settings, notes);
    mesh.lights = std::move(reader.lights);
    mesh.lights.scale(settings.scale);
    return mesh;
}

} // namespace odraz::radiosity
