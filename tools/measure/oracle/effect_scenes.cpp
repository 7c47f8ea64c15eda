#include "tools/measure/oracle/effect_scenes.h"

#include "show/materials.h"

namespace odraz::measure {

namespace {

constexpr Vec3 kLampAt = {2.4f, 5.2f, -1.6f};
constexpr Vec3 kEye = {-0.6f, 1.9f, -4}, kTarget = {-0.1f, 0.45f, 0.2f}, kNearEye = {-0.2f, 1.3f, -2.2f},
               kBall = {0, 0.55f, 0}, kShadows = {-0.05f, 0.75f, 0.2f};
constexpr float kLamp = 0.5f, kWide = 1.5f; // radii
constexpr float kSomeSky = 0.15f;
constexpr EffectBall kLying = {{0, 0.5f, 0}, 0.5f}, kFloating = {{0, 0.9f, 0}, 0.5f};

Material matte(float grey) {
    Material m = {};
    m.texture.palette[0] = {grey, grey, grey};
    m.diffuse = 1;
    return m;
}
Material clearGlass() {
    Material m = {};
    m.ior = 1.5f;
    return m;
}
// A weak mirror: for the ball kLying, the mirror image of a lamp is as bright as its highlight.
Material polished(float lamp) {
    Material m = matte(0.2f);
    m.specular = 0.8f;
    m.exponent = 300;
    float far = length(kLampAt - kLying.centre) - kLying.radius;
    m.reflect = m.specular * lamp * lamp / (far * far);
    return m;
}
Material mirror() {
    Material m = kMirror;
    m.specular = 0;
    return m;
}

void addLampsBody(Scene &scene) {
    const Light &l = scene.lights[0];
    scene.add(sphere(l.position, l.radius, scene.add(lamp(l.intensity * (1 / (l.radius * l.radius))))));
}

} // namespace

void EffectScene::pose(Scene &scene, float bounced) const {
    float light = kEffectShown / kEffectFloor;
    scene.ballsOcclude = true;
    scene.ambientHigh = Rgb{1, 1, 1} * (light * sky);
    scene.ambientLow = scene.ambientHigh * (bounced * kEffectFloor);
    scene.sky = plainSky(scene.ambientHigh, scene.ambientHigh);
    if (lamp > 0) scene.add(Light{kLampAt, Rgb{1, 1, 1} * (light * (1 - sky) * kLampAt.y * kLampAt.y), lamp});
    scene.add(plane({0, 0, 0}, scene.add(matte(kEffectFloor))));
    int number = scene.add(material);
    for (const EffectBall &b : balls) scene.add(sphere(b.centre, b.radius, number));
    if (effect == Effect::LampInMirror) addLampsBody(scene);
}

void EffectScene::strip(Scene &scene) const {
    switch (effect) {
    case Effect::Occlusion:
        scene.occluderCount = 0;
        break;
    case Effect::Highlight:
    case Effect::HighlightAsLamp:
        for (int i = 0; i < scene.materialCount; ++i) scene.materials[i].specular = 0;
        break;
    case Effect::LampInMirror:
        scene.glowingBallCount = 0;
        break;
    }
}

void EffectScene::makeTrue(Scene &scene) const {
    if (effect != Effect::HighlightAsLamp) return;
    strip(scene);
    addLampsBody(scene);
}

const std::vector<EffectScene> &effectScenes() {
    using enum Effect;
    // `one` touches the floor; `floating`: one ball; `three`: two float, and all shadows overlap; `touching`:
    // each ball touches the floor, and the first ball
    static const std::vector<EffectBall> one = {kLying}, floating = {kFloating},
                                         three = {{{0.75f, 0.3f, -0.5f}, 0.3f},
                                                  {{-0.2f, 1.1f, 0.1f}, 0.45f},
                                                  {{0.5f, 1.7f, 0.35f}, 0.25f}},
                                         touching = {
                                             kLying,
                                             {{-0.8f, 0.32f, 0}, 0.32f}, // (.5 + .32)^2 = .8^2 + .18^2
                                             {{0.3795f, 0.2f, -0.5060f}, 0.2f}};
    static const Material grey = matte(0.5f), pearly = pearl(false, 0.1f);
    static const std::vector<EffectScene> all = {
        {"floor", Occlusion, kLamp, kSomeSky, {}, grey, kEye, kTarget, 36, false},
        {"shadow", Occlusion, kLamp, 0, three, grey, kEye, kShadows, 40, true},
        {"shadow of a wide lamp", Occlusion, kWide, 0, three, grey, kEye, kShadows, 40, false},
        {"occlusion", Occlusion, 0, 1, one, grey, kEye, kTarget, 30, true},
        {"occlusion of three", Occlusion, 0, 1, touching, grey, kEye, kTarget, 30, true},
        {"caustic", Occlusion, kLamp, 0, floating, clearGlass(), kEye, kTarget, 36, false},
        {"caustic of a ball that lies", Occlusion, kLamp, 0, one, clearGlass(), kEye, kTarget, 30, false},
        {"the film's glass", Occlusion, kLamp, kSomeSky, one, kGlass, kEye, kTarget, 30, true},
        {"highlight", Highlight, kLamp, 0, one, pearly, kNearEye, kBall, 30, false},
        {"highlight of a wide lamp", Highlight, kWide, 0, one, pearly, kNearEye, kBall, 30, false},
        {"highlight as an image", HighlightAsLamp, kLamp, 0, one, polished(kLamp), kNearEye, kBall, 30,
         false},
        {"highlight as a wide image", HighlightAsLamp, kWide, 0, one, polished(kWide), kNearEye, kBall, 30,
         false},
        {"a lamp in a mirror", LampInMirror, kLamp, kSomeSky, one, mirror(), kNearEye, kBall, 30, false},
    };
    return all;
}

} // namespace odraz::measure
