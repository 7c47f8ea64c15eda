#include "tools/radiosity/clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

namespace odraz {

namespace {

using Cube = std::array<long, 3>;

Cube cubeOf(Vec3 p, double side) {
    return {std::lround((double)p.x / side), std::lround((double)p.y / side),
            std::lround((double)p.z / side)};
}

// Normals by the face of a cube they point to, and the ninth of it.
int directionOf(Vec3 n) {
    const float c[3] = {n.x, n.y, n.z};
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (std::fabs(c[k]) > std::fabs(c[axis])) axis = k;
    auto third = [&](float x) { return std::clamp((int)((x / std::fabs(c[axis]) + 1) * 1.5f), 0, 2); };
    return ((axis * 2 + (c[axis] < 0)) * 3 + third(c[(axis + 1) % 3])) * 3 + third(c[(axis + 2) % 3]);
}

} // namespace

Clusters::Clusters(Model &m, double patch, const std::function<int(int)> &group, Arena &arena)
    : side(std::sqrt(patch)), clusterOf((size_t)m.chartCount, -1) {
    // Which share: those of one cube that face one way
    struct Key {
        Cube cube;
        int direction, group;
        bool operator<(const Key &b) const {
            return cube != b.cube             ? cube < b.cube
                   : direction != b.direction ? direction < b.direction
                                              : group < b.group;
        }
    };
    std::map<Key, int> known;
    int patches = 0;
    for (int i = 0; i < m.chartCount; ++i) {
        const Chart &c = m.charts[i];
        int own = c.patchesAcross * c.patchesDown;
        if ((double)c.width * (double)c.height >= patch / 2 || own > 1) {
            patches += own;
            continue;
        }
        Vec3 middle = c.at(c.width / 2, c.height / 2);
        auto [entry, added] =
            known.try_emplace({cubeOf(middle, side), directionOf(c.n), group(i)}, (int)members.size());
        if (added) members.emplace_back();
        members[(size_t)entry->second].push_back(i);
        clusterOf[(size_t)i] = entry->second;
    }
    firstPatch = patches;
    if (members.empty()) return;

    // Renumber: patches of their own first
    const Patch *were = m.patches;
    auto *now = arena.take<Patch>((size_t)patches + members.size());
    if (!now) return;
    int next = 0;
    std::vector<int> shift((size_t)m.chartCount);
    for (int i = 0; i < m.chartCount; ++i) {
        Chart &c = m.charts[i];
        int own = c.patchesAcross * c.patchesDown, first = c.firstPatch;
        c.firstPatch = clusterOf[(size_t)i] < 0 ? next : firstPatch + clusterOf[(size_t)i];
        shift[(size_t)i] = c.firstPatch - first;
        if (clusterOf[(size_t)i] < 0)
            for (int k = 0; k < own; ++k) now[next++] = were[first + k];
    }
    // The hemicube stands on the member that is nearest to the middle of all
    for (size_t k = 0; k < members.size(); ++k) {
        Vec3 sum = {};
        float area = 0;
        for (int i : members[k]) {
            const Chart &c = m.charts[i];
            sum += c.at(c.width / 2, c.height / 2) * (c.width * c.height);
            area += c.width * c.height;
        }
        Vec3 middle = sum * (1 / area);
        float least = kInfinity;
        Patch &to = now[(size_t)firstPatch + k];
        for (int i : members[k]) {
            const Patch &p = were[m.charts[i].firstPatch - shift[(size_t)i]];
            float distance = length(p.p - middle);
            if (p.share == 0 || distance >= least) continue;
            least = distance;
            to = p;
        }
        if (least == kInfinity) to = were[m.charts[members[k][0]].firstPatch - shift[(size_t)members[k][0]]];
    }
    for (int i = 0; i < m.cellCount; ++i) m.cells[i].patch += shift[(size_t)m.cells[i].chart];
    m.patches = now;
    m.patchCount = next + (int)members.size();
}

void Clusters::smooth(const Model &m, const FormFactors &factors, float *const planes[3]) const {
    if (members.empty()) return;
    struct Sample {
        Vec3 p, n;
        float light[3];
    };
    // What each has; it is the same in all its texels
    std::vector<Sample> samples(members.size());
    struct Hash {
        size_t operator()(const Cube &c) const {
            return (size_t)(c[0] * 73856093 ^ c[1] * 19349663 ^ c[2] * 83492791);
        }
    };
    std::unordered_map<Cube, std::vector<int>, Hash> near;
    for (size_t k = 0; k < members.size(); ++k) {
        const Patch &p = m.patches[(size_t)firstPatch + k];
        int texel = m.charts[members[k][0]].firstTexel;
        samples[k] = {p.p, p.n, {planes[0][texel], planes[1][texel], planes[2][texel]}};
        if (factors.rows[(size_t)firstPatch + k].known) near[cubeOf(p.p, side * 1.5)].push_back((int)k);
    }
    for (int t = 0; t < m.texelCount; ++t) {
        const Texel &texel = m.texels[t];
        if (clusterOf[(size_t)texel.chart] < 0) continue;
        const Chart &c = m.charts[texel.chart];
        Vec3 p = c.at((float)texel.x / kSteps * c.width / (float)c.across,
                      (float)texel.y / kSteps * c.height / (float)c.down);
        double weights = 0, sum[3] = {};
        Cube middle = cubeOf(p, side * 1.5);
        for (long k = 0; k < 27; ++k) {
            auto found = near.find({middle[0] + k % 3 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k / 9 - 1});
            if (found == near.end()) continue;
            for (int i : found->second) {
                const Sample &s = samples[(size_t)i];
                double cosine = (double)dot(s.n, c.n), far = (double)length(p - s.p) / side;
                // What lies before or behind the texel's plane sees something else
                double off = std::fabs((double)dot(p - s.p, c.n + s.n)) / side;
                double error = far + 3 * std::sqrt(std::max(0., 1 - cosine)) + 2 * off;
                double w = std::max(0., 1 / (error + 0.05) - 1 / 2.0);
                weights += w * w;
                for (int j = 0; j < 3; ++j) sum[j] += w * w * (double)s.light[j];
            }
        }
        if (weights > 0)
            for (int j = 0; j < 3; ++j) planes[j][t] = (float)(sum[j] / weights);
    }
}

} // namespace odraz
