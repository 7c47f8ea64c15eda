// The transforms of a glTF scene's nodes.
#pragma once

#include "tools/radiosity/read/gltf_file.h"
#include "tools/support/vec3d.h"

namespace odraz::radiosity {

// An affine transform: p becomes x p.x + y p.y + z p.z + origin.
struct Transform {
    Vec3d x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1}, origin = {};

    Vec3d linear(Vec3d p) const { return x * p.x + y * p.y + z * p.z; }
    Vec3d operator()(Vec3d p) const { return linear(p) + origin; }
    Transform operator*(const Transform &inner) const {
        return {linear(inner.x), linear(inner.y), linear(inner.z), (*this)(inner.origin)};
    }
    bool mirrors() const { return dot(cross(x, y), z) < 0; }
};
Transform transformOf(const double *matrix); // 4 x 4, by columns

struct GltfNodes {
    std::vector<int> order;            // parents before their children
    std::vector<Transform> transforms; // for each node; not set outside the scene
};

// The nodes of the default scene, else of the first scene; all nodes if there is no scene. Throws Refused.
GltfNodes findTransforms(const GltfFile &file);

// The kind of an object and its name, or its number if it has none, for messages.
inline std::string named(const char *what, const json &object, int number) {
    const std::string name = textOf(object, "name");
    return what + (" " + (name.empty() ? std::to_string(number) : name));
}

} // namespace odraz::radiosity
