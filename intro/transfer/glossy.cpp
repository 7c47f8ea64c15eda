#include "transfer/glossy.h"

#include "base/maths.h"

namespace odraz {

namespace {

constexpr int kPadded = 32; // 25 coefficients, padded

// The light that arrives at a patch, as coefficients for every basis and channel.
struct IncidentLight {
    float sum[3 * kMaxBases][kPadded];

    // Adds four links: each link's coefficients times its radiances, for `columns` bases and channels.
    void add(const float (&coefficients)[4][kPadded], const float *const *radiances, int columns) {
        for (int k = 0; k < columns; ++k) {
            Float8 s[4];
#pragma GCC unroll 4
            for (int j = 0; j < 4; ++j) s[j] = load(sum[k] + 8 * j);
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

// Computes the matrix of one patch, from all links of its row of form factors.
void findMatrix(const Model &m, const Radiosity &r, int patch, float exponent, float *matrix) {
    const FormFactorRow &row = r.factors.rows[patch];
    Vec3 p = m.patches[patch].p, n = m.patches[patch].n;
    int bases = r.bases.count();
    IncidentLight incident = {};
    static constexpr float kDark[3 * kMaxBases] = {};
    for (int first = 0; first < row.count; first += 8) {
        // Compute the directions and solid angles of eight patches
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
            incident.add(coefficients, radiances, 3 * bases);
        }
    }
    for (int j = 0; j < kSh; ++j) {
        float lobe = window((int)sqrt((float)j + 0.5f), exponent);
        for (int i = 0; i < 3 * bases; ++i)
            matrix[i / 3 * kGlossOutputs + i % 3 * kSh + j] = incident.sum[i][j] * lobe;
    }
}

} // namespace

bool findGlossy(Glossy &g, const Model &m, const Radiosity &r, int chart, float exponent, Arena &arena,
                Workers &workers) {
    const Chart &c = m.charts[chart];
    int patchesAcross = c.patchesAcross, patchesDown = c.patchesDown, patches = patchesAcross * patchesDown;
    g.chart = &c;
    g.bases = r.bases.count();
    g.across = (patchesAcross + 1) / 2, g.down = (patchesDown + 1) / 2;
    int count = g.across * g.down, columns = g.bases * kGlossOutputs;
    size_t width = (size_t)columns;
    float *each = arena.allocate<float>((size_t)patches * width),
          *matrices = arena.allocate<float>((size_t)count * width);
    g.matrices = matrices;
    for (float *&plane : g.plane) plane = arena.allocate<float>((size_t)count);
    if (arena.full) return false;

    // Add the emission of charts that are lamps, in their own basis
    for (int k = 0; k < r.bases.lampCount; ++k)
        for (int i = 0; i < m.patchCount; ++i)
            if (r.bases.lamps[k].chart == m.patches[i].chart)
                for (int channel = 0; channel < 3; ++channel)
                    r.system.radiosity[i * r.system.columns + 3 * (r.bases.firstLamp() + k) + channel] = 1;
    parallelFor(workers, patches,
                [&](int i, int) { findMatrix(m, r, c.firstPatch + i, exponent, each + (size_t)i * width); });
    fillPatches(m, r.factors, columns, each, c.firstPatch, patches);

    // Give each square the mean of its patches
    for (int i = 0; i < count; ++i) {
        int x = i % g.across, y = i / g.across, u = x * patchesAcross / g.across,
            v = y * patchesDown / g.down, uEnd = (x + 1) * patchesAcross / g.across,
            vEnd = (y + 1) * patchesDown / g.down;
        float *to = matrices + (size_t)i * width, share = 1.f / (float)((uEnd - u) * (vEnd - v));
        for (; v < vEnd; ++v)
            for (int k = u; k < uEnd; ++k) {
                const float *from = each + (size_t)(v * patchesAcross + k) * width;
                for (int j = 0; j < columns; j += 8)
                    store(to + j, fmadd(load(from + j), share, load(to + j)));
            }
    }
    return true;
}

void relightGlossy(const Glossy &g, const LightVector &light, const Vec3 &eye, float reflect,
                   float strength) {
    const Chart &chart = *g.chart;
    // Compute the weight of each entry
    float weights[kMaxBases][kGlossOutputs] = {};
    for (int k = 0; k < g.bases; ++k)
        for (int j = 0; j < kSh; ++j) {
            weights[k][j] = light.bounced[k].x;
            weights[k][kSh + j] = light.bounced[k].y;
            weights[k][2 * kSh + j] = light.bounced[k].z;
        }
    // Light the squares, eight at a time
    int count = g.across * g.down;
    for (int first = 0; first < count; first += 8) {
        float incident[8][kGlossOutputs] = {};
        Int8 square = {};
        for (int l = 0; l < 8; ++l) {
            square[l] = min(first + l, count - 1);
            const float *entry = g.matrices + (size_t)(square[l] * g.bases) * kGlossOutputs;
            for (int k = 0; k < g.bases; ++k, entry += kGlossOutputs) {
                if (maxComponent(light.bounced[k]) == 0) continue;
                for (int j = 0; j < kGlossOutputs; j += 8)
                    store(incident[l] + j,
                          fmadd(load(entry + j), load(weights[k] + j), load(incident[l] + j)));
            }
        }
        Float8 line = floor((toFloat(square) + 0.5f) / (float)g.across);
        Float8 s = (toFloat(square) - line * (float)g.across + 0.5f) * (chart.width / (float)g.across),
               t = (line + 0.5f) * (chart.height / (float)g.down);
        Vec3x8 d = normalize(chart.u * s + chart.v * t + (chart.corner - eye));
        Float8 cosine = dot(d, chart.n), y[kSh];
        evaluate(fmadd(broadcast(chart.n), cosine * -2.f, d), y);
        Float8 grazing = 1.f - saturate(abs(cosine)), twice = grazing * grazing;
        Float8 mirrored = fmadd(twice * twice * grazing, 1 - reflect, broadcast(reflect)) * strength;
        for (int channel = 0; channel < 3; ++channel) {
            Float8 sum = {};
            for (int j = 0; j < kSh; ++j)
                sum = fmadd(gather(incident[0] + channel * kSh + j, kLanes * kGlossOutputs), y[j], sum);
            sum = max(sum, 0.f) * mirrored;
            for (int k = 0; k < 8; ++k) g.plane[channel][square[k]] = sum[k];
        }
    }
}

} // namespace odraz
