#include "transfer/glossy.h"

#include "base/maths.h"

namespace odraz {

namespace {

constexpr int kPadded = 32; // 25 coefficients, padded

// What arrives at a patch, for every basis and channel.
struct Arriving {
    float sum[3 * kMaxBases][kPadded];

    // Adds four links: the coefficients of each link, times the radiances that it brings for `columns` bases
    // and channels.
    void add(const float (&coefficients)[4][kPadded], const float *const *radiances, int columns) {
        for (int k = 0; k < columns; ++k) {
            Float8 s[4];
#pragma GCC unroll 4
            for (int j = 0; j < 4; ++j) s[j] = load(sum[k] + 8 * j);
#pragma GCC unroll 4
            for (int l = 0; l < 4; ++l) {
                Float8 radiance = broadcast(radiances[l][k]);
#pragma GCC unroll 4
                for (int j = 0; j < 4; ++j) s[j] = fmadd(load(coefficients[l] + 8 * j), radiance, s[j]);
            }
#pragma GCC unroll 4
            for (int j = 0; j < 4; ++j) store(sum[k] + 8 * j, s[j]);
        }
    }
};

// The matrix of one patch, from all the links in its row of form factors.
void findMatrix(const Model &m, const Radiosity &r, int patch, float *matrix) {
    const Row &row = r.factors.rows[patch];
    Vec3 p = m.patches[patch].p, n = m.patches[patch].n;
    int bases = r.bases.count();
    Arriving all = {};
    static constexpr float kDark[3 * kMaxBases] = {};
    for (int first = 0; first < row.count; first += 8) {
        // Directions and solid angles of eight patches
        int count = min(row.count - first, 8);
        Vec3x8 to;
        Float8 share = {};
        for (int k = 0; k < 8; ++k) {
            const Link &link = row.links[first + min(k, count - 1)];
            Vec3 d = m.patches[link.patch].p - p;
            to.x[k] = d.x, to.y[k] = d.y, to.z[k] = d.z;
            if (k < count) share[k] = link.share;
        }
        to = normalize(to);
        Float8 y[kSh], solidAngle = share * kPi / max(dot(to, n), 0.05f);
        evaluate(to, y);
        for (int four = 0; four < count; four += 4) {
            float coefficients[4][kPadded] = {}, sky[4][3 * kMaxBases];
            const float *radiances[4];
            for (int l = 0; l < 4; ++l) {
                int k = four + l;
                radiances[l] = kDark;
                if (k >= count) continue;
                for (int j = 0; j < kSh; ++j) coefficients[l][j] = y[j][k] * solidAngle[k];
                uint32_t from = row.links[first + k].patch;
                radiances[l] = r.system.radiosity + (size_t)from * (size_t)r.system.columns;
                if (!m.charts[m.patches[from].chart].open) continue;
                for (int i = 0; i < 3 * bases; ++i) sky[l][i] = i < 3 * kSh ? y[i / 3][k] : 0;
                radiances[l] = sky[l];
            }
            all.add(coefficients, radiances, 3 * bases);
        }
    }
    for (int i = 0; i < 3 * bases; ++i)
        for (int j = 0; j < kSh; ++j) matrix[i / 3 * kGlossOutputs + i % 3 * kSh + j] = all.sum[i][j];
}

} // namespace

bool findGlossy(Glossy &g, const Model &m, const Radiosity &r, int chart, const float *importance,
                const GlossySettings &settings, Arena &arena, Workers &workers) {
    const Chart &c = m.charts[chart];
    int patchesAcross = c.patchesAcross, patchesDown = c.patchesDown, patches = patchesAcross * patchesDown;
    g.chart = &c;
    g.bases = r.bases.count();
    g.across = (patchesAcross + 1) / 2, g.down = (patchesDown + 1) / 2;
    int count = g.across * g.down, columns = g.bases * kGlossOutputs;
    size_t width = (size_t)columns;
    float *each = arena.take<float>((size_t)patches * width), *scale = arena.take<float>(width),
          *inverse = arena.take<float>(width);
    g.matrices = arena.take<float>((size_t)count * width);
    g.pca.cluster = arena.take<int>((size_t)count);
    for (float *&plane : g.plane) plane = arena.take<float>((size_t)count);
    if (arena.full) return false;

    // Charts that are lamps also shine directly, in their own basis
    for (int k = 0; k < r.bases.lampCount; ++k)
        for (int i = 0; i < m.patchCount; ++i)
            if (r.bases.lamps[k].chart == m.patches[i].chart)
                for (int channel = 0; channel < 3; ++channel)
                    r.system.radiosity[i * r.system.columns + 3 * (r.bases.firstLamp() + k) + channel] = 1;
    parallelFor(workers, patches,
                [&](int i, int) { findMatrix(m, r, c.firstPatch + i, each + (size_t)i * width); });
    fillPatches(m, r.factors, columns, each, c.firstPatch, patches);

    // Each square gets the mean of its patches. The first clusters are blocks, about as wide as high
    int clusters = settings.pca.clusters, wide = 1;
    while (wide < g.across && (wide + 1) * (wide + 1) * g.down <= clusters * g.across) ++wide;
    int high = min(clusters / wide, g.down);
    parallelFor(workers, count, [&](int i, int) {
        int x = i % g.across, y = i / g.across, u = x * patchesAcross / g.across,
            v = y * patchesDown / g.down, uEnd = (x + 1) * patchesAcross / g.across,
            vEnd = (y + 1) * patchesDown / g.down;
        float *to = g.matrices + (size_t)i * width, share = 1.f / (float)((uEnd - u) * (vEnd - v));
        for (; v < vEnd; ++v)
            for (int k = u; k < uEnd; ++k) {
                const float *from = each + (size_t)(v * patchesAcross + k) * width;
                for (int j = 0; j < columns; j += 8)
                    store(to + j, fmadd(load(from + j), share, load(to + j)));
            }
        g.pca.cluster[i] = y * high / g.down * wide + x * wide / g.across;
    });

    // Weights every entry by the importance of its light and by the lobe; skies, suns and lamps count alike
    const int ends[] = {0, r.bases.firstSun(), r.bases.firstLamp(), g.bases};
    auto multiply = [&](float *rows, int rowCount, const float *factors) {
        for (int i = 0; i < rowCount; ++i, rows += width)
            for (int k = 0; k < columns; k += 8) store(rows + k, load(rows + k) * load(factors + k));
    };
    auto lobe = [&](int column) {
        return window((int)sqrt((float)(column % kGlossOutputs % kSh) + 0.5f), settings.exponent);
    };
    for (int k = 0; k < columns; ++k) scale[k] = importance[k / kGlossOutputs] * lobe(k);
    multiply(g.matrices, count, scale);
    for (int kind = 0; kind < 3; ++kind) {
        Float8 square = {};
        int begin = ends[kind] * kGlossOutputs, end = ends[kind + 1] * kGlossOutputs;
        for (int i = 0; i < count; ++i)
            for (int k = begin; k < end; k += 8) {
                Float8 v = load(g.matrices + (size_t)i * width + k);
                square = fmadd(v, v, square);
            }
        float size = sqrt(total(square)) + 1e-20f;
        for (int k = begin; k < end; ++k) {
            inverse[k] = scale[k] > 0 ? lobe(k) * size / scale[k] : 0;
            scale[k] = 1 / size;
        }
    }
    multiply(g.matrices, count, scale);
    g.pca.rows = count;
    g.pca.columns = columns;
    g.pca.data = g.matrices;
    if (!compress(g.pca, settings.pca, arena, workers)) return false;
    multiply(g.pca.axes, clusters * (1 + g.pca.dimensions), inverse);
    return true;
}

void relightGlossy(const Glossy &g, const LightVector &light, const Vec3 &eye, float reflect,
                   float strength) {
    const ClusteredPca &pca = g.pca;
    const Chart &chart = *g.chart;
    // The strength of each entry
    float weights[kMaxBases][kGlossOutputs] = {};
    for (int k = 0; k < g.bases; ++k)
        for (int j = 0; j < kSh; ++j) {
            weights[k][j] = light.bounced[k].x;
            weights[k][kSh + j] = light.bounced[k].y;
            weights[k][2 * kSh + j] = light.bounced[k].z;
        }
    for (int c = 0; c < pca.clusters; ++c) {
        // The means and axes of the clusters under this light
        float shown[1 + kMaxDimensions][kGlossOutputs];
        const float *axis = pca.axesOf(c);
        for (int d = 0; d <= pca.dimensions; ++d) {
            for (float &s : shown[d]) s = 0;
            for (int k = 0; k < g.bases; ++k, axis += kGlossOutputs) {
                if (weights[k][0] == 0 && weights[k][kSh] == 0 && weights[k][2 * kSh] == 0) continue;
                for (int j = 0; j < kGlossOutputs; j += 8)
                    store(shown[d] + j, fmadd(load(axis + j), load(weights[k] + j), load(shown[d] + j)));
            }
        }
        // The squares, eight at a time
        for (int first = pca.first[c]; first < pca.first[c + 1]; first += 8) {
            Int8 square = {};
            for (int k = 0; k < 8; ++k) square[k] = pca.members[min(first + k, pca.first[c + 1] - 1)];
            Float8 line = floor((toFloat(square) + 0.5f) / (float)g.across);
            Float8 s = (toFloat(square) - line * (float)g.across + 0.5f) * (chart.width / (float)g.across),
                   t = (line + 0.5f) * (chart.height / (float)g.down);
            Vec3x8 d = normalize(chart.u * s + chart.v * t + (chart.corner - eye));
            Float8 cosine = dot(d, chart.n), y[kSh], weight[kMaxDimensions];
            evaluate(fmadd(broadcast(chart.n), cosine * -2.f, d), y);
            for (int k = 0; k < pca.dimensions; ++k)
                weight[k] = gather(pca.weights + k, square * pca.dimensions);
            Float8 grazing = 1.f - saturate(abs(cosine)), twice = grazing * grazing;
            Float8 mirrored = fmadd(twice * twice * grazing, 1 - reflect, broadcast(reflect)) * strength;
            for (int channel = 0; channel < 3; ++channel) {
                Float8 sum = {};
                for (int j = 0; j < kSh; ++j) {
                    int at = channel * kSh + j;
                    Float8 arriving = broadcast(shown[0][at]);
                    for (int k = 0; k < pca.dimensions; ++k)
                        arriving = fmadd(weight[k], shown[1 + k][at], arriving);
                    sum = fmadd(arriving, y[j], sum);
                }
                sum = max(sum, 0.f) * mirrored;
                for (int k = 0; k < 8; ++k) g.plane[channel][square[k]] = sum[k];
            }
        }
    }
}

} // namespace odraz
