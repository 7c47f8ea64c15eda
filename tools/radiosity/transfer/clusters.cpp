#include "tools/radiosity/transfer/clusters.h"

#include "tools/radiosity/solution/solution.h"
#include "tools/radiosity/transfer/clustered_pca.h"
#include "tools/support/heap_arena.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

namespace odraz::radiosity {

namespace {

// The eigenvectors of a small symmetric matrix by Jacobi rotations, in descending order of their eigenvalues.
class Eigenvectors {
public:
    Eigenvectors(std::vector<double> given, int size)
        : a(std::move(given)), n((size_t)size), v(n * n), order(n) {
        for (size_t i = 0; i < n; ++i) v[i * n + i] = 1;
        for (int sweep = 0; sweep < 30 && !diagonal(); ++sweep)
            for (size_t p = 0; p < n; ++p)
                for (size_t q = p + 1; q < n; ++q) rotate(p, q);
        std::iota(order.begin(), order.end(), (size_t)0);
        std::stable_sort(order.begin(), order.end(),
                         [&](size_t i, size_t j) { return a[i * n + i] > a[j * n + j]; });
    }
    double at(int row, int which) const { return v[(size_t)row * n + order[(size_t)which]]; }

private:
    std::vector<double> a;
    size_t n;
    std::vector<double> v;
    std::vector<size_t> order;

    bool diagonal() const {
        double off = 0, on = 0;
        for (size_t i = 0; i < n; ++i)
            for (size_t j = 0; j < n; ++j) (i == j ? on : off) += a[i * n + j] * a[i * n + j];
        return off <= 1e-24 * on;
    }
    void rotate(size_t p, size_t q) {
        if (a[p * n + q] == 0) return;
        double theta = (a[q * n + q] - a[p * n + p]) / (2 * a[p * n + q]),
               t = (theta < 0 ? -1 : 1) / (std::fabs(theta) + std::sqrt(theta * theta + 1)),
               c = 1 / std::sqrt(t * t + 1), s = t * c;
        auto turn = [&](double &x, double &y) {
            double was = x;
            x = c * was - s * y, y = s * was + c * y;
        };
        for (size_t k = 0; k < n; ++k) turn(a[k * n + p], a[k * n + q]);
        for (size_t k = 0; k < n; ++k) turn(a[p * n + k], a[q * n + k]);
        for (size_t k = 0; k < n; ++k) turn(v[k * n + p], v[k * n + q]);
    }
};

// Rotates a cluster's axes to the principal axes, sorts them, and keeps the first to.rank.
void sortAxes(const ClusteredPca &p, int c, const std::vector<float> &scale, Clusters &to) {
    int dimensions = p.dimensions, columns = p.columns;
    std::vector<double> moments((size_t)(dimensions * dimensions));
    for (int m = p.first[c]; m < p.first[c + 1]; ++m) {
        const float *w = p.weights + (size_t)p.members[m] * (size_t)dimensions;
        for (int i = 0; i < dimensions; ++i)
            for (int j = 0; j < dimensions; ++j)
                moments[(size_t)(i * dimensions + j)] += (double)w[i] * (double)w[j];
    }
    Eigenvectors turn(std::move(moments), dimensions);
    const float *from = p.axesOf(c);
    float *axes = &to.axes[(size_t)c * (size_t)(1 + to.rank) * (size_t)columns];
    for (int k = 0; k < columns; ++k) {
        axes[k] = from[k] / scale[(size_t)k];
        for (int d = 0; d < to.rank; ++d) {
            double sum = 0;
            for (int i = 0; i < dimensions; ++i) sum += turn.at(i, d) * (double)from[(1 + i) * columns + k];
            axes[(1 + d) * columns + k] = (float)sum / scale[(size_t)k];
        }
    }
    for (int m = p.first[c]; m < p.first[c + 1]; ++m) {
        auto texel = (size_t)p.members[m];
        for (int d = 0; d < to.rank; ++d) {
            double sum = 0;
            for (int i = 0; i < dimensions; ++i)
                sum += turn.at(i, d) * (double)p.weights[texel * (size_t)dimensions + (size_t)i];
            to.weights[texel * (size_t)to.rank + (size_t)d] = (float)sum;
        }
    }
}

} // namespace

Clusters findClusters(const std::vector<float> &rows, int columns, const std::vector<float> &scale,
                      std::vector<int> seeds, int count, int rank, Workers &workers) {
    auto width = (size_t)columns;
    std::vector<float> scaled(rows.size());
    for (size_t i = 0; i < rows.size(); ++i) scaled[i] = rows[i] * scale[i % width];
    PcaSettings settings = {.clusters = count, .dimensions = (rank + 7) & ~7};
    HeapArena memory(compressBytes((int)seeds.size(), columns, settings));
    ClusteredPca p = {};
    p.rows = (int)seeds.size(), p.columns = columns, p.data = scaled.data(), p.cluster = seeds.data();
    if (!compress(p, settings, memory.arena, workers)) throw std::runtime_error("there is not enough memory");
    Clusters to = {count, rank, columns, std::vector<int>(p.cluster, p.cluster + p.rows), {}, {}};
    to.axes.resize((size_t)count * (size_t)(1 + rank) * width);
    to.weights.resize(seeds.size() * (size_t)rank);
    parallelFor(workers, count, [&](int c, int) { sortAxes(p, c, scale, to); });
    return to;
}

std::vector<int> blocksOf(const Solution &model, int count) {
    std::vector<std::array<float, 6>> at;
    std::array<float, 3> lo = {kInfinity, kInfinity, kInfinity}, hi = {-kInfinity, -kInfinity, -kInfinity};
    for (const Texel &t : model.texels) {
        const Chart &c = model.charts[(size_t)t.chart];
        Vec3 p = c.at((float)t.x * c.width / (float)c.across, (float)t.y * c.height / (float)c.down);
        at.push_back({p.x, p.y, p.z, c.n.x, c.n.y, c.n.z});
        for (size_t k = 0; k < 3; ++k)
            lo[k] = std::min(lo[k], at.back()[k]), hi[k] = std::max(hi[k], at.back()[k]);
    }
    float normal = 0.35f * std::max({hi[0] - lo[0], hi[1] - lo[1], hi[2] - lo[2]});
    for (auto &a : at)
        for (size_t k = 3; k < 6; ++k) a[k] *= normal;
    std::vector<int> order(at.size()), block(at.size());
    std::iota(order.begin(), order.end(), 0);
    int next = 0;
    std::function<void(size_t, size_t, int)> divide = [&](size_t begin, size_t end, int parts) {
        if (parts <= 1) {
            for (size_t i = begin; i < end; ++i) block[(size_t)order[i]] = next;
            ++next;
            return;
        }
        size_t widest = 0;
        float most = -1;
        for (size_t axis = 0; axis < 6; ++axis) {
            float low = kInfinity, high = -kInfinity;
            for (size_t i = begin; i < end; ++i) {
                low = std::min(low, at[(size_t)order[i]][axis]);
                high = std::max(high, at[(size_t)order[i]][axis]);
            }
            if (high - low > most) most = high - low, widest = axis;
        }
        size_t middle = begin + (end - begin) * (size_t)(parts / 2) / (size_t)parts;
        std::nth_element(order.begin() + (ptrdiff_t)begin, order.begin() + (ptrdiff_t)middle,
                         order.begin() + (ptrdiff_t)end, [&](int a, int b) {
                             float x = at[(size_t)a][widest], y = at[(size_t)b][widest];
                             return x != y ? x < y : a < b;
                         });
        divide(begin, middle, parts / 2);
        divide(middle, end, parts - parts / 2);
    };
    divide(0, order.size(), count);
    return block;
}

double compressionError(const Clusters &c, const std::vector<float> &rows, const std::vector<float> &scale,
                        int rank) {
    double lost = 0, all = 0;
    auto width = (size_t)c.columns;
    for (size_t t = 0; t < c.of.size(); ++t) {
        const float *axes = c.axesOf(c.of[t]), *weights = c.weights.data() + t * (size_t)c.rank;
        for (size_t k = 0; k < width; ++k) {
            float value = axes[k], exact = rows[t * width + k];
            for (int d = 0; d < rank; ++d) value += weights[d] * axes[(size_t)(1 + d) * width + k];
            lost += std::pow((double)((value - exact) * scale[k]), 2),
                all += std::pow((double)(exact * scale[k]), 2);
        }
    }
    return all > 0 ? std::sqrt(lost / all) : 0;
}

} // namespace odraz::radiosity
