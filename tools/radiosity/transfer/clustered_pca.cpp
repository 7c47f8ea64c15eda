#include "tools/radiosity/transfer/clustered_pca.h"

#include "base/random.h"

namespace odraz::radiosity {

namespace {

struct Clustering {
    ClusteredPca &p;
    const PcaSettings &settings;

    float *axesOf(int c) { return const_cast<float *>(p.axesOf(c)); }
    const float *rowOf(int r) const { return p.data + (size_t)r * (size_t)p.columns; }
    float *weightsOf(int r) const { return p.weights + (size_t)r * (size_t)p.dimensions; }

    // The squared distance of a row from a cluster's subspace, or from its mean if `weights` is null. Writes
    // the row's coordinates in the subspace to `weights`.
    float project(int r, int c, float *weights) const {
        const float *row = rowOf(r), *mean = p.axesOf(c);
        Float8 squares = {};
        for (int i = 0; i < p.columns; i += 8) {
            Float8 offset = load(row + i) - load(mean + i);
            squares = fmadd(offset, offset, squares);
        }
        float square = total(squares);
        for (int d = 0; weights && d < p.dimensions; d += 8) {
            const float *axes = mean + (size_t)(1 + d) * (size_t)p.columns;
            Float8 sum[8] = {};
            for (int i = 0; i < p.columns; i += 8) {
                Float8 offset = load(row + i) - load(mean + i);
                const float *axis = axes + i;
#pragma GCC unroll 8
                for (int k = 0; k < 8; ++k, axis += p.columns) sum[k] = fmadd(offset, load(axis), sum[k]);
            }
            for (int k = 0; k < 8; ++k) {
                float w = weights[d + k] = total(sum[k]);
                square -= w * w;
            }
        }
        return max(square, 0.f);
    }

    // Orthonormalises by Gram-Schmidt, twice, so that no rounding error remains. An axis that depends on
    // earlier axes becomes zero, because only noise remains of it.
    void orthonormalize(float *axes) const {
        auto dotOf = [&](const float *a, const float *b) {
            Float8 sum = {};
            for (int i = 0; i < p.columns; i += 8) sum = fmadd(load(a + i), load(b + i), sum);
            return total(sum);
        };
        for (int d = 0; d < p.dimensions; ++d) {
            float *axis = axes + (size_t)d * (size_t)p.columns;
            // Scale the axis so that its square does not overflow or vanish
            Float8 largest = broadcast(1e-35f);
            for (int i = 0; i < p.columns; i += 8) largest = max(abs(load(axis + i)), largest);
            float size = 1 / -least(-largest);
            for (int i = 0; i < p.columns; i += 8) store(axis + i, load(axis + i) * size);
            float before = dotOf(axis, axis);
            // axis = (axis + other * factor) * scale
            auto add = [&](const float *other, float factor, float scale) {
                for (int i = 0; i < p.columns; i += 8)
                    store(axis + i, fmadd(load(other + i), factor, load(axis + i)) * scale);
            };
            for (int e = 0; e < 2 * d; ++e) {
                const float *other = axes + (size_t)(e % d) * (size_t)p.columns;
                add(other, -dotOf(axis, other), 1);
            }
            float after = dotOf(axis, axis);
            add(axis, 0, after > before * 1e-10f ? 1 / sqrt(after) : 0);
        }
    }

    // Finds a cluster's mean and axes from its members and their weights.
    void fit(int c) {
        int begin = p.first[c], end = p.first[c + 1], columns = p.columns;
        float *mean = axesOf(c), *axes = mean + columns;
        if (begin == end) return;
        for (int i = 0; i < columns; i += 8) {
            Float8 sum = {};
            for (int m = begin; m < end; ++m) sum += load(rowOf(p.members[m]) + i);
            store(mean + i, sum * (1.f / (float)(end - begin)));
        }
        for (int step = 0; step < settings.iterations; ++step) {
            for (int d = 0; d < p.dimensions; d += 8)
                for (int i = 0; i < columns; i += 8) {
                    Float8 sum[8] = {};
                    for (int m = begin; m < end; ++m) {
                        int r = p.members[m];
                        Float8 offset = load(rowOf(r) + i) - load(mean + i);
                        const float *weights = weightsOf(r) + d;
#pragma GCC unroll 8
                        for (int k = 0; k < 8; ++k) sum[k] = fmadd(offset, weights[k], sum[k]);
                    }
                    for (int k = 0; k < 8; ++k) store(axes + (size_t)(d + k) * (size_t)columns + i, sum[k]);
                }
            orthonormalize(axes);
            for (int m = begin; m < end; ++m) project(p.members[m], c, weightsOf(p.members[m]));
        }
    }

    // Assigns a row to the cluster with the nearest subspace. The candidates are its present cluster and
    // those with the nearest means.
    void assign(int r) {
        int candidates[8], count = 0, best = p.cluster[r];
        float distances[8], weights[kMaxDimensions], least = project(r, best, weightsOf(r));
        for (int c = 0; c < p.clusters; ++c) {
            if (p.first[c] == p.first[c + 1] || c == p.cluster[r]) continue;
            float distance = project(r, c, nullptr);
            int at = count;
            for (; at > 0 && distance < distances[at - 1]; --at)
                if (at < settings.tried)
                    distances[at] = distances[at - 1], candidates[at] = candidates[at - 1];
            if (at == settings.tried) continue;
            distances[at] = distance, candidates[at] = c;
            count = min(count + 1, settings.tried);
        }
        for (int k = 0; k < count; ++k) {
            float distance = project(r, candidates[k], weights);
            if (!(distance < least)) continue;
            least = distance, best = candidates[k];
            for (int d = 0; d < p.dimensions; ++d) weightsOf(r)[d] = weights[d];
        }
        p.cluster[r] = best;
    }

    void sortMembers() {
        for (int c = 0; c <= p.clusters; ++c) p.first[c] = 0;
        for (int r = 0; r < p.rows; ++r) ++p.first[p.cluster[r] + 1];
        for (int c = 0; c < p.clusters; ++c) p.first[c + 1] += p.first[c];
        for (int r = 0; r < p.rows; ++r) p.members[p.first[p.cluster[r]]++] = r;
        // The line above has moved each cluster's first index to the cluster's end: move it back
        for (int c = p.clusters; c > 0; --c) p.first[c] = p.first[c - 1];
        p.first[0] = 0;
    }
};

} // namespace

bool compress(ClusteredPca &p, const PcaSettings &settings, Arena &arena, Workers &workers) {
    p.clusters = settings.clusters;
    p.dimensions = settings.dimensions;
    p.axes = arena.allocate<float>((size_t)p.clusters * (size_t)(1 + p.dimensions) * (size_t)p.columns);
    p.weights = arena.allocate<float>((size_t)p.rows * (size_t)p.dimensions);
    p.members = arena.allocate<int>((size_t)p.rows);
    p.first = arena.allocate<int>((size_t)p.clusters + 1);
    if (arena.full) return false;
    Clustering work = {p, settings};
    // Begin with random weights, because any will do
    for (int i = 0; i < p.rows * p.dimensions; ++i) p.weights[i] = unitFloat(pcg((uint32_t)i)) - 0.5f;
    for (int round = 0;; ++round) {
        work.sortMembers();
        parallelFor(workers, p.clusters, [&](int c, int) { work.fit(c); });
        if (round == settings.rounds) return true;
        parallelRanges(workers, p.rows, 64, [&](int first, int end, int) {
            for (int r = first; r < end; ++r) work.assign(r);
        });
    }
}

} // namespace odraz::radiosity
