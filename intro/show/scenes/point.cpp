// Scene 1. Black; a light appears over dark marble and rises behind a ball of glass, which focuses it on the
// stone in a moving caustic. Then it writes a word of light, 5 cm above the marble, which mirrors it, and
// flies at the lens.
#include "base/maths.h"
#include "show/font.h"
#include "show/materials.h"
#include "show/point_of_light.h"
#include "show/scenes.h"
#include "timeline/keys.h"

namespace odraz {

#include "show/scenes/point.keys"

enum { kMarble, kClear };
static constexpr const Material *kMaterials[] = {[kMarble] = &kDarkMarble, [kClear] = &kGlass};

static constexpr Shape kShapes[] = {
    {.kind = ShapeKind::Plane, .material = kMarble, .textureShift = {3.1f, 0.37f, 1.9f}},
    sphere({-0.8f, 0.5f, 0.6f}, 0.5f, kClear),
};

void posePoint(const SceneInput &in, Scene &scene) {
    PointOfLight point = pointOf(kPoint, in.row);
    float rim = value(track(kRimLight), in.row), word = value(track(kWord), in.row),
          written = in.row - rowOf(kWordComes);
    scene.addAll(kMaterials);
    int tube = scene.add(lamp(Rgb{3.0f, 0.8f, 0.18f} * (0.6f + word)));

    scene.addAll(kShapes);
    Vec3 foot = {-0.42f, 0.055f, -0.7f}, tip = addText(scene, "odraz", foot, 0.045f, written, tube);
    // The light is the tip of the pen
    if (written > 0 && in.row < rowOf(kWordStands)) point.at = tip;
    addPoint(scene, point, 0.03f, {4.9f, 3.75f, 2.55f});
    scene.add(Light{{2.8f, 1.9f, -2.8f}, Rgb{3.6f, 4.9f, 7.4f} * rim, 0.2f});
    if (written > 0) scene.add(Light{foot + Vec3{1.2f, 0.35f, 0.1f}, Rgb{0.34f, 0.16f, 0.07f} * word, 0.2f});
    setGloom(scene, point.shine);
    // Add a cold glow behind the scene on the right, outside the picture: the ball's edge refracts it
    scene.sky.sun = normalize(Vec3{0.9f, 0.15f, -0.5f});
    scene.sky.near = Rgb{0.9f, 1.6f, 3.6f} * saturate(fmadd(in.row, 1 / 64.f, -0.375f));
    scene.sky.glow = scene.sky.near * 0.004f;
    scene.exposure = 1.5f;
}

} // namespace odraz
