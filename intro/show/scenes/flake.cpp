// Scene 3. Flake: balls grow on a mirror ball, and balls on those balls. The camera flies between them with a
// light. The figure is "balls" of Haines' Standard Procedural Databases.
#include "base/maths.h"
#include "show/materials.h"
#include "show/scenes.h"
#include "timeline/keys.h"

namespace odraz {

#include "show/scenes/flake.keys"

namespace {

constexpr int kLevels = 3; // 1 + 9 + 81 + 729 balls
constexpr int kShades = 6;
// Detail is chosen for a picture of kLines lines, whatever its actual size and lens. kPixelsPerUnit: the size
// in pixels of a length of 1 at distance 1
constexpr float kLines = 720, kPixelsPerUnit = kLines * 25 / 18;
constexpr float kGenerations[kLevels] = {rowOf(kGeneration1), rowOf(kGeneration2), rowOf(kGeneration3)};

struct Flake {
    Scene &scene;
    CameraKey camera;
    float grown[kLevels], turn;
    int silver, copper;
    int pearls[2][kShades]; // [warm][shade]: the larger the shade, the more they reflect

    // Adds a ball and the balls on it: six around its equator and three above, all sixty degrees apart.
    void add(int level, const Vec3 &centre, float radius, const Mat3 &frame) {
        // Choose detail by projected size: small balls mirror less or nothing, and the balls on a ball grow
        // from nothing as it comes near
        float distance = max(length(centre - camera.eye) - 2 * radius, 0.1f),
              pixels = radius / distance * kPixelsPerUnit;
        int shade = clamp((int)(pixels * 0.04f) - level, 0, kShades - 1);
        scene.add(sphere(centre, radius, level > 1 ? pearls[level & 1][shade] : level ? copper : silver));
        float size = grown[min(level, kLevels - 1)] * (1.f / 3) * saturate(pixels * 0.05f - 0.4f);
        if (level == kLevels || size <= 0) return;
        for (int i = 0; i < 9; ++i) {
            float around = ((float)i * 60 + (i < 6 ? 0 : (float)i * 60 - 330)) * (kPi / 180) +
                           turn * (1 + 2 * (float)level);
            float up = i < 6 ? 0 : 0.8164966f, out = i < 6 ? 1 : 0.5773503f;
            Vec3 local = {out * cos(around), up, out * sin(around)};
            Vec3 v = transposeTimes(frame, local),
                 u = normalize(cross(v, transposeTimes(frame, Vec3{local.z, 0.3f, -local.x})));
            add(level + 1, centre + v * (radius * (1 + size)), radius * size, {u, v, cross(u, v)});
        }
    }
};

} // namespace

void poseFlake(const SceneInput &in, Scene &scene) {
    Flake flake = {scene, in.camera, {}, in.row * 0.002f, 0, 0, {}};
    for (int i = 0; i < kLevels; ++i) flake.grown[i] = value(track(kGrow), in.row - kGenerations[i]);
    flake.silver = scene.add(kMirror);
    flake.copper = scene.add(pearl(true, 0.45f));
    for (int i = 0; i < kShades; ++i)
        for (int warm = 0; warm < 2; ++warm)
            flake.pearls[warm][i] = scene.add(pearl(warm, 0.26f * (float)i / (kShades - 1)));
    scene.add(plane({0, 0, 0}, scene.add(kSlate)));
    flake.add(0, {0, 2.5f, 0}, 2.5f, kIdentity);

    // Add the sun, and a lamp that travels behind the camera to one side. It is brighter far away, so that
    // balls in front of the sun are not black
    Vec3 eye = flake.camera.eye, back = normalize(eye - flake.camera.target);
    scene.add(Light{kDuskSun * 3.f, {4600, 2900, 1700}, 1.8f});
    scene.add(Light{eye + back * 0.6f + Vec3{back.z, 0.7f, -back.x} * 0.9f,
                    Rgb{4.0f, 4.4f, 5.0f} * (dot(eye, eye) * 0.03f), 0.1f});
    scene.ambientLow = {0.13f, 0.115f, 0.135f};
    scene.ambientHigh = {0.09f, 0.12f, 0.19f};
    // Begin in a blue twilight
    float late = saturate(1 - in.row * in.row * (1.f / 16384));
    scene.sky = duskSky(in.row + 192, late);
    scene.exposure = 0.75f;
}

} // namespace odraz
