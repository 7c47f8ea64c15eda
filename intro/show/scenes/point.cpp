// Scene 1. Black; a light appears over dark marble and rises behind a ball of glass, which focuses it on the
// stone in a moving caustic. Then a word of light is written there, 5 cm above the marble, which mirrors it.
#include "base/maths.h"
#include "show/font.h"
#include "show/materials.h"
#include "show/scenes.h"
#include "timeline/keys.h"

namespace odraz {

#include "show/scenes/point.keys"

enum { kMarble, kClear };
static constexpr const Material *kMaterials[] = {[kMarble] = &kDarkMarble, [kClear] = &kGlass};

void posePoint(const SceneInput &in, Scene &scene) {
    float key = value(track(kKeyLight), in.row), rim = value(track(kRimLight), in.row),
          word = value(track(kWord), in.row), written = in.row - rowOf(kWordComes);
    scene.addAll(kMaterials);
    int glow = scene.add(lamp(Rgb{2.6f, 2.2f, 1.6f} * (80 * (0.2f + key))));
    int tube = scene.add(lamp(Rgb{3.0f, 0.8f, 0.18f} * (0.6f + word)));

    scene.add(plane({0, 0, 0}, kMarble))->textureShift = {3.1f, 0.37f, 1.9f};
    scene.add(sphere({-0.8f, 0.5f, 0.6f}, 0.5f, kClear));
    Vec3 foot = {-0.42f, 0.055f, -0.7f};
    addText(scene, "odraz", foot, 0.045f, written, tube);

    Vec3 point = {value(track(kPasses), in.row), value(track(kRises), in.row), -0.55f};
    if (key > 0) scene.add(sphere(point, 0.03f, glow));
    scene.add(Light{point, Rgb{4.9f, 3.75f, 2.55f} * key, 0.06f});
    scene.add(Light{{2.8f, 1.9f, -2.8f}, Rgb{3.6f, 4.9f, 7.4f} * rim, 0.2f});
    if (written > 0) scene.add(Light{foot + Vec3{1.2f, 0.35f, 0.1f}, Rgb{0.34f, 0.16f, 0.07f} * word, 0.2f});
    scene.ballsOcclude = true;
    scene.ambientLow = Rgb{0.012f, 0.012f, 0.016f} * key;
    scene.ambientHigh = Rgb{0.02f, 0.022f, 0.03f} * key;
    scene.sky = plainSky(Rgb{0.004f, 0.005f, 0.008f} * key, Rgb{0.016f, 0.021f, 0.034f} * key);
    // Add a cold glow behind the scene on the right, outside the picture: the ball's edge refracts it
    scene.sky.sun = normalize(Vec3{0.9f, 0.15f, -0.5f});
    scene.sky.near = Rgb{0.9f, 1.6f, 3.6f} * saturate(fmadd(in.row, 1 / 64.f, -0.375f));
    scene.sky.glow = scene.sky.near * 0.004f;
    scene.fog = 0.09f;
    scene.exposure = 1.5f;
}

} // namespace odraz
