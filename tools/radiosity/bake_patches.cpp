// A model, solved between patches, by the stages that light the film's hall.
#include "tools/radiosity/bake.h"

#include "tools/common/machine.h"
#include "tools/radiosity/lamps.h"
#include "tools/radiosity/light_grid.h"
#include "tools/radiosity/patch_rows.h"
#include "tools/radiosity/sees_backs.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <sys/mman.h>

namespace odraz {

namespace {

constexpr int kSkyRays = 1024; // of each texel

// Goes through the stages. Finding form factors and solving may be cut short; all else is done to its end,
// whatever happens.
class Baker {
public:
    Baker(Bake &b, const Mesh &mesh, const Gl &gl, Workers &workers, const int *stop, const Told &told)
        : b(b), m(*b.model), r(b.radiosity), s(b.settings), mesh(mesh), gl(gl), workers(workers), stop(stop),
          told(told), watched(workers.abort) {
        workers.abort = &kNever;
    }
    Baker(const Baker &) = delete;
    ~Baker() { workers.abort = watched; }

    void run() {
        double began = processorSeconds(), last = began;
        auto lap = [&](int step) {
            double now = processorSeconds();
            b.seconds[step] = now - last;
            last = now;
            b.seconds[4] = now - began;
        };
        divide();
        lap(0);
        RadiositySettings settings;
        settings.levels = s.adaptive ? kDivided : 0;
        settings.contrast = s.contrast;
        takePlanes();
        findDirect(r, m, *b.scene, settings, workers, tell(2));
        std::vector<std::string> known; // notes
        if (s.adaptive) findPictured(known);
        gatherFromOutside();
        if (s.growing) s.growing(b, nullptr);
        lap(2);
        findPatchRows(b, gl, workers, stop, told);
        lap(1);
        solveBounces();
        lap(3);
        if (told) told(nullptr, 1, b.left);
    }

private:
    Bake &b;
    Model &m;
    Radiosity &r;
    BakeSettings &s;
    const Mesh &mesh;
    const Gl &gl;
    Workers &workers;
    const int *stop;
    const Told &told;
    const int *watched;
    double patch = 0; // its area
    const char *step = nullptr;
    SolvedShare share;

    Progress tell(int which) {
        step = Bake::kSteps[which];
        return {[](float done, void *p) {
                    Baker &k = *(Baker *)p;
                    if (k.told) k.told(k.step, done, -1);
                },
                this};
    }

    void divide() {
        Progress progress = tell(0);
        progress(0);
        fillModel(m, b.regions);
        double area = areaOf(mesh), cell = cellOf(mesh, s);
        // A hemicube of many polygons takes longer: then there are fewer of them
        patch = s.patch > 0 ? s.patch : area / std::clamp(6000. * 2000 / m.facetCount, 400., 6000.);
        findGlows(b.regions);
        b.scene->add(Material{});
        poseFacets(m, *b.scene);
        b.scene->finish();
        progress(0.5f);
        int block = (int)std::clamp(std::sqrt(patch) / cell + 0.5, 1., (double)kMaxAcross),
            levels = s.adaptive ? kDivided : 0;
        refuseTooMany(levels);
        if (!m.divide(*b.scene, b.arena, workers, block, levels))
            refuseMemory(b.arena, texelBytes((size_t)m.texelRoom));
        m.solid = !seesBacks(m, mesh);
        findPictured(b.notes);
        for (int i = 0; i < m.patchCount; ++i) m.patches[i].reflects = b.reflects(m.patches[i].chart);
        b.pictured.toPatches(m);
        progress(1);
    }

    void findPictured(std::vector<std::string> &notes) {
        b.pictured.find(mesh, b.regions.chartOf, {m.charts, (size_t)m.chartCount},
                        {m.cells, (size_t)m.cellCount}, notes);
    }

    // What shines: seen from the texels or, where that is too much, by hemicubes.
    void findGlows(const Regions &regions) {
        b.glows = findLamps(mesh, regions, m, s.lampSamples);
        Surroundings &around = s.surroundings;
        if (b.glows.size() > kManyLamps) s.analytic = false;
        r.lights.skyCount = 3;
        // Suns and lamps are bases of their own until their light has arrived
        Vec3 middle = toFloat(mesh.middle());
        float far = (float)(1000 * mesh.size());
        for (const Sun &sun : around.suns) r.lights.suns[r.lights.sunCount++] = middle + sun.towards * far;
        for (const BallLamp &lamp : around.lamps)
            r.lights.lamps[r.lights.lampCount++] = {lamp.centre, lamp.radius, -1};
        if (!s.analytic) return;
        r.lights.glows = b.glows.data();
        r.lights.glowCount = (int)b.glows.size();
    }

    // Puts the light of suns and lamps, and then of the sky, to what glows gave.
    void gatherFromOutside() {
        Surroundings &around = s.surroundings;
        auto fold = [&](int basis, const Rgb &light) {
            const float share[3] = {light.x, light.y, light.z};
            for (int k = 0; k < 3; ++k)
                for (int t = 0; t < m.texelCount; ++t) r.direct[k][t] += share[k] * r.direct[basis][t];
        };
        for (size_t i = 0; i < around.suns.size(); ++i) fold(3 + (int)i, around.suns[i].light);
        for (size_t i = 0; i < around.lamps.size(); ++i)
            fold(r.lights.firstLamp() + (int)i, around.lamps[i].radiance);
        r.lights.sunCount = r.lights.lampCount = 0;
        if (around.sky.width) addSky(m, *b.scene, around.sky, kSkyRays, workers, r.direct);
    }

    static size_t texelBytes(size_t texels) {
        return texels * (sizeof(Texel) + sizeof(Cell) + 6 * sizeof(Tie) + 16);
    }

    // Before they are counted in ints. Whole patches may make them half as many, or half more.
    void refuseTooMany(int levels) {
        double texels = 0;
        for (int i = 0; i < m.chartCount; ++i) texels += m.charts[i].texels();
        texels *= (4 << 2 * levels) / 3;
        size_t least = texelBytes((size_t)(texels / 2));
        if (least > s.memory) refuseMemory(b.arena, least);
        if (texels * 1.5 > INT_MAX)
            throw std::runtime_error("there are too many elements to count: ask for larger ones");
    }

    void takePlanes() {
        size_t texels = (size_t)m.texelRoom + 8;
        for (int k = 3; k < r.lights.bases(); ++k) r.direct[k] = takeOrRefuse<float>(b.arena, texels);
        for (int k = 0; k < 3; ++k) {
            r.direct[k] = takeOrRefuse<float>(b.arena, texels);
            b.light[k] = takeOrRefuse<float>(b.arena, texels);
            float *unused = takeOrRefuse<float>(b.arena, texels);
            for (int c = 0; c < 3; ++c) r.bounced[k][c] = k == c ? b.light[k] : unused;
        }
    }

    // Light that patches get and give, and from it what the texels get by reflection.
    void solveBounces() {
        System &system = r.system;
        if (!fillSystem(r, m, b.arena, workers))
            refuseMemory(b.arena, (size_t)m.patchCount * kSolveBlock * 4 * sizeof(float));
        // Red light has no green
        size_t columns = (size_t)system.columns, all = (size_t)m.patchCount * columns;
        for (size_t i = 0; i < (size_t)m.patchCount; ++i)
            for (size_t k = 0; k < 9; ++k)
                if (k % 4) system.reflectance[i * columns + k] = 0;
        auto *seen = s.analytic ? nullptr : takeOrRefuse<float>(b.arena, all); // of lamps, by hemicubes
        if (seen) {
            auto *lamps = takeOrRefuse<float>(b.arena, all);
            for (int i = 0; i < m.patchCount; ++i) {
                Rgb e = b.emits(m.patches[i].chart);
                float *to = lamps + (size_t)i * columns;
                to[0] = e.x, to[4] = e.y, to[8] = e.z;
            }
            gather(r.factors, m.patchCount, system.columns, lamps, seen, workers);
            for (size_t i = 0; i < all; ++i) system.direct[i] += seen[i];
        }
        if (s.bounces < 0) solveToResidual();
        for (Progress progress = tell(3); b.sweeps < s.bounces;
             progress((float)b.sweeps / (float)s.bounces)) {
            bounce(system, workers);
            ++b.sweeps;
            if (s.growing) s.growing(b, system.radiosity);
        }
        gather(system, workers);
        for (size_t i = 0; seen && i < all; ++i) system.gathered[i] += seen[i];
        spreadLight(r, m, workers);
        settleLight(r, m, workers);
    }

    void solveToResidual() {
        b.left = kInfinity; // it may be stopped before the first sweep
        workers.abort = stop;
        b.sweeps = solve(r.system, workers, s.residual, 10000,
                         {[](float residual, void *p) {
                              Baker &k = *(Baker *)p;
                              k.b.left = residual;
                              if (k.told) k.told(Bake::kSteps[3], k.share(residual, k.s.residual), residual);
                              // Of one block: its values are kept in what is gathered
                              if (k.s.growing) k.s.growing(k.b, k.r.system.gathered);
                          },
                          this});
        workers.abort = &kNever;
        if (!b.whole || b.left <= s.residual || !__atomic_load_n(stop, __ATOMIC_RELAXED)) return;
        b.whole = false;
        keepPatchRows(b);
    }
};

} // namespace

void bakeByPatches(Bake &b, const Mesh &mesh, const Gl &gl, Workers &workers, const int *stop,
                   const Told &told) {
    size_t bytes = ((b.settings.memory + 4095) & ~(size_t)4095) + 4096;
    void *memory =
        mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED) throw std::runtime_error("there is not so much memory: lower --memory");
    *(size_t *)memory = bytes;
    b.memory.reset(memory);
    b.arena = {(unsigned char *)memory, b.settings.memory, 64};
    b.model = std::make_unique<Model>();
    b.scene = std::make_unique<Scene>();
    Baker(b, mesh, gl, workers, stop, told).run();
}

} // namespace odraz
