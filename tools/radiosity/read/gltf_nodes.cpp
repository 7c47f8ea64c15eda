#include "tools/radiosity/read/gltf_nodes.h"

#include <cmath>

namespace odraz::radiosity {

using common::need;

Transform transformOf(const double *m) {
    return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
}

namespace {

Transform localTransform(const tinygltf::Node &n) {
    auto orDefault = [](const std::vector<double> &given, std::vector<double> otherwise) {
        return given.empty() ? otherwise : given;
    };
    if (!n.matrix.empty()) return transformOf(n.matrix.data());
    const auto t = orDefault(n.translation, {0, 0, 0}), s = orDefault(n.scale, {1, 1, 1});
    auto q = orDefault(n.rotation, {0, 0, 0, 1});
    const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    need(size > 0, "a node's rotation is 0,0,0,0");
    for (double &k : q) k /= size;
    const auto [x, y, z, w] = std::array<double, 4>{q[0], q[1], q[2], q[3]};
    return {Vec3d{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)} * s[0],
            Vec3d{2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)} * s[1],
            Vec3d{2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)} * s[2],
            {t[0], t[1], t[2]}};
}

std::vector<int> rootsOf(const tinygltf::Model &model) {
    if (model.defaultScene >= 0 || !model.scenes.empty())
        return GltfFile::at(model.scenes, std::max(model.defaultScene, 0), "scene").nodes;
    std::vector<bool> inner(model.nodes.size());
    for (const tinygltf::Node &n : model.nodes)
        for (int child : n.children)
            if (child >= 0 && (size_t)child < inner.size()) inner[(size_t)child] = true;
    std::vector<int> roots;
    for (size_t i = 0; i < inner.size(); ++i)
        if (!inner[i]) roots.push_back((int)i);
    return roots;
}

} // namespace

GltfNodes findTransforms(const tinygltf::Model &model) {
    GltfNodes all;
    all.transforms.resize(model.nodes.size());
    std::vector<bool> seen(model.nodes.size());
    std::vector<std::pair<int, Transform>> open; // to visit, with their parents' transforms
    auto add = [&](const std::vector<int> &nodes, const Transform &parent) {
        for (size_t k = nodes.size(); k-- > 0;) open.push_back({nodes[k], parent});
    };
    add(rootsOf(model), {});
    while (!open.empty()) {
        auto [i, parent] = open.back();
        open.pop_back();
        const tinygltf::Node &n = GltfFile::at(model.nodes, i, "node");
        need(!seen[(size_t)i], named("node", n.name, i) + " has two parents, or is within itself");
        seen[(size_t)i] = true;
        all.order.push_back(i);
        add(n.children, all.transforms[(size_t)i] = parent * localTransform(n));
    }
    return all;
}

} // namespace odraz::radiosity
