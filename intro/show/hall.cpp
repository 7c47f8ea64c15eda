#include "show/hall.h"

#include "base/maths.h"
#include "show/hall_model.h"
#include "show/materials.h"

#include <initializer_list>

namespace odraz {

namespace {

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

const Material *const kParts[] = {
    [kFloor] = &kHallFloor, [kWall] = &kPlaster,     [kWarm] = &kWarmPlaster, [kShaft] = &kLimestone,
    [kBlock] = &kGranite,   [kBeamX] = &kBeamAcross, [kBeamZ] = &kBeamAlong,  [kStep] = &kGranite,
};
static_assert(sizeof kParts / sizeof *kParts == kLantern);

void addMaterials(Scene &scene, const HallLight &light, float grey) {
    for (const Material *m : kParts) scene.add(faded(*m, grey));
    for (float on : light.lanterns) scene.add(lamp(kLanternLight * on + Rgb{0.01f, 0.01f, 0.01f}));
    for (float on : light.strips) scene.add(lamp(kStripLight * on + Rgb{0.01f, 0.01f, 0.01f}));
}

} // namespace

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

void prepareHall(Hall &hall, Scene &scene) {
    Lights &lights = hall.radiosity.lights;
    lights.skyCount = kSh;
    lights.sky = [](const void *, const Vec3x8 &d, Float8 *y) { evaluate(d, y); };
    lights.sunCount = kSuns;
    for (int i = 0; i < kSuns; ++i) lights.suns[i] = daylightAt((float)i * 0.25f).sunAt;
    buildHall(hall);
    scene.clear();
    addMaterials(scene, {}, 0);
    hall.model.pose(scene);
    scene.finish();
}

RoomSettings hallSettings(const Hall &hall) {
    RoomSettings s = {kHallSettings, {}, hall.floor, {}, lightVector({kNoon, {}, {}, 0}), {0.5f, 0, 0.6f}};
    for (int hour = 0; hour < kHours; ++hour) {
        LightVector v = lightVector({(float)hour, {1, 1, 1}, {1, 1, 1, 1, 1, 1, 1, 1}, 1});
        for (int k = 0; k < kHallBases; ++k) s.importance[k] += length(v.bounced[k]);
    }
    for (int i = 0; i < kSuns; ++i) s.importance[kSh + i] = 1;
    return s;
}

void poseHall(Hall &hall, const HallLight &light, float grey, const Vec3 &eye, Scene &scene) {
    addMaterials(scene, light, grey);
    poseRoom(hall, scene);

    Daylight now = daylightAt(light.hour);
    scene.sky = now.sky;
    if (light.sun > 0) scene.add(Light{now.sunAt, now.sunlight * (light.sun * dot(now.sunAt, now.sunAt))});

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
            scene.add(Light{place, kLanternLight * (on * drawn[i] * kLanternRadius * kLanternRadius)});
    }
    relightRoom(hall, lightVector(light, drawn), eye, 0.06f, 0.5f * (1 - grey));

    // Balls get what floor and ceiling get on average
    scene.ambientHigh = meanLight(hall, hall.floor);
    scene.ambientLow = meanLight(hall, hall.vault);
    scene.contact = true;
    scene.exposure = 1;
}

} // namespace odraz
