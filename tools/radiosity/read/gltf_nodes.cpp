#include "tools/radiosity/read/gltf_nodes.h"

#include <cmath>

namespace odraz::radiosity {

using common::need;

Transform transformOf(const double *m) {
    return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
}

namespace {

Transform localTransform(const json &n) {
    if (n.contains("matrix")) return transformOf(numbersOf(n, "matrix", std::vector<double>(16)).data());
    const auto t = numbersOf(n, "translation", {0, 0, 0}), s = numbersOf(n, "scale", {1, 1, 1});
    auto q = numbersOf(n, "rotation", {0, 0, 0, 1});
    const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    need(size > 0, "a node's rotation is 0,0,0,0");
    for (double &k : q) k /= size;
    const auto [x, y, z, w] = std::array<double, 4>{q[0], q[1], q[2], q[3]};
    return {Vec3d{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)} * s[0],
            Vec3d{2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)} * s[1],
            Vec3d{2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)} * s[2],
            {t[0], t[1], t[2]}};
}

std::vector<int> childrenOf(const json &node) { return valueOf(node, "children", std::vector<int>()); }

std::vector<int> rootsOf(const GltfFile &file) {
    const json &scenes = file.root["scenes"], &nodes = file.root["nodes"];
    const int scene = indexOf(file.root, "scene");
    if (scene >= 0 || !scenes.empty())
        return valueOf(itemOf(scenes, std::max(scene, 0), "scene"), "nodes", std::vector<int>());
    std::vector<bool> inner(nodes.size());
    for (const json &n : nodes)
        for (int child : childrenOf(n))
            if ((size_t)child < inner.size()) inner[(size_t)child] = true;
    std::vector<int> roots;
    for (size_t i = 0; i < inner.size(); ++i)
        if (!inner[i]) roots.push_back((int)i);
    return roots;
}

} // namespace

GltfNodes findTransforms(const GltfFile &file) {
    GltfNodes all;
    const json &nodes = file.root["nodes"];
    all.transforms.resize(nodes.size());
    std::vector<bool> seen(nodes.size());
    std::vector<std::pair<int, Transform>> open; // to visit, with their parents' transforms
    auto add = [&](const std::vector<int> &nodes, const Transform &parent) {
        for (size_t k = nodes.size(); k-- > 0;) open.push_back({nodes[k], parent});
    };
    add(rootsOf(file), {});
    while (!open.empty()) {
        auto [i, parent] = open.back();
        open.pop_back();
        const json &n = itemOf(nodes, i, "node");
        need(!seen[(size_t)i], named("node", n, i) + " has two parents, or is within itself");
        seen[(size_t)i] = true;
        all.order.push_back(i);
        add(childrenOf(n), all.transforms[(size_t)i] = parent * localTransform(n));
    }
    return all;
}

} // namespace odraz::radiosity
