#include "tools/radiosity/bake.h"

#include "tools/radiosity/clusters.h"
#include "tools/radiosity/lamps.h"
#include "tools/radiosity/reference.h"
#include "tools/radiosity/regions.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sys/mman.h>

namespace odraz {

const char *const Bake::kSteps[4] = {"dividing", "form factors", "direct light", "solving"};

void Bake::Free::operator()(void *memory) const { munmap(memory, *(size_t *)memory); }

Rgb Bake::reflects(int chart) const {
    const auto &r = materials[(size_t)material[(size_t)chart]].reflects;
    return {r[0], r[1], r[2]};
}
Rgb Bake::emits(int chart) const {
    const auto &e = materials[(size_t)material[(size_t)chart]].emits;
    return {e[0], e[1], e[2]};
}
namespace {

[[noreturn]] void refuseMemory(size_t needed, size_t allowed) {
    throw std::runtime_error("needs about " + std::to_string(needed >> 20) + " MB, more than the " +
                             std::to_string(allowed >> 20) +
                             " of --memory: larger patches or elements need less");
}

// How often cells are divided in adaptive solutions.
constexpr int kDivided = 2;
static_assert(kDivided <= kFinest);

struct Baker {
    Bake &b;
    const Gl &gl;
    Workers &workers;
    const int *stop;
    const Told &told;
    const int never = 0;

    struct Step {
        const Told &told;
        const char *name;
        Progress progress() {
            return {[](float done, void *p) {
                        Step &s = *(Step *)p;
                        if (s.told) s.told(s.name, done, -1);
                    },
                    this};
        }
    };

    template <class T> T *take(size_t count) {
        T *p = b.arena.take<T>(count);
        if (!p) refuseMemory(b.arena.used + count * sizeof(T), b.settings.memory);
        return p;
    }

    // Backs that no ray sees are left out of the hemicubes: that is faster. 64 rays from 500 patches.
    void findSolid() {
        Model &m = *b.model;
        std::vector<Probe> places;
        for (int i = 0; i < m.patchCount; i += std::max(1, m.patchCount / 500))
            if (m.patches[i].share > 0) places.push_back({m.patches[i].chart, m.patches[i].p, {}, false});
        m.solid = !seesBacks(m, *b.scene, places, 8, workers);
    }

    // How many links the rows will have: as many as those of 64 patches or more, spread over the model, and
    // some.
    size_t estimateLinks(Hemicubes &h, const uint8_t *lit, const float *sums) {
        const Model &m = *b.model;
        std::vector<Eye> eyes;
        size_t rows = 0, links = 0, seen = 0;
        for (int i = 0; i < m.patchCount; ++i) rows += lit[i] && m.patches[i].share > 0;
        size_t every = std::max((size_t)1, rows / (size_t)std::max(h.batch, 64));
        for (int i = 0; i < m.patchCount; ++i)
            if (lit[i] && m.patches[i].share > 0 && seen++ % every == 0)
                eyes.push_back(hemicubeEye(m.patches[i].p, m.patches[i].n, (uint32_t)i));
        if (eyes.empty()) return 1;
        std::vector<float> row((size_t)m.patchCount);
        for (size_t first = 0; first < eyes.size(); first += (size_t)h.batch) {
            int count = std::min(h.batch, (int)(eyes.size() - first));
            drawHemicubes(h, m, &eyes[first], count);
            for (int k = 0; k < count; ++k) {
                std::fill(row.begin(), row.end(), 0.f);
                sumHemicube(h, k, sums, row.data());
                for (int i = 0; i < m.patchCount; ++i) links += row[(size_t)i] > 0 && lit[i];
            }
        }
        return links * rows / eyes.size() * (size_t)b.settings.turns * 5 / 4 + 1000;
    }

    void findRows(uint8_t *lit) {
        Hemicubes h;
        Model &m = *b.model;
        if (b.settings.rays) {
            if (!findRowsByRays(m, *b.scene, lit, b.settings.rays, workers, b.arena, b.factors))
                refuseMemory(b.arena.used + b.factors.capacity * sizeof(Link), b.settings.memory);
            b.whole = true;
            return;
        }
        // OpenGL's time grows with the polygons, that of rays hardly
        if (m.facetCount > 1500 && b.settings.hemicube <= 64 && b.settings.turns == 1 && !b.settings.turn) {
            Step s = {told, Bake::kSteps[1]};
            workers.abort = stop;
            b.whole = findRowsByRayHemicubes(m, *b.scene, lit, b.settings.hemicube, workers, b.arena,
                                             b.factors, s.progress());
            workers.abort = &never;
            if (!b.whole && !*stop)
                refuseMemory(b.arena.used + b.factors.capacity * sizeof(Link), b.settings.memory);
            countRows();
            return;
        }
        if (!openHemicubes(h, gl, b.arena, b.settings.hemicube))
            throw std::runtime_error("OpenGL 3.3 draws no integers here: install Mesa (libgl1-mesa-dri)");
        auto *delta = take<float>((size_t)(3 * h.px * h.px));
        auto *sums = take<float>((size_t)(3 * h.px * (h.px + 1)));
        deltaFormFactors(h.px, delta);
        accumulateFormFactors(h.px, delta, sums);
        size_t links = estimateLinks(h, lit, sums),
               rest = (size_t)m.patchCount * (kHemicubeBatch * 4 + 400) + (size_t)m.texelCount * 40;
        size_t needed = b.arena.used + links * sizeof(Link) + rest;
        if (needed > b.settings.memory) {
            closeHemicubes(h);
            refuseMemory(needed, b.settings.memory);
        }
        b.factors.links = take<Link>(links);
        b.factors.capacity = links;
        int step = (int)(m.patchCount * 0.6180339) | 1;
        while (std::gcd(step, m.patchCount) != 1) step += 2;
        Step s = {told, Bake::kSteps[1]};
        workers.abort = stop;
        h.turn = b.settings.turn;
        h.turns = std::min(b.settings.turns, h.batch);
        bool done = findFormFactors(h, m, lit, workers, b.arena, b.factors, s.progress(), step);
        workers.abort = &never;
        closeHemicubes(h);
        if (!done && !*stop)
            throw std::runtime_error("the rows took more memory than estimated: raise --memory");
        b.whole = done;
        countRows();
    }
    void countRows() {
        for (int i = 0; i < b.model->patchCount; ++i) b.rows += b.factors.rows[i].known;
    }

    // Light that patches get and give, and from it what the texels get by reflection.
    void bounce(float *indirect[3]) {
        Model &m = *b.model;
        System &s = b.system;
        size_t columns = kSolveBlock;
        if (!makeSystem(s, b.arena, b.factors, m.patchCount, 3))
            refuseMemory(b.arena.used, b.settings.memory);
        auto *gathered = take<float>((size_t)m.patchCount * columns);
        auto *lamps = take<float>((size_t)m.patchCount * columns);
        for (int i = 0; i < m.patchCount; ++i) {
            Rgb rho = b.reflects(m.patches[i].chart), e = b.emits(m.patches[i].chart);
            for (int c = 0; c < 3; ++c) {
                size_t at = (size_t)i * columns + (size_t)c;
                s.reflectance[at] = component(rho, c);
                if (!b.settings.analytic) lamps[at] = component(e, c);
            }
        }
        if (b.settings.analytic)
            for (int c = 0; c < 3; ++c) meansOfPatches(m, b.direct[c], s.direct + c, (int)columns);
        else
            gather(b.factors, m.patchCount, (int)columns, lamps, s.direct, workers);
        if (b.settings.bounces >= 0) {
            // Bounce by bounce: radiosities from what arrived with the one before
            std::fill(s.radiosity, s.radiosity + (size_t)m.patchCount * columns, 0.f);
            for (int n = 0; n < b.settings.bounces; ++n) {
                if (n > 0) gather(b.factors, m.patchCount, (int)columns, s.radiosity, gathered, workers);
                for (size_t i = 0; i < (size_t)m.patchCount * columns; ++i)
                    s.radiosity[i] = s.reflectance[i] * (s.direct[i] + gathered[i]);
                if (told) told(Bake::kSteps[3], (float)(n + 1) / (float)b.settings.bounces, -1);
            }
            b.sweeps = b.settings.bounces;
        } else {
            struct Context {
                Baker &baker;
                double begin;
            } context = {*this, 0};
            workers.abort = stop;
            b.sweeps =
                solve(s, workers, b.settings.residual, 10000,
                      {[](float residual, void *p) {
                           Context &c = *(Context *)p;
                           c.baker.b.left = residual;
                           double now = std::log(std::max((double)residual, 1e-12));
                           if (c.begin == 0) c.begin = now;
                           double end = std::log((double)c.baker.b.settings.residual);
                           double done = c.begin <= end ? 1 : (c.begin - now) / (c.begin - end);
                           if (c.baker.told)
                               c.baker.told(Bake::kSteps[3], (float)std::clamp(done, 0., 1.), residual);
                       },
                       &context});
            workers.abort = &never;
        }
        gather(b.factors, m.patchCount, (int)columns, s.radiosity, gathered, workers);
        if (!b.settings.analytic)
            for (size_t i = 0; i < (size_t)m.patchCount * columns; ++i) gathered[i] += s.direct[i];
        fillPatches(m, b.factors, (int)columns, gathered, 0, m.patchCount);
        addToTexels(m, gathered, (int)columns, indirect, 3, workers);
    }

    static float component(Rgb c, int k) { return k == 0 ? c.x : k == 1 ? c.y : c.z; }

    void run(const Mesh &mesh) {
        double began = processorSeconds(), last = began;
        auto lap = [&](int step) {
            double now = processorSeconds();
            b.seconds[step] = now - last;
            last = now;
            b.seconds[4] = now - began;
        };
        Model &m = *b.model;
        // Divide
        if (told) told(Bake::kSteps[0], 0, -1);
        double area = areaOf(mesh);
        const BakeSettings &s = b.settings;
        double element = s.element > 0 ? s.element : area / 30000, patch = s.patch;
        double cell = std::sqrt(element) * (s.adaptive ? 1 << kDivided : 1);
        Regions regions = addRegions(mesh, m, cell);
        // What is about as large as an element is one
        for (int i = 0; i < m.chartCount; ++i) {
            Chart &c = m.charts[i];
            if ((double)(c.width * c.height) < 3 * cell * cell) c.across = c.down = 1;
        }
        // A hemicube of many polygons takes longer: then there are fewer of them
        if (!(patch > 0)) patch = area / std::clamp(6000. * 2000 / m.facetCount, 400., 6000.);
        b.material = regions.material;
        b.glows = findLamps(mesh, regions, m, s.lampSamples);
        if (b.glows.empty()) throw ModelError("nothing shines: no material has a Ke above 0");
        if (b.glows.size() > kManyLamps) b.settings.analytic = false;
        Material plain = {};
        b.scene->add(plain);
        poseFacets(m, *b.scene);
        b.scene->finish();
        if (told) told(Bake::kSteps[0], 0.5f, -1);
        int block = (int)std::clamp(std::sqrt(patch) / cell + 0.5, 1., 1000.);
        if (!m.divide(*b.scene, b.arena, workers, block, s.adaptive ? kDivided : 0)) {
            size_t each = sizeof(Texel) + sizeof(Cell) + 8 * sizeof(Tie) + 16;
            refuseMemory(b.arena.used + (size_t)m.texelRoom * each, s.memory);
        }
        findSolid();
        Clusters clusters(
            m, patch, [&](int chart) { return maxComponent(b.reflects(chart)) > 0; }, b.arena);
        if (told) told(Bake::kSteps[0], 1, -1);
        lap(0);

        // Form factors; lamps too where hemicubes are to see them
        auto *lit = take<uint8_t>((size_t)m.patchCount);
        for (int i = 0; i < m.patchCount; ++i) {
            int chart = m.patches[i].chart;
            lit[i] = maxComponent(b.reflects(chart)) > 0 || (!s.analytic && maxComponent(b.emits(chart)) > 0);
        }
        findRows(lit);
        lap(1);

        // Direct light
        size_t texels = (size_t)m.texelRoom + 8;
        float *indirect[3];
        for (int c = 0; c < 3; ++c) {
            b.direct[c] = take<float>(texels);
            b.light[c] = take<float>(texels);
            indirect[c] = take<float>(texels);
        }
        Lights lights = {};
        lights.skyCount = 3;
        lights.glows = b.glows.data();
        lights.glowCount = (int)b.glows.size();
        Step step = {told, Bake::kSteps[2]};
        auto look = [&](const Progress &progress) {
            if (s.analytic) findDirectLight(m, *b.scene, lights, workers, b.direct, progress);
            settleFresh(m);
        };
        look(step.progress());
        Measure measures[3];
        int count = 0;
        for (int c = 0; c < 3 && s.adaptive && s.analytic; ++c)
            count += measure(m, b.direct[c], s.contrast, measures[count]);
        for (int level = 0; level < (s.adaptive ? kDivided : 0); ++level) {
            refine(m, level, measures, count, s.contrast);
            findVisible(m, *b.scene, workers);
            look({});
        }
        tie(m);
        lap(2);

        bounce(indirect);
        clusters.smooth(m, b.factors, indirect);
        for (int c = 0; c < 3; ++c) {
            for (int i = 0; i < m.texelCount; ++i) b.light[c][i] = b.direct[c][i] + indirect[c][i];
            settle(m, b.light[c]);
        }
        lap(3);
        if (told) told(nullptr, 1, b.left);
    }
};

} // namespace

std::unique_ptr<Bake> bake(const Mesh &mesh, const BakeSettings &settings, const Gl &gl, Workers &workers,
                           const int *stop, const Told &told) {
    auto b = std::make_unique<Bake>();
    b->settings = settings;
    b->materials = mesh.materials;
    size_t bytes = ((settings.memory + 4095) & ~(size_t)4095) + 4096;
    void *memory =
        mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED) throw std::runtime_error("there is not so much memory: lower --memory");
    *(size_t *)memory = bytes;
    b->memory.reset(memory);
    b->arena = {(unsigned char *)memory, settings.memory, 64};
    b->model = std::make_unique<Model>();
    b->scene = std::make_unique<Scene>();
    const int *watched = workers.abort;
    Baker baker = {*b, gl, workers, stop, told};
    workers.abort = &baker.never;
    try {
        baker.run(mesh);
    } catch (...) {
        workers.abort = watched;
        throw;
    }
    workers.abort = watched;
    return b;
}

} // namespace odraz
