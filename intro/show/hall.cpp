#include "show/hall.h"

#include "base/maths.h"
#include "show/materials.h"

#include <initializer_list>

namespace odraz {

namespace {

enum Part {
    kFloor,
    kPlaster,
    kWarm,
    kShaft,
    kBlock,
    kBeamX,
    kBeamZ,
    kStep,
    kLantern,
    kStrip = kLantern + kLanterns
};

constexpr float kX = 4.5f, kY = 6.5f, kZ = 9; // half width, height, half length
constexpr float kSill = 1.75f, kLintel = 5.25f, kWindow = 0.625f, kDeep = 0.5f;
constexpr float kDoor = 1.75f, kDoorHeight = 3; // half width
constexpr float kWindows[] = {-6.5f, -3.25f, 0, 3.25f, 6.5f};
constexpr float kColumnX = 2.25f, kColumns[] = {-4.875f, -1.625f, 1.625f, 4.875f};
constexpr float kLanternY = 4.0f, kLanternZ[kLanterns] = {-3.25f, 0, 3.25f}, kLanternRadius = 0.15f;

void addColumn(Model &m, float x, float z) {
    m.addBox({x - 0.42f, 0, z - 0.42f}, {x + 0.42f, 0.32f, z + 0.42f}, kBlock, 0.14f,
             Model::kUpright | Model::kTop);
    constexpr float kLow = 0.32f, kHigh = 5.15f, kRadius = 0.32f;
    for (int k = 0; k < 8; ++k) {
        auto corner = [&](int i) {
            float a = ((float)i + 0.5f) * (kPi / 4);
            return Vec3{x + kRadius * cos(a), kLow, z - kRadius * sin(a)};
        };
        Vec3 a = corner(k), b = corner(k + 1);
        m.addRect(a, b - a, {0, kHigh - kLow, 0}, kShaft, 0.22f);
    }
    m.addBox({x - 0.38f, kHigh, z - 0.38f}, {x + 0.38f, 5.45f, z + 0.38f}, kBlock, 0.14f,
             Model::kUpright | Model::kBottom | Model::kTop);
}

void addStair(Model &m) {
    constexpr float kLeft = 2.9f, kRise = 0.2f, kTread = 0.34f, kStart = -3.4f;
    constexpr int kSteps = 8;
    for (int i = 0; i < kSteps; ++i) {
        float z0 = kStart - kTread * (float)i, z1 = i + 1 < kSteps ? z0 - kTread : -kZ;
        Vec3 hi = {kX, kRise * (float)(i + 1), z0};
        m.addBox({kLeft, hi.y - kRise, z1}, hi, kStep, 0.18f, Model::kFront | Model::kTop);
        m.addBox({kLeft, 0, z1}, hi, kStep, 0.18f, Model::kLeft);
    }
}

void build(Model &m) {
    Vec3 x = {2 * kX, 0, 0}, y = {0, kY, 0}, z = {0, 0, 2 * kZ};
    m.addRect({-kX, 0, -kZ}, z, x, kFloor, 0.2f);
    m.addRect({-kX, kY, -kZ}, x, z, kBeamX, 0.3f);
    m.addRect({kX, 0, -kZ}, z, y, kWarm, 0.25f);
    // The wall with the entrance
    int front = m.addRect({kX, 0, kZ}, -x, y, kPlaster, 0.25f, Model::kPieces);
    m.addFacet(front, 0, 0, kX - kDoor, kY);
    m.addFacet(front, kX + kDoor, 0, 2 * kX, kY);
    m.addFacet(front, kX - kDoor, kDoorHeight, kX + kDoor, kY);
    m.addRect({kDoor, 0, kZ}, {-2 * kDoor, 0, 0}, {0, kDoorHeight, 0}, kPlaster, 0.7f, Model::kOpen);
    m.addRect({-kX, 0, -kZ}, x, y, kPlaster, 0.25f);
    // The wall with the windows, in pieces, and their depth
    int wall = m.addRect({-kX, 0, kZ}, -z, y, kPlaster, 0.2f, Model::kPieces);
    m.addFacet(wall, 0, 0, 2 * kZ, kSill);
    m.addFacet(wall, 0, kLintel, 2 * kZ, kY);
    float from = kZ;
    for (int i = 4; i >= -1; --i) {
        float to = i < 0 ? -kZ : kWindows[i] + kWindow;
        m.addFacet(wall, kZ - from, kSill, kZ - to, kLintel);
        if (i < 0) break;
        from = kWindows[i] - kWindow;
        Vec3 lo = {-kX - kDeep, kSill, from}, deep = {kDeep, 0, 0}, tall = {0, kLintel - kSill, 0};
        Vec3 wide = {0, 0, 2 * kWindow};
        m.addRect(lo, wide, deep, kPlaster, 0.15f);        // sill
        m.addRect(lo + tall, deep, wide, kPlaster, 0.15f); // lintel
        m.addRect(lo, deep, tall, kPlaster, 0.15f);        // jambs
        m.addRect(lo + wide + deep, -deep, tall, kPlaster, 0.15f);
        m.addRect(lo + wide, -wide, tall, kPlaster, 0.5f, Model::kOpen);
    }
    for (int side = -1; side <= 1; side += 2) {
        float cx = kColumnX * (float)side;
        for (float cz : kColumns) addColumn(m, cx, cz);
        m.addBox({cx - 0.2f, 5.45f, -kZ}, {cx + 0.2f, 5.85f, kZ}, kBeamZ, 0.3f,
                 Model::kLeft | Model::kRight | Model::kBottom | Model::kTop);
    }
    for (float cz : kColumns)
        m.addBox({-kX, 5.85f, cz - 0.15f}, {kX, kY, cz + 0.15f}, kBeamX, 0.3f,
                 Model::kFront | Model::kBack | Model::kBottom);
    addStair(m);
}

void addLamps(Model &m, Lights &lights) {
    for (float cz : kLanternZ) lights.lamps[lights.lampCount++] = {{0, kLanternY, cz}, kLanternRadius, -1};
    for (int i = 0; i < kStrips; ++i) {
        Vec3 corner = {((float)i - 3.5f) * 0.4f - 0.14f, 0.3f, 0.004f - kZ};
        int chart = m.addRect(corner, {0.28f, 0, 0}, {0, 3.9f, 0}, kStrip + i, 0.5f);
        lights.lamps[lights.lampCount++] = {{}, 0, chart};
    }
}

// {sun's angle from the windows' normal towards the entrance, its height, sunlight, sky: low, high, glow};
// degrees
struct Hour {
    float aside, height;
    Rgb sunlight, low, high, glow;
};
constexpr Hour kDay[kHours] = {
    {62, 9, {2.4f, 1.3f, 0.65f}, {0.75f, 0.56f, 0.48f}, {0.2f, 0.28f, 0.52f}, {0.8f, 0.45f, 0.2f}},
    {44, 24, {3.8f, 3.0f, 2.1f}, {0.95f, 1.0f, 1.1f}, {0.3f, 0.52f, 1.0f}, {0.7f, 0.6f, 0.4f}},
    {22, 38, {4.2f, 3.8f, 3.1f}, {1.1f, 1.22f, 1.35f}, {0.36f, 0.64f, 1.25f}, {0.6f, 0.55f, 0.5f}},
    {0, 45, {4.3f, 3.9f, 3.3f}, {1.15f, 1.3f, 1.45f}, {0.38f, 0.66f, 1.3f}, {0.6f, 0.55f, 0.5f}},
    {-24, 36, {4.2f, 3.7f, 2.9f}, {1.1f, 1.2f, 1.3f}, {0.36f, 0.63f, 1.2f}, {0.6f, 0.5f, 0.45f}},
    {-44, 20, {3.8f, 2.6f, 1.5f}, {1.0f, 0.88f, 0.8f}, {0.28f, 0.45f, 0.9f}, {0.9f, 0.6f, 0.35f}},
    {-60, 7, {2.6f, 1.2f, 0.5f}, {0.75f, 0.42f, 0.29f}, {0.17f, 0.19f, 0.4f}, {1.1f, 0.45f, 0.16f}},
    {-62, 1, {}, {0.03f, 0.04f, 0.075f}, {0.01f, 0.018f, 0.045f}, {}},
};

SkyKey keyOf(const Hour &h) {
    float a = h.aside * (kPi / 180), e = h.height * (kPi / 180);
    Vec3 sun = {-cos(e) * cos(a), sin(e), cos(e) * sin(a)};
    return {{h.low, h.high, h.low * 0.35f + h.sunlight * (0.07f * max(sun.y, 0.f)), sun, h.glow},
            sun * 3000.f,
            h.sunlight};
}

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

// In the order of Part.
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
    size_t patches = (size_t)hall.model.patchCount, columns = (size_t)r.system.columns;
    float *radiosity = arena.take<float>(patches * kSolveBlock),
          *gathered = arena.take<float>(patches * kSolveBlock);
    if (!radiosity || !gathered) return false;
    for (int b = 0; b <= kBounces; ++b) {
        if (!(hall.bounce[b] = arena.take<Rgb>(patches))) return false;
        for (size_t i = 0; i < patches; ++i) {
            const float *direct = r.system.direct + i * columns + 3 * kNoon;
            Rgb light = {direct[0], direct[1], direct[2]};
            if (b > 0)
                light += Rgb{gathered[i * kSolveBlock], gathered[i * kSolveBlock + 1],
                             gathered[i * kSolveBlock + 2]};
            hall.bounce[b][i] = light;
            Rgb out = light * scene.mean[hall.model.charts[hall.model.patches[i].chart].material];
            radiosity[i * kSolveBlock] = out.x, radiosity[i * kSolveBlock + 1] = out.y,
                          radiosity[i * kSolveBlock + 2] = out.z;
        }
        gather(r.factors, hall.model.patchCount, kSolveBlock, radiosity, gathered, workers);
    }
    return true;
}

// Finds a patch of the floor in the nave, and keeps what it sees.
void visit(Hall &hall, Arena &arena) {
    const Model &m = hall.model;
    float least = kInfinity;
    for (int i = 0; i < m.patchCount; ++i) {
        float distance = length(m.patches[i].p - Vec3{0.5f, 0, 0.6f});
        if (distance >= least) continue;
        least = distance;
        hall.visited = i;
    }
    Hemicubes &h = hall.radiosity.hemicubes;
    Eye eye = {m.patches[hall.visited].p, {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
    drawHemicubes(h, m, &eye, 1);
    hall.seen = arena.take<uint32_t>((size_t)(3 * h.px * h.px));
    for (int i = 0; hall.seen && i < 3 * h.px * h.px; ++i)
        hall.seen[i] = hemicubeIds(h, 0)[i / h.px * hemicubeStride(h) + i % h.px];
}

} // namespace

size_t hallBytes() { return (size_t)160 << 20; }

const char *loadHall(Hall &hall, Scene &scene, const Gl &gl, Arena &arena, Workers &workers,
                     const Progress &progress) {
    Lights &lights = hall.radiosity.lights;
    lights.skyCount = kHours;
    for (int i = 0; i < kHours; ++i) lights.skies[i] = keyOf(kDay[i]);
    build(hall.model);
    addLamps(hall.model, lights);
    hall.model.solid = true;

    scene.clear();
    addMaterials(scene, {}, 0);
    hall.model.pose(scene);
    scene.finish();
    if (!solveRadiosity(hall.radiosity, hall.model, scene, {}, gl, arena, workers, progress) ||
        !followBounces(hall, scene, arena, workers))
        return "the hall cannot be solved: OpenGL 3.3 draws no integers here, or memory is short";
    visit(hall, arena);
    closeHemicubes(hall.radiosity.hemicubes);
    for (int i = 0; i < scene.materialCount; ++i) hall.mean[i] = scene.mean[i];
    for (float *&plane : hall.light)
        if (!(plane = arena.take<float>((size_t)hall.model.texelCount + 8))) return "not enough memory";
    hall.map = {hall.model.charts, {hall.light[0], hall.light[1], hall.light[2]}, 1};
    return nullptr;
}

void poseHall(Hall &hall, const HallLight &light, float grey, Scene &scene) {
    addMaterials(scene, light, grey);
    hall.model.pose(scene);
    scene.lightmap = &hall.map;
    hall.map.sharpness = 1;

    // The hour, between two that are solved
    int hour = min(max((int)light.hour, 0), kHours - 2);
    float t = light.hour - (float)hour;
    SkyKey now = keyOf(between(kDay[hour], kDay[hour + 1], t));
    scene.sky = now.sky;
    Blend weights = {};
    weights.bounced[hour] = Rgb{1, 1, 1} * (1 - t);
    weights.bounced[hour + 1] = Rgb{1, 1, 1} * t;
    if (light.sun > 0) {
        Rgb strength = now.sunlight * (light.sun * dot(now.sunAt, now.sunAt));
        scene.add(pointLight(now.sunAt, strength));
    }
    weights.direct[hour] = kDay[hour].sunlight * ((1 - t) * (1 - light.sun));
    weights.direct[hour + 1] = kDay[hour + 1].sunlight * (t * (1 - light.sun));

    // The two strongest lanterns are drawn by the tracer, but for what lets one take another's place unseen:
    // the third's share
    float least = min(light.lanterns[0], min(light.lanterns[1], light.lanterns[2]));
    for (int i = 0; i < kLanterns; ++i) {
        float on = light.lanterns[i];
        if (on == 0) continue;
        float drawn = saturate((on - least) / (0.15f * on));
        Vec3 place = hall.radiosity.lights.lamps[i].centre;
        Rgb radiance = kLanternLight * on;
        weights.bounced[kHours + i] = radiance;
        weights.direct[kHours + i] = radiance * (1 - drawn);
        scene.add(sphere(place, kLanternRadius, kLantern + i));
        if (drawn > 0) scene.add(pointLight(place, radiance * (drawn * kLanternRadius * kLanternRadius)));
    }
    for (int i = 0; i < kStrips; ++i)
        weights.bounced[kHours + kLanterns + i] = weights.direct[kHours + kLanterns + i] =
            kStripLight * light.strips[i];
    blend(hall.radiosity, hall.model, weights, hall.light);

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
    scene.ambientLow = mean(1);
    scene.exposure = 1;
}

} // namespace odraz
