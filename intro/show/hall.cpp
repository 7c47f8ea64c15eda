#include "show/hall.h"

#include "base/maths.h"
#include "show/hall_model.h"
#include "show/materials.h"

#include <initializer_list>

namespace odraz {

namespace {

constexpr float kDust = 0.012f; // share of light that dust scatters per metre
constexpr float kDoorLamp = 0.38f;
constexpr Rgb kBounced = {0.55f, 0.72f, 0.9f}; // factor: keeps the wall around the door dark and cold
constexpr Rgb kLanternLight = Rgb{33, 28, 21};

// Returns a strip's colour: from copper on the left, where the light entered, through white to sky blue.
// `contrast`: the distance from white; -1 swaps the sides.
Rgb stripLight(int i, float contrast) {
    float s = fmadd((float)i, 2.f / 7, -1.f) * contrast;
    return {fmadd(s, -1.1f, 1.5f), fmadd(s * s, -0.75f, 1.7f), fmadd(s, 1.2f, 1.6f)};
}

// Blends a material (grey 0) with a grey that all materials share (grey 1).
Material faded(Material m, float grey) {
    if (grey == 0) return m;
    m.diffuse = lerp(m.diffuse, 1.f, grey);
    for (Texture *t : {&m.texture, &m.other})
        for (Rgb &c : t->palette) c = lerp(c, Rgb{0.6f, 0.6f, 0.6f}, grey);
    m.tint *= Rgb{1, 1, 1} * (1 - grey); // colour of reflections
    m.specular *= 1 - grey;
    if (grey == 1) m.texture.pattern = Pattern::Plain, m.cell = 0; // the pattern is invisible
    return m;
}

const Material *const kParts[] = {
    [kFloor] = &kHallFloor, [kWall] = &kPlaster,  [kWarm] = &kWarmPlaster,
    [kShaft] = &kLimestone, [kBlock] = &kGranite, [kBeamX] = &kBeamAcross,
    [kBeamZ] = &kBeamAlong, [kStep] = &kGranite,  [kSand] = &kOutside,
};
static_assert(sizeof kParts / sizeof *kParts == kLantern);

// The landscape outside: sand to the horizon, a hill (not a ball: balls cost more) and a pair of columns.
constexpr Shape kLandscape[] = {
    box({0, -0.2f, 159}, {999, 0.1f, 350}, kSand),
    {.kind = ShapeKind::Cylinder,
     .material = kSand,
     .centre = {100, -388, 600},
     .half = {406, 100, 406},
     .frame = {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}},
    cylinder({kColumnX, 4, 16}, kColumnRadius, 4, kWarm),
    cylinder({kColumnX, 4, 30}, kColumnRadius, 4, kWarm),
};

void addMaterials(Scene &scene, const HallLight &light, float grey) {
    for (const Material *m : kParts) scene.add(faded(*m, grey));
    for (float on : light.lanterns) scene.add(lamp(kLanternLight * on + Rgb{0.01f, 0.01f, 0.01f}));
    // Dark strips are pale glass in front of paler plaster. Lit strips are tubes with a white-hot middle
    for (int i = 0; i < kStrips; ++i) {
        float on = light.strips[i], round = min(on * 4, 1.f);
        Rgb colour = stripLight(i, 1);
        Material glass = lamp(colour * colour * (on * on)); // more saturated and more lively than their light
        glass.texture = {on > 0 ? Pattern::Tubes : Pattern::Plain, 2.5f, {}}, glass.diffuse = 0.6f;
        for (int k = 0; k < 4; ++k)
            glass.texture.palette[k] =
                kPlaster.texture.palette[1] * lerp(1.f, (float[]){1.5f, 0.9f, 0.5f, 0.35f}[k], round);
        scene.add(glass);
    }
}

// Adds the visible beams of sun in the air. Windows are deep: light must pass both ends of the opening. The
// far columns are left out: their shadows fall outside the hall or within the near columns' shadows.
void raiseShafts(Sunshafts &s, const Daylight &now, const HallLight &light) {
    Vec3 sun = now.sky.sun;
    // Make them fainter as the sun sinks, because low beams would run along the view and hide the hall
    Rgb scatter = now.sunlight * (kDust * light.sun * saturate(fmadd(sun.y, 3.4f, -0.5f)));
    if (maxComponent(scatter) <= 0) return;
    float deep = kDeep / -sun.x, down = deep * sun.y, along = -deep * sun.z;
    s.sun = sun;
    s.room = {{-kX, 0, -kZ}, {kX, kY, kZ}};
    s.low = kSill, s.high = kLintel - down;
    for (float z : kWindows) {
        s.from[s.openings] = z - kWindow + max(along, 0.f);
        s.to[s.openings++] = z + kWindow + min(along, 0.f);
    }
    for (float z : kColumns) s.pillarX[s.pillars] = -kColumnX, s.pillarZ[s.pillars++] = z;
    s.pillarRadius = kColumnRadius;
    s.scatter = scatter;
    s.drift = light.hour;
}

} // namespace

LightVector lightVector(const HallLight &light, const float *drawn) {
    LightVector v = {};
    Daylight now = daylightAt(light.hour);
    now.sky.near = {}; // counts as part of the sun
    if (light.hour < (float)kNight)
        project(now.sky, v.bounced); // the night sky is visible but lights nothing, which is cheaper
    // Interpolate the sun's light between two positions: the bounced light, and the share of the direct light
    // that the tracer does not draw
    float at = clamp(light.hour * 4, 0.f, (float)(kSuns - 1));
    int before = min((int)at, kSuns - 2);
    for (int i = 0; i < 2; ++i) {
        Rgb part = now.sunlight * (i ? at - (float)before : (float)(before + 1) - at);
        v.bounced[kFirstSun + before + i] = part;
        v.direct[kFirstSun + before + i] = part * (1 - light.sun);
    }
    for (int i = 0; i < kLanterns; ++i) {
        Rgb emitted = kLanternLight * light.lanterns[i];
        float offset = clamp(light.extra.position.z / kLanternSpacing, -1.f, 1.f) - (float)(i - 1),
              share = saturate(1 - abs(offset)) / (kLanternRadius * kLanternRadius);
        v.bounced[kFirstLantern + i] = emitted + light.extra.intensity * share;
        v.direct[kFirstLantern + i] = emitted * (1 - (drawn ? drawn[i] : 0));
    }
    // Leave out most of the direct light of strips that the tracer draws as a lamp. The rest, visible
    // in the lamp's shadows, has the colours of left and right swapped
    for (int i = 0; i < kStrips; ++i) {
        v.bounced[kFirstStrip + i] = stripLight(i, 1) * kBounced * light.strips[i];
        v.direct[kFirstStrip + i] =
            stripLight(i, fmadd(light.door, -2.f, 1.f)) * (light.strips[i] * fmadd(light.door, -0.9f, 1.f));
    }
    return v;
}

void prepareHall(Hall &hall, Scene &scene) {
    LightBases &bases = hall.radiosity.bases;
    (BasisOrder &)bases = kHallBases;
    bases.sky = [](const void *, const Vec3x8 &d, Float8 *y) { evaluate(d, y); };
    for (int i = 0; i < kSuns; ++i) bases.suns[i] = daylightAt((float)i * 0.25f).sunAt;
    buildHall(hall);
    scene.clear();
    addMaterials(scene, {}, 0);
    hall.model.pose(scene);
    scene.finish();
}

RoomSettings hallSettings(const Hall &hall) {
    return {kHallSettings, kGlossExponent, hall.floor, lightVector({kNoon, {}, {}, 0}), {0.5f, 0, 0.6f}};
}

void poseHall(Hall &hall, const HallLight &light, float grey, const Vec3 &eye, Scene &scene) {
    addMaterials(scene, light, grey);
    poseRoom(hall, scene);

    Daylight now = daylightAt(light.hour);
    scene.sky = now.sky;
    raiseShafts(scene.shafts, now, light);
    if (Rgb sun = now.sunlight * (light.sun * dot(now.sunAt, now.sunAt)); maxComponent(sun) > 0)
        scene.add(Light{now.sunAt, sun});
    if (maxComponent(light.extra.intensity) > 0) scene.add(light.extra);

    // Let the tracer draw the two strongest lanterns. A lantern that exceeds the weakest by less than 15 % of
    // its own light is drawn in part, so that nothing jumps when the order changes
    float least = min(light.lanterns[0], min(light.lanterns[1], light.lanterns[2])), drawn[kLanterns] = {};
    for (int i = 0; i < kLanterns; ++i) {
        float on = light.lanterns[i];
        if (on == 0 && (grey == 1 || light.door > 0)) continue;
        drawn[i] = saturate((on - least) / (0.15f * on + 1e-6f));
        Vec3 centre = hall.radiosity.bases.lamps[i].centre;
        scene.add(sphere(centre, kLanternRadius, kLantern + i));
        if (drawn[i] > 0)
            scene.add(Light{centre, kLanternLight * (on * drawn[i] * kLanternRadius * kLanternRadius),
                            kLanternRadius});
    }
    relightRoom(hall, lightVector(light, drawn), eye, 0.06f, 0.5f * (1 - grey));

    // Add the strips' lamp. It is behind the centre of the lit strips, so that shadows turn with the tune.
    // Copper light falls on the left, blue light on the right. The lamp is behind the wall, so that it lights
    // neither wall nor strips, and shines through the wall. If it were more than 0.3 m behind the wall, its
    // light on the side walls would end at a strip on one side and at a gap on the other
    Rgb burning = {};
    float x = 0, on = 1e-6f;
    for (int i = 0; i < kStrips; ++i) {
        burning += stripLight(i, 1) * light.strips[i];
        x += light.strips[i] * fmadd((float)i, 0.4f, -1.4f);
        on += light.strips[i];
    }
    if (light.door * maxComponent(burning) > 0)
        scene.add(Light{{x / on, 2.7f, -0.0255f - kZ}, burning * (light.door * kDoorLamp), 0.3f, 1});

    if (grey + light.door == 0) scene.addAll(kLandscape); // until the door is lit
    // Give balls the mean light of floor and ceiling as ambient light
    scene.ambientHigh = meanLight(hall, hall.floor);
    scene.ambientLow = meanLight(hall, hall.vault);
    scene.ballsOcclude = true;
    scene.exposure = 1;
}

} // namespace odraz
