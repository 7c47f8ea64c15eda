#include "tools/measure/effect_scenes.h"

#include "show/materials.h"

namespace odraz {

namespace {

constexpr Vec3 kLampAt = {2.4f, 5.2f, -1.6f};
constexpr float kOfSky = 0.15f; // of the floor's light, where there are both

Material matte(float grey) {
    Material m = {};
    m.texture.palette[0] = {grey, grey, grey};
    m.diffuse = 1;
    return m;
}
Material clear() {
    Material m = {};
    m.ior = 1.5f;
    return m;
}

// Floor, lamp and sky, which bring the floor `kEffectShown` together, below the lamp.
void begin(Scene &scene, float lampRadius, float ofSky, float bounced) {
    float light = kEffectShown / kEffectFloor;
    scene.contact = true;
    scene.ambientHigh = Rgb{1, 1, 1} * (light * ofSky);
    scene.ambientLow = scene.ambientHigh * (bounced * kEffectFloor);
    scene.sky = plainSky(scene.ambientHigh, scene.ambientHigh);
    if (lampRadius > 0) {
        float strength = light * (1 - ofSky) * kLampAt.y * kLampAt.y;
        scene.add(Light{kLampAt, Rgb{1, 1, 1} * strength, lampRadius});
    }
    scene.add(plane({0, 0, 0}, scene.add(matte(kEffectFloor))));
}
void one(Scene &scene, const Material &m, float height) {
    scene.add(sphere({0, height, 0}, 0.5f, scene.add(m)));
}

void poseFloor(Scene &scene, float bounced) { begin(scene, 0.5f, kOfSky, bounced); }
// One that lies, two that float and whose shadows meet
void three(Scene &scene) {
    int m = scene.add(matte(0.5f));
    scene.add(sphere({0.75f, 0.3f, -0.5f}, 0.3f, m));
    scene.add(sphere({-0.2f, 1.1f, 0.1f}, 0.45f, m));
    scene.add(sphere({0.5f, 1.7f, 0.35f}, 0.25f, m));
}
void poseShadow(Scene &scene, float bounced) { begin(scene, 0.5f, 0, bounced), three(scene); }
void poseWideShadow(Scene &scene, float bounced) { begin(scene, 1.5f, 0, bounced), three(scene); }
void poseContact(Scene &scene, float bounced) {
    begin(scene, 0, 1, bounced);
    one(scene, matte(0.5f), 0.5f);
}
// Each touches the floor and the first one
void poseContacts(Scene &scene, float bounced) {
    poseContact(scene, bounced);
    int m = scene.shapes[1].material;
    scene.add(sphere({-0.8f, 0.32f, 0}, 0.32f, m)); // (.5 + .32)^2 = .8^2 + .18^2
    scene.add(sphere({0.3795f, 0.2f, -0.5060f}, 0.2f, m));
}
void poseCaustic(Scene &scene, float bounced) {
    begin(scene, 0.5f, 0, bounced);
    one(scene, clear(), 0.9f);
}
void poseLyingCaustic(Scene &scene, float bounced) {
    begin(scene, 0.5f, 0, bounced);
    one(scene, clear(), 0.5f);
}
void poseGlass(Scene &scene, float bounced) {
    begin(scene, 0.5f, kOfSky, bounced);
    one(scene, kGlass, 0.5f);
}
void poseHighlight(Scene &scene, float bounced) {
    begin(scene, 0.5f, 0, bounced);
    one(scene, pearl(false, 0.1f), 0.5f);
}
void poseWideHighlight(Scene &scene, float bounced) {
    begin(scene, 1.5f, 0, bounced);
    one(scene, pearl(false, 0.1f), 0.5f);
}
// The lamp's body, for those who see it
void addBody(Scene &scene) {
    const Light &l = scene.lights[0];
    scene.add(sphere(l.position, l.radius, scene.add(lamp(l.intensity * (1 / (l.radius * l.radius))))));
}
// A weak mirror that shows no lamp, but a highlight as bright as that ...
void posePolished(Scene &scene, float lampRadius, float bounced) {
    begin(scene, lampRadius, 0, bounced);
    Material m = matte(0.2f);
    m.specular = 0.8f;
    m.exponent = 300;
    one(scene, m, 0.5f);
    float far = length(kLampAt - scene.shapes[1].centre) - 0.5f;
    scene.materials[1].reflect = m.specular * lampRadius * lampRadius / (far * far);
}
void poseSmallImage(Scene &scene, float bounced) { posePolished(scene, 0.5f, bounced); }
void poseWideImage(Scene &scene, float bounced) { posePolished(scene, 1.5f, bounced); }
// ... and one that shows it
void lampInstead(Scene &scene) {
    scene.materials[1].specular = 0;
    addBody(scene);
}
// A mirror without a highlight of its own, and the lamp's body in it
void poseImage(Scene &scene, float bounced) {
    begin(scene, 0.5f, kOfSky, bounced);
    Material m = kMirror;
    m.specular = 0;
    one(scene, m, 0.5f);
    addBody(scene);
}

void withoutBalls(Scene &scene) { scene.occluderCount = 0; }
void withoutHighlights(Scene &scene) {
    for (int i = 0; i < scene.materialCount; ++i) scene.materials[i].specular = 0;
}
void withoutLamps(Scene &scene) { scene.lampCount = 0; }

constexpr Vec3 kEye = {-0.6f, 1.9f, -4}, kTarget = {-0.1f, 0.45f, 0.2f}, kNearEye = {-0.2f, 1.3f, -2.2f},
               kBall = {0, 0.55f, 0}, kShadows = {-0.05f, 0.75f, 0.2f};

} // namespace

const std::vector<EffectScene> &effectScenes() {
    static const std::vector<EffectScene> all = {
        {"floor", poseFloor, withoutBalls, nullptr, kEye, kTarget, 36, false},
        {"shadow", poseShadow, withoutBalls, nullptr, kEye, kShadows, 40, true},
        {"shadow of a wide lamp", poseWideShadow, withoutBalls, nullptr, kEye, kShadows, 40, false},
        {"contact", poseContact, withoutBalls, nullptr, kEye, kTarget, 30, true},
        {"contact of three", poseContacts, withoutBalls, nullptr, kEye, kTarget, 30, true},
        {"caustic", poseCaustic, withoutBalls, nullptr, kEye, kTarget, 36, false},
        {"caustic of a ball that lies", poseLyingCaustic, withoutBalls, nullptr, kEye, kTarget, 30, false},
        {"the film's glass", poseGlass, withoutBalls, nullptr, kEye, kTarget, 30, true},
        {"highlight", poseHighlight, withoutHighlights, nullptr, kNearEye, kBall, 30, false},
        {"highlight of a wide lamp", poseWideHighlight, withoutHighlights, nullptr, kNearEye, kBall, 30,
         false},
        {"highlight as an image", poseSmallImage, withoutHighlights, lampInstead, kNearEye, kBall, 30, false},
        {"highlight as a wide image", poseWideImage, withoutHighlights, lampInstead, kNearEye, kBall, 30,
         false},
        {"a lamp in a mirror", poseImage, withoutLamps, nullptr, kNearEye, kBall, 30, false},
    };
    return all;
}

} // namespace odraz
