#include "tools/radiosity/patches/shooting.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

namespace {

float sum(const Rgb &c) { return c.x + c.y + c.z; }

void addBlocks(Shooters &to, const Model &m, const Chart &c, double side) {
    auto parts = [&](float length, int patches) {
        return std::clamp((int)std::lround((double)length / side), 1, patches);
    };
    int columns = parts(c.width, c.patchesAcross), lines = parts(c.height, c.patchesDown);
    for (int j = 0; j < lines; ++j)
        for (int i = 0; i < columns; ++i) {
            std::vector<int> block;
            for (int y = c.patchesDown * j / lines; y < c.patchesDown * (j + 1) / lines; ++y)
                for (int x = c.patchesAcross * i / columns; x < c.patchesAcross * (i + 1) / columns; ++x) {
                    int patch = c.firstPatch + y * c.patchesAcross + x;
                    if (m.patches[patch].area > 0) block.push_back(patch);
                }
            if (!block.empty()) to.push_back(std::move(block));
        }
}

} // namespace

Shooters patchesAlone(const Model &m) {
    Shooters s;
    for (int i = 0; i < m.patchCount; ++i)
        if (m.patches[i].area > 0) s.push_back({i});
    return s;
}

Shooters blocksOfPatches(const Model &m, std::span<const Rgb> emits, int count) {
    double areas[2] = {}; // patches that only reflect; patches that emit
    for (int i = 0; i < m.patchCount; ++i) areas[sum(emits[(size_t)i]) > 0] += (double)m.patches[i].area;
    Shooters s;
    for (int i = 0; i < m.chartCount; ++i) {
        const Chart &c = m.charts[i];
        bool lamp = sum(emits[(size_t)c.firstPatch]) > 0;
        addBlocks(s, m, c, std::max(std::sqrt(areas[lamp] / count), 1e-30));
    }
    return s;
}

Shooting::Shooting(const Model &model, Shooters given, std::vector<Rgb> emits, std::vector<Rgb> direct)
    : model(model), shooters(std::move(given)), direct(std::move(direct)), arrived((size_t)model.patchCount),
      unshot(std::move(emits)), shooterOf((size_t)model.patchCount, -1), power(shooters.size()) {
    for (int s = 0; s < (int)shooters.size(); ++s)
        for (int i : shooters[(size_t)s]) shooterOf[(size_t)i] = s;
    for (int i = 0; i < model.patchCount; ++i) {
        auto k = (size_t)i;
        if (shooterOf[k] < 0) continue;
        unshot[k] += model.patches[i].reflects * this->direct[k];
        initialPower += (double)powerOf(i);
    }
    Workers alone = serialWorkers();
    countPower(alone);
}

float Shooting::powerOf(int i) const { return sum(unshot[(size_t)i]) * model.patches[i].area; }

void Shooting::countPower(Workers &workers) {
    parallelRanges(workers, (int)shooters.size(), 64, [&](int first, int end, int) {
        for (int s = first; s < end; ++s) {
            float all = 0;
            for (int i : shooters[(size_t)s]) all += powerOf(i);
            power[(size_t)s] = all;
        }
    });
    unshotPower = 0;
    for (float p : power) unshotPower += (double)p;
}

std::vector<int> Shooting::brightest(int count) const {
    std::vector<int> all;
    for (int s = 0; s < (int)power.size(); ++s)
        if (power[(size_t)s] > 0) all.push_back(s);
    auto brighter = [&](int a, int b) { return power[(size_t)a] > power[(size_t)b]; };
    auto end = all.begin() + std::min((long)count, (long)all.size());
    std::partial_sort(all.begin(), end, all.end(), brighter);
    all.erase(end, all.end());
    return all;
}

Shooting::Shot Shooting::nextShot(int shooter) {
    // Choose the patch by the golden ratio, which spreads the patches of successive shots
    uint32_t turn = ++shots * 0x9e3779b9u;
    const std::vector<int> &patches = shooters[(size_t)shooter];
    float at = (float)(turn >> 8) * 0x1p-24f * power[(size_t)shooter];
    Shot shot = {patches.back(), {}};
    bool found = false;
    for (int i : patches) {
        at -= powerOf(i);
        if (at < 0 && !found) shot.patch = i, found = true;
        shot.power += unshot[(size_t)i] * model.patches[i].area;
        unshot[(size_t)i] = {};
    }
    unshotPower -= (double)power[(size_t)shooter];
    power[(size_t)shooter] = 0;
    return shot;
}

void Shooting::distribute(std::span<const Shot> shot, const std::vector<std::vector<float>> &rows,
                          Workers &workers) {
    parallelRanges(workers, model.patchCount, 4096, [&](int first, int end, int) {
        for (size_t k = 0; k < shot.size(); ++k)
            for (int j = first; j < end; ++j) {
                float share = rows[k][(size_t)j];
                if (share == 0 || shooterOf[(size_t)j] < 0) continue;
                Rgb light = shot[k].power * (share / model.patches[j].area);
                arrived[(size_t)j] += light;
                unshot[(size_t)j] += model.patches[j].reflects * light;
            }
    });
    countPower(workers);
}

void Shooting::distribute(Rgb radiance, std::span<const Link> column) {
    for (const Link &link : column) {
        auto j = (size_t)link.patch;
        if (shooterOf[j] < 0) continue;
        Rgb light = radiance * link.share, more = model.patches[j].reflects * light;
        arrived[j] += light, unshot[j] += more;
        float gained = sum(more) * model.patches[j].area;
        power[(size_t)shooterOf[j]] += gained;
        unshotPower += (double)gained;
    }
}

// Spreads unshot light evenly over the model, then its reflected share, and so on: a geometric series.
Rgb Shooting::ambient() const {
    Rgb light = {}, reflects = {};
    float area = 0;
    for (const std::vector<int> &patches : shooters)
        for (int i : patches) {
            float a = model.patches[i].area;
            light += unshot[(size_t)i] * a, reflects += model.patches[i].reflects * a, area += a;
        }
    if (area == 0) return {};
    auto series = [&](float x, float r) { return x / area / std::max(1 - r / area, 1e-3f); };
    return {series(light.x, reflects.x), series(light.y, reflects.y), series(light.z, reflects.z)};
}

std::vector<Rgb> Shooting::radiosity() const {
    std::vector<Rgb> all;
    for (size_t i = 0; i < direct.size(); ++i)
        all.push_back(model.patches[i].reflects * (direct[i] + arrived[i]));
    return all;
}

int Shooting::shoot(AnyHemicubes &hemicubes, int most, Workers &workers) {
    std::vector<Shot> sent;
    std::vector<Eye> eyes;
    for (int s : brightest(std::min(most, hemicubes.h.batch))) {
        const Patch &p = model.patches[sent.emplace_back(nextShot(s)).patch];
        eyes.push_back(hemicubeEye(p.p, p.n, shots - 1)); // each is rotated differently
    }
    if (!sent.empty()) distribute(sent, hemicubes.rows(model, eyes, workers), workers);
    return (int)sent.size();
}

} // namespace odraz::radiosity
