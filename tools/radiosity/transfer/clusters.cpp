#include "tools/radiosity/transfer/clusters.h"

#include "base/float8.h"
#include "base/random.h"
#include "tools/radiosity/solution/solution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

namespace odraz::radiosity {

namespace {

// The eigenvectors of a small symmetric matrix by Jacobi rotations, in descending order of their eigenvalues:
// [vector][n].
std::vector<double> eigenvectorsOf(std::vector<double> a, size_t n) {
    std::vector<double> v(n * n), sorted;
    for (size_t i = 0; i < n; ++i) v[i * n + i] = 1;
    auto diagonal = [&] {
        double off = 0, on = 0;
        for (size_t i = 0; i < n; ++i)
            for (size_t j = 0; j < n; ++j) (i == j ? on : off) += a[i * n + j] * a[i * n + j];
        return off <= 1e-24 * on;
    };
    auto rotate = [&](size_t p, size_t q) {
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
    };
    for (int sweep = 0; sweep < 30 && !diagonal(); ++sweep)
        for (size_t p = 0; p < n; ++p)
            for (size_t q = p + 1; q < n; ++q) rotate(p, q);
    std::vector<size_t> order(n);
    std::iota(order.begin(), order.end(), (size_t)0);
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t i, size_t j) { return a[i * n + i] > a[j * n + j]; });
    for (size_t which : order)
        for (size_t row = 0; row < n; ++row) sorted.push_back(v[row * n + which]);
    return sorted;
}

class Clustering {
public:
    Clustering(std::vector<float> rows, int columns, std::vector<int> seeds, const ClusterSettings &s)
        : data(std::move(rows)), settings(s),
          p({s.count, (s.rank + 7) & ~7, columns, std::move(seeds), {}, {}}), members((size_t)p.count) {
        p.axes.resize((size_t)p.count * (size_t)(1 + p.rank) * (size_t)columns);
        // Begin with random weights, because any will do
        for (size_t i = 0; i < p.of.size() * (size_t)p.rank; ++i)
            p.weights.push_back(unitFloat(pcg((uint32_t)i)) - 0.5f);
    }

    void find(Workers &workers) {
        for (int round = 0;; ++round) {
            for (std::vector<int> &m : members) m.clear();
            for (size_t r = 0; r < p.of.size(); ++r) members[(size_t)p.of[r]].push_back((int)r);
            parallelFor(workers, p.count, [&](int c, int) { fit(c); });
            if (round == settings.rounds) return;
            parallelRanges(workers, (int)p.of.size(), 64, [&](int first, int end, int) {
                for (int r = first; r < end; ++r) assign(r);
            });
        }
    }

    // The clusters, with their axes rotated to the principal axes and sorted, and the first ones kept.
    Clusters sorted(const std::vector<float> &scale, Workers &workers) const {
        Clusters to = {p.count, settings.rank, p.columns, p.of, {}, {}};
        to.axes.resize((size_t)to.count * (size_t)(1 + to.rank) * (size_t)to.columns);
        to.weights.resize(p.of.size() * (size_t)to.rank);
        parallelFor(workers, p.count, [&](int c, int) { sortAxes(c, scale, to); });
        return to;
    }

private:
    const std::vector<float> data; // [rows][columns], scaled
    const ClusterSettings settings;
    Clusters p;                            // its rank is a multiple of 8
    std::vector<std::vector<int>> members; // the rows of each cluster

    float *axesOf(int c) { return const_cast<float *>(p.axesOf(c)); }
    const float *rowOf(int r) const { return data.data() + (size_t)r * (size_t)p.columns; }
    float *weightsOf(int r) { return p.weights.data() + (size_t)r * (size_t)p.rank; }

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
        for (int d = 0; weights && d < p.rank; d += 8) {
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
        for (int d = 0; d < p.rank; ++d) {
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
        const std::vector<int> &rows = members[(size_t)c];
        float *mean = axesOf(c), *axes = mean + p.columns;
        if (rows.empty()) return;
        for (int i = 0; i < p.columns; i += 8) {
            Float8 sum = {};
            for (int r : rows) sum += load(rowOf(r) + i);
            store(mean + i, sum * (1.f / (float)rows.size()));
        }
        for (int step = 0; step < settings.iterations; ++step) {
            for (int d = 0; d < p.rank; d += 8)
                for (int i = 0; i < p.columns; i += 8) {
                    Float8 sum[8] = {};
                    for (int r : rows) {
                        Float8 offset = load(rowOf(r) + i) - load(mean + i);
                        const float *weights = weightsOf(r) + d;
#pragma GCC unroll 8
                        for (int k = 0; k < 8; ++k) sum[k] = fmadd(offset, weights[k], sum[k]);
                    }
                    for (int k = 0; k < 8; ++k) store(axes + (size_t)(d + k) * (size_t)p.columns + i, sum[k]);
                }
            orthonormalize(axes);
            for (int r : rows) project(r, c, weightsOf(r));
        }
    }

    // Assigns a row to the cluster with the nearest subspace. The candidates are its present cluster and
    // those with the nearest means.
    void assign(int r) {
        int candidates[8], count = 0, best = p.of[(size_t)r];
        float distances[8], weights[kMostRank], least = project(r, best, weightsOf(r));
        for (int c = 0; c < p.count; ++c) {
            if (members[(size_t)c].empty() || c == p.of[(size_t)r]) continue;
            float distance = project(r, c, nullptr);
            int at = count;
            for (; at > 0 && distance < distances[at - 1]; --at)
                if (at < settings.tried)
                    distances[at] = distances[at - 1], candidates[at] = candidates[at - 1];
            if (at == settings.tried) continue;
            distances[at] = distance, candidates[at] = c;
            count = std::min(count + 1, settings.tried);
        }
        for (int k = 0; k < count; ++k) {
            float distance = project(r, candidates[k], weights);
            if (!(distance < least)) continue;
            least = distance, best = candidates[k];
            for (int d = 0; d < p.rank; ++d) weightsOf(r)[d] = weights[d];
        }
        p.of[(size_t)r] = best;
    }

    void sortAxes(int c, const std::vector<float> &scale, Clusters &to) const {
        const std::vector<int> &rows = members[(size_t)c];
        const int dimensions = p.rank, columns = p.columns;
        std::vector<double> moments((size_t)(dimensions * dimensions));
        for (int r : rows) {
            const float *w = &p.weights[(size_t)r * (size_t)dimensions];
            for (int i = 0; i < dimensions; ++i)
                for (int j = 0; j < dimensions; ++j)
                    moments[(size_t)(i * dimensions + j)] += (double)w[i] * (double)w[j];
        }
        const std::vector<double> turn = eigenvectorsOf(std::move(moments), (size_t)dimensions);
        // Coordinate d of a vector whose present coordinates are `from`, `step` apart
        auto turned = [&](const float *from, int step, int d) {
            double sum = 0;
            for (int i = 0; i < dimensions; ++i)
                sum += turn[(size_t)(d * dimensions + i)] * (double)from[i * step];
            return (float)sum;
        };
        const float *from = p.axesOf(c);
        float *axes = const_cast<float *>(to.axesOf(c));
        for (int k = 0; k < columns; ++k) {
            axes[k] = from[k] / scale[(size_t)k];
            for (int d = 0; d < to.rank; ++d)
                axes[(1 + d) * columns + k] = turned(from + columns + k, columns, d) / scale[(size_t)k];
        }
        for (int r : rows)
            for (int d = 0; d < to.rank; ++d)
                to.weights[(size_t)r * (size_t)to.rank + (size_t)d] =
                    turned(&p.weights[(size_t)r * (size_t)dimensions], 1, d);
    }
};

} // namespace

Clusters findClusters(std::vector<float> rows, int columns, const std::vector<float> &scale,
                      std::vector<int> seeds, const ClusterSettings &settings, Workers &workers) {
    for (size_t i = 0; i < rows.size(); ++i) rows[i] *= scale[i % (size_t)columns];
    Clustering work(std::move(rows), columns, std::move(seeds), settings);
    work.find(workers);
    return work.sorted(scale, workers);
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
