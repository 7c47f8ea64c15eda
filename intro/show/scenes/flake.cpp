// Scene 3. Flake: on still water, balls grow on a mirror ball, and balls on those balls, a generation a bar.
// The camera follows the point of light between them. The figure is "balls" of Haines' Standard Procedural
// Databases.
#include "base/maths.h"
#include "show/materials.h"
#include "show/point_of_light.h"
#include "show/scenes.h"
#include "timeline/keys.h"

namespace odraz {

#include "show/scenes/flake.keys"

namespace {

constexpr int kLevels = 3;     // 1 + 9 + 81 + 243 balls
constexpr float kLeaves = 160; // row of the last shot
// Detail is chosen for a picture of kLines lines, whatever its actual size and lens. kPixelsPerUnit: the size
// in pixels of a length of 1 at distance 1
constexpr float kLines = 720, kPixelsPerUnit = kLines * 7 / 6;
constexpr float kGenerations[kLevels] = {rowOf(kGeneration1), rowOf(kGeneration2), rowOf(kGeneration3)};

struct Flake {
    Scene &scene;
    CameraKey camera;
    float grown[kLevels], turn;
    int metals[3]; // by level; the last level has that of level 1

    // Adds a ball and the balls on it: six around its equator and three above, all sixty degrees apart. In
    // the last generation only two of the six and one of the three, so that there is space between the
    // clusters.
    void add(int level, const Vec3 &centre, float radius, const Mat3 &frame) {
        // The balls on a ball grow from nothing as it comes near
        float distance = max(length(centre - camera.eye) - 2 * radius, 0.1f),
              pixels = radius / distance * kPixelsPerUnit;
        scene.add(sphere(centre, radius, metals[level > 2 ? 1 : level]));
        float size = grown[min(level, kLevels - 1)] * (1.f / 3) * saturate(pixels * 0.0625f - 0.75f);
        if (level == kLevels || size <= 0) return;
        for (int i = 0; i < 9; i += level < 2 ? 1 : 4) {
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
    // While the camera leaves, the flake turns faster and faster, then stops dead
    float row = min(in.row, rowOf(kFlakeGoes)), leaves = max(row - kLeaves, 0.f);
    Flake flake = {scene, in.camera, {}, row * 0.002f + leaves * leaves * 0.0016f, {}};
    for (int i = 0; i < kLevels; ++i) flake.grown[i] = value(track(kGrow), in.row - kGenerations[i]);
    // The balls on the core mirror less than it does, so that images of images darken. Copper has broad
    // highlights, as if brushed; mirrors have none, which costs less
    for (int i = 0; i < 3; ++i) {
        Material material = i ? metal(i > 1, 0.6875f - 0.0625f * (float)i) : kMirror;
        material.specular = i > 1 ? 0.1875f : 0, material.exponent = 12;
        flake.metals[i] = scene.add(material);
    }
    // Water has a colour of its own instead of diffuse light, so that no shadow falls on it
    Material water = kSlate;
    water.diffuse = 0, water.emit = {0.016f, 0.015f, 0.03f};
    scene.add(plane({0, 0, 0}, scene.add(water)));
    flake.add(0, {0, 2.5f, 0}, 2.5f, kIdentity);

    scene.add(Light{kDuskSun * 3.f, {4600, 2900, 1700}, 1.8f});
    PointOfLight point = pointOf(kFlake, in.row);
    addPoint(scene, point, 0.05f + 0.03f * point.shine, Rgb{400, 250, 110});
    scene.ambientLow = {0.07f, 0.06f, 0.08f};
    scene.ambientHigh = {0.19f, 0.17f, 0.18f};
    // Begin in a blue twilight
    float late = saturate(1 - in.row * in.row * (1.f / 16384));
    scene.sky = duskSky(in.row + 192, late);
    scene.exposure = 0.875f;
}

} // namespace odraz
