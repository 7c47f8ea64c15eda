#include "tools/radiosity/study/gathering.h"

#include "tools/common/statistics.h"
#include "tools/radiosity/patches/any_hemicube.h"
#include "tools/support/luminance.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace odraz::radiosity {

namespace {

constexpr int kUnfolded = 480;         // pixels along a picture's side
constexpr int kWithin = 3;             // samples along a pixel's side
constexpr double kLeastSeconds = 0.05; // duration of a measurement

} // namespace

Eye cornerEye(const Model &m, int patch, int k) {
    const Patch &p = m.patches[patch];
    const Chart &c = m.charts[p.chart];
    Vec3 at = p.p;
    if (p.share == 1) {
        int x = (patch - c.firstPatch) % c.patchesAcross, y = (patch - c.firstPatch) / c.patchesAcross;
        float inside[2] = {0.1f, 0.9f};
        at = c.at(((float)x + inside[k & 1]) * c.width / (float)c.patchesAcross,
                  ((float)y + inside[k >> 1]) * c.height / (float)c.patchesDown);
    }
    return hemicubeEye(at, p.n, (uint32_t)patch * 4 + (uint32_t)k);
}

Gathering::Gathering(Study &study, const Solved &divided, int count)
    : study(study), model(*divided.patches->model), radiosity((size_t)model.patchCount) {
    const Solution &reference = study.reference;
    std::vector<int> visible;
    for (int i = 0; i < model.patchCount; ++i) {
        const Patch &p = model.patches[i];
        auto chart = (size_t)p.chart;
        radiosity[(size_t)i] = reference.radiosityAt(p.chart, p.p);
        if (p.share > 0 && maxComponent(reference.reflects[chart]) > 0) visible.push_back(i);
    }
    // Spread the gathering patches by area, like the points of all other errors; take a large patch only once
    std::vector<double> sums;
    double area = 0;
    for (int i : visible) sums.push_back(area += (double)model.patches[i].area);
    for (int k = 0, last = -1; k < count && !visible.empty(); ++k) {
        auto at = std::upper_bound(sums.begin(), sums.end(), area * (k + 0.5) / count) - sums.begin();
        int i = visible[std::min((size_t)at, visible.size() - 1)];
        if (i == last) continue;
        last = i;
        patches.push_back(i);
        outside.push_back(luminance(divided.patches->direct[(size_t)i]));
        expected.push_back(luminance(reference.lightAt(model.patches[i].chart, model.patches[i].p)));
    }
}

Gathering::Result Gathering::measure(int px, int each, bool corners) {
    if (patches.empty()) return {errorsOf(expected, expected), NAN, {}};
    AnyHemicubes hemicubes(study.gl, px);
    const auto batch = (size_t)hemicubes.h.batch;
    std::vector<Eye> eyes;
    for (int i : patches)
        for (int k = 0; k < each; ++k)
            eyes.push_back(corners ? cornerEye(model, i, k)
                                   : hemicubeEye(model.patches[i].p, model.patches[i].n,
                                                 (uint32_t)i + (uint32_t)k * 0x9e3779b9u));
    // Draw once untimed, because the first picture takes longer. Measure a few patches several times
    hemicubes.draw(model, {&eyes[0], 1});
    Workers serial = serialWorkers();
    Stopwatch watch;
    std::vector<float> light;
    int rounds = 0;
    for (; rounds == 0 || (rounds < 20 && watch.processor() < kLeastSeconds); ++rounds) {
        light.assign(patches.size(), 0);
        for (size_t first = 0; first < eyes.size(); first += batch) {
            study.check();
            auto batchEyes = std::span(eyes).subspan(first, std::min(batch, eyes.size() - first));
            const auto &rows = hemicubes.rows(model, batchEyes, serial);
            for (size_t k = 0; k < rows.size(); ++k) {
                float sum = 0;
                for (size_t j = 0; j < radiosity.size(); ++j)
                    if (rows[k][j] > 0) sum += rows[k][j] * luminance(radiosity[j]);
                light[(first + k) / (size_t)each] += sum / (float)each;
            }
        }
    }
    double seconds = watch.processor() / (double)(patches.size() * (size_t)rounds);
    for (size_t i = 0; i < light.size(); ++i) light[i] += outside[i];
    study.taskDone();
    return {errorsOf(light, expected), seconds, std::move(light)};
}

int Gathering::patchSeeingMost() {
    AnyHemicubes opened(study.gl, 50);
    int best = -1;
    size_t most = 0;
    for (size_t k = 0; k < patches.size(); k += std::max(patches.size() / 32, (size_t)1)) {
        const Patch &p = model.patches[patches[k]];
        Eye eye = hemicubeEye(p.p, p.n, (uint32_t)patches[k]);
        opened.draw(model, {&eye, 1});
        std::set<uint32_t> seen;
        for (int y = 0; y < 150; ++y)
            for (int x = 0; x < 50; ++x)
                seen.insert(hemicubeIds(opened.h, 0)[y * hemicubeStride(opened.h) + x]);
        if (seen.size() > most) most = seen.size(), best = patches[k];
    }
    return best;
}

pictures::Image Gathering::unfolded(int patch, int px) {
    AnyHemicubes opened(study.gl, px);
    const Patch &p = model.patches[patch];
    Eye eye = hemicubeEye(p.p, p.n, (uint32_t)patch);
    opened.draw(model, {&eye, 1});
    const uint32_t *ids = hemicubeIds(opened.h, 0);
    int stride = hemicubeStride(opened.h);
    std::vector<float> all;
    for (const Rgb &c : radiosity)
        if (luminance(c) > 0) all.push_back(std::log(luminance(c)));
    float low = all.empty() ? 0 : common::quantile(all, 0.02),
          high = all.empty() ? 1 : common::quantile(all, 0.998);
    // The raster's id at a point in -2 .. 2, or null outside the faces: the top face extends from -1 to 1,
    // and the half faces end with the horizon at -2 and 2
    auto idAt = [&](float x, float y) -> const uint32_t * {
        bool beyondX = std::fabs(x) > 1, beyondY = std::fabs(y) > 1;
        if (beyondX && beyondY) return nullptr;
        int side = x > 1 ? 0 : y > 1 ? 1 : x < -1 ? 2 : y < -1 ? 3 : -1;
        float along[4] = {y, -x, -y, x}, up = 2 - (beyondX ? std::fabs(x) : std::fabs(y)), n = (float)px;
        float column = side < 0 ? x : along[side],
              line = side < 0 ? (y + 1) / 2 * n : n + ((float)side + up) * n / 2;
        // In odd rasters, a point between the rows of half faces belongs to the row above
        int row = std::clamp((int)line, 0, 3 * px - 1);
        if (px % 2 && side >= 0 && (row - px) % px == px / 2) row += side % 2 ? 1 : -1;
        return &ids[row * stride + std::clamp((int)((column + 1) / 2 * n), 0, px - 1)];
    };
    auto shade = [&](uint32_t id) {
        Rgb c = id == kNothing || id == kBackSide ? Rgb{} : radiosity[id - 1];
        return maxComponent(c) > 0 ? logarithmicTone(c, low, high) * 255.f : Rgb{30, 30, 30};
    };
    pictures::Image picture = {kUnfolded, kUnfolded,
                               std::vector<uint8_t>((size_t)kUnfolded * kUnfolded * 3, 255)};
    constexpr int kPoints = kUnfolded * kWithin;
    for (int j = 0; j < kUnfolded; ++j)
        for (int i = 0; i < kUnfolded; ++i) {
            Rgb sum = {};
            for (int k = 0; k < kWithin * kWithin; ++k) {
                float x = ((float)(i * kWithin + k % kWithin) + 0.5f) * 4 / kPoints - 2,
                      y = 2 - ((float)(j * kWithin + k / kWithin) + 0.5f) * 4 / kPoints;
                const uint32_t *id = idAt(x, y);
                sum += id ? shade(*id) : Rgb{255, 255, 255};
            }
            uint8_t *to = &picture.rgb[((size_t)j * kUnfolded + (size_t)i) * 3];
            const float mean[3] = {sum.x, sum.y, sum.z};
            for (int k = 0; k < 3; ++k) to[k] = (uint8_t)(mean[k] / (kWithin * kWithin) + 0.5f);
        }
    return picture;
}

} // namespace odraz::radiosity
