#include "tools/radiosity/transfer/gloss.h"

#include "tools/radiosity/solution/solution.h"
#include "tools/radiosity/transfer/bands.h"
#include "tools/radiosity/transfer/clustered_pca.h"
#include "tools/support/heap_arena.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odraz::radiosity {

namespace {

constexpr int kMostGlossClusters = 64;

// Directions that cover the half-space about z evenly: Vogel's spiral, projected onto the hemisphere.
std::vector<Vec3> halfSpace(int count) {
    std::vector<Vec3> all;
    for (int i = 0; i < count; ++i) {
        double z = (i + 0.5) / count, r = std::sqrt(1 - z * z), angle = i * 2.399963229728653;
        all.push_back({(float)(r * std::cos(angle)), (float)(r * std::sin(angle)), (float)z});
    }
    return all;
}

// Computes the matrix of a square: [bases][kGlossOutputs], each coefficient times its band's window.
void findMatrix(const GlossyChart &g, const Chart &c, int square, const std::vector<Vec3> &directions,
                float exponent, const Arrives &arrives, float *matrix) {
    Vec3 p = c.at(((float)(square % g.across) + 0.5f) * c.width / (float)g.across,
                  ((float)(square / g.across) + 0.5f) * c.height / (float)g.down) +
             c.n * c.off();
    constexpr int kPadded = 32; // 25 coefficients
    int columns = 3 * g.bases;
    std::vector<float> radiances((size_t)columns), sums((size_t)(columns * kPadded));
    auto solidAngle = (float)(2 * std::numbers::pi / (double)directions.size());
    for (const Vec3 &local : directions) {
        Vec3 d = c.u * local.x + c.v * local.y + c.n * local.z;
        std::fill(radiances.begin(), radiances.end(), 0.f);
        arrives(p, d, radiances.data());
        Float8 y[kSh];
        float coefficients[kPadded] = {};
        evaluate(broadcast(d), y);
        for (int j = 0; j < kSh; ++j) coefficients[j] = y[j][0] * solidAngle;
        for (int k = 0; k < columns; ++k) {
            if (radiances[(size_t)k] == 0) continue;
            float *to = &sums[(size_t)(k * kPadded)];
            Float8 light = broadcast(radiances[(size_t)k]);
            for (int j = 0; j < kPadded; j += 8)
                store(to + j, fmadd(load(coefficients + j), light, load(to + j)));
        }
    }
    for (int k = 0; k < columns; ++k)
        for (int j = 0; j < kSh; ++j)
            matrix[k / 3 * kGlossOutputs + k % 3 * kSh + j] =
                sums[(size_t)(k * kPadded + j)] * window(bandOf(j), exponent);
}

// The squares' coefficients under a light: [squares][kGlossOutputs].
std::vector<float> arriving(const GlossyChart &g, const LightVector &light) {
    auto dimensions = (size_t)g.dimensions;
    std::vector<float> all(g.members.size() * kGlossOutputs);
    for (size_t c = 0; c < (size_t)g.clusters; ++c) {
        // Apply the light to the cluster's mean and axes
        std::vector<float> lit((1 + dimensions) * kGlossOutputs);
        const float *axis = &g.axes[c * (1 + dimensions) * (size_t)g.bases * kGlossOutputs];
        for (size_t d = 0; d <= dimensions; ++d)
            for (int k = 0; k < g.bases; ++k, axis += kGlossOutputs) {
                Rgb l = light.bounced[k];
                for (size_t j = 0; j < 3 * kSh; ++j)
                    lit[d * kGlossOutputs + j] += axis[j] * (j < kSh ? l.x : j < 2 * kSh ? l.y : l.z);
            }
        for (int i = g.first[c]; i < g.first[c + 1]; ++i) {
            auto square = (size_t)g.members[(size_t)i];
            float *to = &all[square * kGlossOutputs];
            for (size_t d = 0; d <= dimensions; ++d) {
                float weight = d ? g.weights[square * dimensions + d - 1] : 1;
                for (size_t j = 0; j < kGlossOutputs; ++j) to[j] += weight * lit[d * kGlossOutputs + j];
            }
        }
    }
    return all;
}

} // namespace

GlossyChart squaresOf(const Chart &c, int number, int bases, float side) {
    GlossyChart g;
    auto squares = [&](float length) { return std::clamp((int)std::lround(length / side), 1, 1024); };
    g.chart = number, g.bases = bases;
    g.across = squares(c.width), g.down = squares(c.height);
    return g;
}

void findGloss(GlossyChart &g, const Chart &c, int rays, float exponent, const Arrives &arrives,
               Workers &workers) {
    int count = g.across * g.down, columns = g.bases * kGlossOutputs;
    auto width = (size_t)columns;
    std::vector<float> matrices((size_t)count * width);
    const std::vector<Vec3> directions = halfSpace(rays);
    parallelFor(workers, count, [&](int i, int) {
        findMatrix(g, c, i, directions, exponent, arrives, &matrices[(size_t)i * width]);
    });
    // Begin with clusters that are blocks, about as wide as high
    g.clusters = std::clamp(count / 32, 1, kMostGlossClusters);
    int nx = std::clamp((int)std::lround(std::sqrt((double)g.clusters * g.across / g.down)), 1, g.clusters),
        ny = g.clusters / nx;
    PcaSettings settings = {.clusters = g.clusters, .dimensions = count > 1 ? 16 : 0, .rounds = 2};
    HeapArena memory(compressBytes(count, columns, settings));
    ClusteredPca p = {};
    p.rows = count, p.columns = columns, p.data = matrices.data();
    std::vector<int> seeds((size_t)count);
    for (int i = 0; i < count; ++i)
        seeds[(size_t)i] = i / g.across * ny / g.down * nx + i % g.across * nx / g.across;
    p.cluster = seeds.data();
    if (!compress(p, settings, memory.arena, workers)) throw std::runtime_error("there is not enough memory");
    g.dimensions = p.dimensions;
    g.members.assign(p.members, p.members + count);
    g.first.assign(p.first, p.first + g.clusters + 1);
    g.axes.assign(p.axes, p.axes + (size_t)g.clusters * (size_t)(1 + p.dimensions) * width);
    g.weights.assign(p.weights, p.weights + (size_t)count * (size_t)p.dimensions);
}

void showGloss(const std::vector<GlossyChart> &gloss, Solution &model, const LightVector &light,
               const Vec3 &eye, float polish) {
    if (gloss.empty()) return;
    model.gloss.assign(model.texels.size(), {});
    for (const GlossyChart &chart : gloss) {
        const Chart &c = model.charts[(size_t)chart.chart];
        int count = chart.across * chart.down;
        std::vector<float> planes((size_t)(3 * count));
        // Use one basis of strength 1, because the light is already in the matrices
        std::vector<float> matrices = arriving(chart, light);
        Glossy g = {&c, 1, chart.across, chart.down, matrices.data(), {}};
        for (int k = 0; k < 3; ++k) g.plane[k] = &planes[(size_t)(k * count)];
        if (dot(eye - c.corner, c.n) > 0) relightGlossy(g, {{{1, 1, 1}}, {}}, eye, polish, 1);
        // Interpolate from the middles of squares to the texels
        for (int j = 0; j <= c.down; ++j)
            for (int i = 0; i <= c.across; ++i) {
                auto spot = [](int at, int cells, int squares, int &low, int &high) {
                    float x = std::clamp((float)at / (float)cells * (float)squares - 0.5f, 0.f,
                                         (float)(squares - 1));
                    low = std::min((int)x, squares - 1), high = std::min(low + 1, squares - 1);
                    return x - (float)low;
                };
                int x0, x1, y0, y1;
                float x = spot(i, c.across, g.across, x0, x1), y = spot(j, c.down, g.down, y0, y1);
                auto at = [&](int k, int l) {
                    auto n = (size_t)(l * g.across + k);
                    return Rgb{g.plane[0][n], g.plane[1][n], g.plane[2][n]};
                };
                model.gloss[(size_t)c.texel(i, j)] =
                    lerp(lerp(at(x0, y0), at(x1, y0), x), lerp(at(x0, y1), at(x1, y1), x), y);
            }
    }
}

} // namespace odraz::radiosity
