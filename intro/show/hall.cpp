#include "show/hall.h"

#include "base/maths.h"
#include "show/hall_model.h"
#include "show/materials.h"

#include <initializer_list>

namespace odraz {

namespace {

// {sun's angle from the windows' normal towards the entrance, its height, sunlight, sky: low, high, glow};
// degrees
struct Hour {
    float aside, height;
    Rgb sunlight, low, high, glow;
};
constexpr Hour kDay[kHours] = {
    {62, 9, {2.4f, 1.3f, 0.65f}, {0.38f, 0.21f, 0.16f}, {0.06f, 0.09f, 0.22f}, {0.8f, 0.42f, 0.18f}},
    {44, 24, {3.7f, 3.0f, 2.2f}, {0.30f, 0.36f, 0.44f}, {0.06f, 0.14f, 0.38f}, {0.4f, 0.32f, 0.22f}},
    {22, 38, {4.1f, 3.7f, 3.1f}, {0.25f, 0.36f, 0.52f}, {0.06f, 0.15f, 0.42f}, {0.3f, 0.28f, 0.24f}},
    {0, 45, {4.2f, 3.8f, 3.2f}, {0.24f, 0.36f, 0.54f}, {0.06f, 0.15f, 0.42f}, {0.3f, 0.28f, 0.24f}},
    {-24, 36, {4.1f, 3.6f, 2.9f}, {0.26f, 0.36f, 0.50f}, {0.06f, 0.14f, 0.40f}, {0.3f, 0.26f, 0.22f}},
    {-44, 20, {3.7f, 2.6f, 1.5f}, {0.28f, 0.24f, 0.25f}, {0.06f, 0.10f, 0.28f}, {0.6f, 0.38f, 0.2f}},
    {-60, 7, {2.6f, 1.2f, 0.5f}, {0.36f, 0.15f, 0.09f}, {0.05f, 0.06f, 0.17f}, {0.9f, 0.38f, 0.13f}},
    {-62, 1, {}, {0.03f, 0.04f, 0.075f}, {0.01f, 0.018f, 0.045f}, {}},
};

Hour between(const Hour &a, const Hour &b, float t) {
    return {lerp(a.aside, b.aside, t), lerp(a.height, b.height, t), lerp(a.sunlight, b.sunlight, t),
            lerp(a.low, b.low, t),     lerp(a.high, b.high, t),     lerp(a.glow, b.glow, t)};
}

constexpr Rgb kLanternLight = Rgb{60, 45, 30}, kStripLight = Rgb{1.7f, 1.85f, 2.1f};

// From one grey for all to the material.
Material faded(Material m, float grey) {
    if (grey == 0) return m;
    Rgb plain = {0.6f, 0.6f, 0.6f};
    m.diffuse = lerp(m.diffuse, 1.f, grey);
    for (Texture *t : {&m.texture, &m.other})
        for (Rgb &c : t->palette) c = lerp(c, plain, grey);
    m.tint *= Rgb{1, 1, 1} * (1 - grey); // of what it mirrors
    m.specular *= 1 - grey;
    return m;
}

// In the order of HallPart.
void addMaterials(Scene &scene, const HallLight &light, float grey) {
    for (const Material &m : {hallFloor(), plaster({0.76f, 0.73f, 0.68f}), plaster({0.62f, 0.33f, 0.19f}),
                              limestone(), granite(), beamAcross(), beamAlong(), granite()})
        scene.add(faded(m, grey));
    for (float on : light.lanterns) scene.add(lamp(kLanternLight * on + Rgb{0.01f, 0.01f, 0.01f}));
    for (float on : light.strips) scene.add(lamp(kStripLight * on + Rgb{0.01f, 0.01f, 0.01f}));
}

// The light of scene 4, bounce by bounce, and what its patch sees.
bool followBounces(Hall &hall, Scene &scene, Arena &arena, Workers &workers) {
    const Radiosity &r = hall.radiosity;
    LightVector noon = lightVector({kNoon, {}, {}, 0});
    size_t patches = (size_t)hall.model.patchCount, columns = (size_t)r.system.columns;
    float *radiosity = arena.take<float>(patches * kSolveBlock),
          *gathered = arena.take<float>(patches * kSolveBlock);
    if (!radiosity || !gathered) return false;
    for (int b = 0; b <= kBounces; ++b) {
        if (!(hall.bounce[b] = arena.take<Rgb>(patches))) return false;
        if (b > 0) gather(r.factors, hall.model.patchCount, kSolveBlock, radiosity, gathered, workers);
        for (size_t i = 0; i < patches; ++i) {
            Rgb light = {};
            for (int k = 0; k < kFirstLantern; ++k)
                light += noon.bounced[k] * r.system.direct[i * columns + 3 * (size_t)k];
            const float *in = gathered + i * kSolveBlock;
            light += Rgb{in[0], in[1], in[2]};
            hall.bounce[b][i] = light;
            Rgb out = light * scene.mean[hall.model.charts[hall.model.patches[i].chart].material];
            float *to = radiosity + i * kSolveBlock;
            to[0] = out.x, to[1] = out.y, to[2] = out.z;
        }
    }
    return true;
}

// Finds a patch of the floor in the nave, and keeps what it sees.
bool visit(Hall &hall, const Gl &gl, Arena &arena) {
    const Model &m = hall.model;
    float least = kInfinity;
    for (int i = 0; i < m.patchCount; ++i) {
        float distance = length(m.patches[i].p - Vec3{0.5f, 0, 0.6f});
        if (distance >= least) continue;
        least = distance;
        hall.visited = i;
    }
    Hemicubes h;
    hall.seen = arena.take<uint32_t>((size_t)(3 * kSeen * kSeen));
    if (!hall.seen || !openHemicubes(h, gl, arena, kSeen)) return false;
    Eye eye = {m.patches[hall.visited].p, {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
    drawHemicubes(h, m, &eye, 1);
    for (int i = 0; i < 3 * kSeen * kSeen; ++i)
        hall.seen[i] = hemicubeIds(h, 0)[i / kSeen * hemicubeStride(h) + i % kSeen];
    closeHemicubes(h);
    return true;
}

} // namespace

Daylight daylightAt(float hour) {
    int before = min(max((int)hour, 0), kHours - 2);
    Hour h = between(kDay[before], kDay[before + 1], hour - (float)before);
    float a = h.aside * (kPi / 180), e = h.height * (kPi / 180);
    Vec3 sun = {-cos(e) * cos(a), sin(e), cos(e) * sin(a)};
    Rgb ground = h.low * 0.35f + h.sunlight * (0.07f * max(sun.y, 0.f));
    return {{h.low, (h.high - ground) * 0.5f, (h.high + ground) * 0.5f - h.low, -1, sun, h.glow * 0.25f,
             h.glow, h.low * 0.8f + h.sunlight * 0.11f, 0.1f, hour * 0.7f},
            sun * 300.f,
            h.sunlight + h.glow * kNearGlow};
}

LightVector lightVector(const HallLight &light, const float *drawn) {
    LightVector v = {};
    Daylight now = daylightAt(light.hour);
    now.sky.near = {}; // it is part of the sun
    project(now.sky, v.bounced);
    // The sun's bounce, between two positions; its light, where the tracer does not draw it
    float at = clamp(light.hour * 4, 0.f, (float)(kSuns - 1));
    int before = min((int)at, kSuns - 2);
    for (int i = 0; i < 2; ++i) {
        Rgb part = now.sunlight * (i ? at - (float)before : (float)(before + 1) - at);
        v.bounced[kSh + before + i] = part;
        v.direct[kSh + before + i] = part * (1 - light.sun);
    }
    for (int i = 0; i < kLanterns; ++i) {
        v.bounced[kFirstLantern + i] = kLanternLight * light.lanterns[i];
        v.direct[kFirstLantern + i] = v.bounced[kFirstLantern + i] * (1 - (drawn ? drawn[i] : 0));
    }
    for (int i = 0; i < kStrips; ++i)
        v.bounced[kFirstStrip + i] = v.direct[kFirstStrip + i] = kStripLight * light.strips[i];
    return v;
}

size_t hallBytes() { return (size_t)224 << 20; }

void prepareHall(Hall &hall, Scene &scene) {
    Lights &lights = hall.radiosity.lights;
    lights.skyCount = kSh;
    lights.sky = [](const void *, const Vec3x8 &d, Float8 *y) { evaluate(d, y); };
    lights.sunCount = kSuns;
    for (int i = 0; i < kSuns; ++i) lights.suns[i] = daylightAt((float)i * 0.25f).sunAt;
    buildHall(hall.model, lights);
    scene.clear();
    addMaterials(scene, {}, 0);
    hall.model.pose(scene);
    scene.finish();
}

bool polish(Hall &hall, const GlossySettings &settings, Arena &arena, Workers &workers) {
    // How much there is of each basis in the course of a day
    float importance[kMaxBases] = {};
    for (int hour = 0; hour < kHours; ++hour) {
        LightVector v = lightVector({(float)hour, {1, 1, 1}, {1, 1, 1, 1, 1, 1, 1, 1}, 1});
        for (int k = 0; k < kFirstStrip + kStrips; ++k) importance[k] += length(v.bounced[k]);
    }
    for (int i = 0; i < kSuns; ++i) importance[kSh + i] = 1;
    return findGlossy(hall.floor, hall.model, hall.radiosity, 0, importance, settings, arena, workers);
}

const char *loadHall(Hall &hall, Scene &scene, const Gl &gl, Arena &arena, Workers &workers,
                     const Progress &progress) {
    prepareHall(hall, scene);
    if (!solveRadiosity(hall.radiosity, hall.model, scene, kHallSettings, gl, arena, workers, progress) ||
        !polish(hall, {}, arena, workers) || !followBounces(hall, scene, arena, workers) ||
        !visit(hall, gl, arena))
        return "the hall cannot be solved: OpenGL 3.3 draws no integers here, or memory is short";
    closeHemicubes(hall.radiosity.hemicubes);
    for (int i = 0; i < scene.materialCount; ++i) hall.mean[i] = scene.mean[i];
    for (int k = 0; k < 3; ++k) {
        hall.light[k] = arena.take<float>((size_t)hall.model.texelCount + 8);
        hall.mosaic[k] = arena.take<float>((size_t)hall.model.patchCount);
        if (!hall.light[k] || !hall.mosaic[k]) return "not enough memory";
        hall.map.plane[k] = hall.light[k];
        hall.map.patch[k] = hall.mosaic[k];
        hall.map.gloss[k] = hall.floor.plane[k];
    }
    hall.map.charts = hall.model.charts;
    hall.map.glossy = hall.floor.chart;
    hall.map.glossAcross = hall.floor.across;
    hall.map.glossDown = hall.floor.down;
    hall.map.cells = hall.model.cells;
    return nullptr;
}

void poseHall(Hall &hall, const HallLight &light, float grey, Scene &scene) {
    addMaterials(scene, light, grey);
    hall.model.pose(scene);
    scene.lightmap = &hall.map;
    hall.map.mosaic = 0;

    Daylight now = daylightAt(light.hour);
    scene.sky = now.sky;
    if (light.sun > 0)
        scene.add(pointLight(now.sunAt, now.sunlight * (light.sun * dot(now.sunAt, now.sunAt))));

    // The two strongest lanterns are drawn by the tracer, but for what lets one take another's place unseen:
    // the third's share
    float least = min(light.lanterns[0], min(light.lanterns[1], light.lanterns[2])), drawn[kLanterns] = {};
    for (int i = 0; i < kLanterns; ++i) {
        float on = light.lanterns[i];
        if (on == 0) continue;
        drawn[i] = saturate((on - least) / (0.15f * on));
        Vec3 place = hall.radiosity.lights.lamps[i].centre;
        scene.add(sphere(place, kLanternRadius, kLantern + i));
        if (drawn[i] > 0)
            scene.add(pointLight(place, kLanternLight * (on * drawn[i] * kLanternRadius * kLanternRadius)));
    }
    LightVector vector = lightVector(light, drawn);
    relight(hall.radiosity, hall.model, vector, hall.light);
    relightGlossy(hall.floor, vector, scene.eye, 0.06f, 0.5f * (1 - grey));

    // Balls get what floor and ceiling get on average
    auto mean = [&](int chart) {
        const Chart &c = hall.model.charts[chart];
        float sum[3] = {};
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < c.texels(); ++i) sum[k] += hall.light[k][c.firstTexel + i];
        float all = 1.f / (float)c.texels();
        return Rgb{sum[0] * all, sum[1] * all, sum[2] * all};
    };
    scene.ambientHigh = mean(0);
    scene.contact = true;
    scene.ambientLow = mean(3);
    scene.exposure = 1;
}

} // namespace odraz
