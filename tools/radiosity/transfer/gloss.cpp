#include "tools/radiosity/transfer/gloss.h"

#include "tools/radiosity/solution/solution.h"
#include "tools/radiosity/transfer/bands.h"

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
void findMatrix(const GlossyChart &g, int bases, const Chart &c, int square,
                const std::vector<Vec3> &directions, float exponent, const Arrives &arrives, float *matrix) {
    Vec3 p = c.at(((float)(square % g.across) + 0.5f) * c.width / (float)g.across,
                  ((float)(square / g.across) + 0.5f) * c.height / (float)g.down) +
             c.n * c.off();
    constexpr int kPadded = 32; // 25 coefficients
    int columns = 3 * bases;
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
std::vector<float> arriving(const Clusters &c, const LightVector &light) {
    // Apply the light to the means and axes
    std::vector<float> lit((size_t)c.count * (size_t)(1 + c.rank) * kGlossOutputs), all;
    const float *axis = c.axes.data();
    for (size_t at = 0; at < lit.size(); at += kGlossOutputs)
        for (int k = 0; k < c.columns / kGlossOutputs; ++k, axis += kGlossOutputs) {
            Rgb l = light.bounced[k];
            for (size_t j = 0; j < 3 * kSh; ++j)
                lit[at + j] += axis[j] * (j < kSh ? l.x : j < 2 * kSh ? l.y : l.z);
        }
    for (size_t square = 0; square < c.of.size(); ++square) {
        const float *from = &lit[(size_t)c.of[square] * (size_t)(1 + c.rank) * kGlossOutputs],
                    *weights = c.weights.data() + square * (size_t)c.rank;
        all.insert(all.end(), from, from + kGlossOutputs);
        for (int d = 0; d < c.rank; ++d)
            for (int j = 0; j < kGlossOutputs; ++j)
                all[square * kGlossOutputs + (size_t)j] += weights[d] * from[(1 + d) * kGlossOutputs + j];
    }
    return all;
}

} // namespace

GlossyChart findGloss(const Chart &c, int number, int bases, float side, int rays, float exponent,
                      const Arrives &arrives, Workers &workers) {
    auto squares = [&](float length) { return std::clamp((int)std::lround(length / side), 1, 1024); };
    GlossyChart g = {number, squares(c.width), squares(c.height), {}};
    int count = g.across * g.down, columns = bases * kGlossOutputs;
    auto width = (size_t)columns;
    std::vector<float> matrices((size_t)count * width);
    const std::vector<Vec3> directions = halfSpace(rays);
    parallelFor(workers, count, [&](int i, int) {
        findMatrix(g, bases, c, i, directions, exponent, arrives, &matrices[(size_t)i * width]);
    });
    // Begin with clusters that are blocks, about as wide as high
    int clusters = std::clamp(count / 32, 1, kMostGlossClusters),
        nx = std::clamp((int)std::lround(std::sqrt((double)clusters * g.across / g.down)), 1, clusters),
        ny = clusters / nx;
    std::vector<int> seeds;
    for (int i = 0; i < count; ++i)
        seeds.push_back(i / g.across * ny / g.down * nx + i % g.across * nx / g.across);
    g.clusters = findClusters(std::move(matrices), columns, std::vector<float>(width, 1.f), std::move(seeds),
                              {.count = clusters, .rank = count > 1 ? 16 : 0, .rounds = 2}, workers);
    return g;
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
        std::vector<float> matrices = arriving(chart.clusters, light);
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
