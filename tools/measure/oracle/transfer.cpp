#include "tools/measure/oracle/transfer.h"

#include "tools/common/clock.h"
#include <algorithm>
#include <cmath>

namespace odraz::measure {

using namespace radiosity;

TransferRows rowsOf(const SolvedHall &solved, bool suns) {
    const Radiosity &r = solved.hall->radiosity;
    const Model &m = solved.hall->model;
    std::vector<int> bases;
    for (int k = 0; k < r.bases.count(); ++k)
        if (suns || k < kFirstSun || k >= kFirstLantern) bases.push_back(k);
    TransferRows t = {m.texelCount, (int)((3 * bases.size() + 7) & ~7u), {}};
    t.data.resize((size_t)t.rows * (size_t)t.columns);
    auto kindOf = [](int basis) { return basis < kFirstSun ? 0 : basis < kFirstLantern ? 1 : 2; };
    double square[3] = {};
    for (int pass = 0; pass < 2; ++pass)
        for (size_t k = 0; k < bases.size(); ++k)
            for (size_t c = 0; c < 3; ++c) {
                int basis = bases[k];
                for (int i = 0; i < t.rows; ++i) {
                    float v = r.bounced[basis][c][i] + (basis >= kFirstStrip ? r.direct[basis][i] : 0);
                    if (pass == 0)
                        square[kindOf(basis)] += (double)(v * v);
                    else
                        t.data[(size_t)i * (size_t)t.columns + 3 * k + c] =
                            v / (float)std::sqrt(square[kindOf(basis)]);
                }
            }
    return t;
}

Compressed compressed(const TransferRows &rows, const std::vector<int> &seeds, const PcaSettings &settings,
                      Workers &workers) {
    Compressed c;
    size_t bytes = compressBytes(rows.rows, rows.columns, settings) + (size_t)rows.rows * sizeof(int);
    c.memory = std::make_unique<HeapArena>(bytes);
    c.pca = {};
    c.pca.rows = rows.rows, c.pca.columns = rows.columns, c.pca.data = rows.data.data();
    c.pca.cluster = c.memory->arena.take<int>((size_t)rows.rows);
    std::copy(seeds.begin(), seeds.end(), c.pca.cluster);
    double began = common::processorSeconds();
    if (!compress(c.pca, settings, c.memory->arena, workers)) throw std::runtime_error("memory is short");
    c.seconds = common::processorSeconds() - began;
    double error = 0, all = 0;
    for (int r = 0; r < rows.rows; ++r) {
        const float *axes = c.pca.axesOf(c.pca.cluster[r]),
                    *weights = c.pca.weights + (size_t)r * (size_t)c.pca.dimensions;
        for (int i = 0; i < rows.columns; ++i) {
            double v = (double)axes[i],
                   exact = (double)rows.data[(size_t)r * (size_t)rows.columns + (size_t)i];
            for (int d = 0; d < c.pca.dimensions; ++d)
                v += (double)weights[d] * (double)axes[(size_t)(1 + d) * (size_t)rows.columns + (size_t)i];
            error += (v - exact) * (v - exact), all += exact * exact;
        }
    }
    c.errorPercent = 100 * std::sqrt(error / all);
    return c;
}

void relightRows(const ClusteredPca &p, const float *light, float *const plane[3]) {
    for (int c = 0; c < p.clusters; ++c) {
        // The representatives' colours. Columns run red, green, blue, so every three vectors hold eight of
        // each
        float shown[1 + kMaxDimensions][3];
        const float *axis = p.axesOf(c);
        for (int d = 0; d <= p.dimensions; ++d, axis += p.columns) {
            Float8 sum[3] = {};
            for (int i = 0; i < p.columns; i += 24)
                for (int k = 0; k < 3 && i + 8 * k < p.columns; ++k)
                    sum[k] = fmadd(load(axis + i + 8 * k), load(light + i + 8 * k), sum[k]);
            float rgb[3] = {};
            for (int lane = 0; lane < 24; ++lane) rgb[lane % 3] += sum[lane / 8][lane % 8];
            for (int k = 0; k < 3; ++k) shown[d][k] = rgb[k];
        }
        for (int first = p.first[c]; first < p.first[c + 1]; first += 8) {
            int count = std::min(p.first[c + 1] - first, 8);
            Int8 row = {};
            for (int k = 0; k < 8; ++k) row[k] = p.members[first + std::min(k, count - 1)];
            Float8 rgb[3] = {broadcast(shown[0][0]), broadcast(shown[0][1]), broadcast(shown[0][2])};
            for (int d = 0; d < p.dimensions; ++d) {
                Float8 weight = gather(p.weights + d, row * p.dimensions);
                for (int k = 0; k < 3; ++k) rgb[k] = fmadd(weight, shown[1 + d][k], rgb[k]);
            }
            for (int k = 0; k < 3; ++k)
                for (int i = 0; i < count; ++i) plane[k][row[i]] = rgb[k][i];
        }
    }
}

namespace {

// The hall, solved for the exact skies and suns of some days: each sky in red, green and blue, then the suns.
SolvedHall solvedFor(const std::vector<Sky> &skies, const std::vector<Daylight> &days, const Gl &gl,
                     Workers &workers) {
    return SolvedHall(kHallSettings, gl, workers, kRoomBytes, [&](LightBases &l) {
        l.skyCount = 3 * (int)skies.size();
        l.skies = &skies;
        l.sky = [](const void *from, const Vec3x8 &d, Float8 *values) {
            for (const Sky &sky : *(const std::vector<Sky> *)from) {
                Rgb8 light = radiance(sky, d);
                *values++ = light.x, *values++ = light.y, *values++ = light.z;
            }
        };
        l.sunCount = (int)days.size();
        for (size_t i = 0; i < days.size(); ++i) l.suns[i] = days[i].sunAt;
        l.lampCount = 0;
    });
}

// The error of the relit hall's planes against the exact ones of a day. The exact sky includes the glow near
// the sun. The picture draws that glow as part of the sun, whose direct light is `direct`.
DayError errorOf(const TexelPlanes &got, const TexelPlanes &exact, const float *direct, int texels,
                 const Daylight &day) {
    Rgb glow = day.sky.near * kNearGlow, alone = day.sunlight - glow;
    double error = 0, base = 0, whole = 0, wholeBase = 0;
    for (size_t c = 0; c < 3; ++c) {
        auto channel = [&](Rgb v) { return (double)(c == 0 ? v.x : c == 1 ? v.y : v.z); };
        for (int t = 0; t < texels; ++t) {
            double sun = (double)direct[t], g = (double)got.plane[c][t], e = (double)exact.plane[c][t];
            double withSun = g + sun * channel(day.sunlight), truth = e + sun * channel(alone);
            whole += (withSun - truth) * (withSun - truth), wholeBase += truth * truth;
            // Take out the part that the picture draws with the sun
            e -= sun * channel(glow);
            error += (g - e) * (g - e), base += e * e;
        }
    }
    return {0, 0, 100 * std::sqrt(error / base), 100 * std::sqrt(whole / wholeBase)};
}

} // namespace

std::vector<DayError> dayErrors(const std::vector<float> &hours, const std::vector<int> &bands, const Gl &gl,
                                Workers &workers) {
    constexpr size_t kMost = 10; // skies at once
    SolvedHall relit(kHallSettings, gl, workers);
    const Model &m = relit.hall->model;
    TexelPlanes got(m.texelCount), exact(m.texelCount);
    std::vector<DayError> all;
    for (size_t first = 0; first < hours.size(); first += kMost) {
        std::vector<Sky> skies;
        std::vector<Daylight> days;
        for (size_t i = first; i < std::min(first + kMost, hours.size()); ++i) {
            days.push_back(daylightAt(hours[i]));
            skies.push_back(days.back().sky);
        }
        SolvedHall very = solvedFor(skies, days, gl, workers);
        for (size_t i = 0; i < days.size(); ++i) {
            LightVector own = {};
            int sky = 3 * (int)i, sun = very.hall->radiosity.bases.firstSun() + (int)i;
            own.bounced[sky] = {1, 0, 0}, own.bounced[sky + 1] = {0, 1, 0}, own.bounced[sky + 2] = {0, 0, 1};
            own.bounced[sun] = days[i].sunlight - days[i].sky.near * kNearGlow;
            relight(very.hall->radiosity, very.hall->model, own, exact.plane);
            for (int used : bands) {
                LightVector light = lightVector({hours[first + i], {}, {}, 1});
                for (int k = used * used; k < kSh; ++k) light.bounced[k] = {};
                relight(relit.hall->radiosity, m, light, got.plane);
                DayError e = errorOf(got, exact, very.hall->radiosity.direct[sun], m.texelCount, days[i]);
                e.hour = hours[first + i], e.bands = used;
                all.push_back(e);
            }
        }
    }
    return all;
}

} // namespace odraz::measure
