#include "tools/measure/bench/growth_scenes.h"

#include "base/random.h"
#include "tools/measure/bench/peer_scenes.h"

#include <cmath>

namespace odraz::measure {

void poseBalls(Scene &scene, int count) {
    Material matte = {};
    Rgb grey = {0.7f, 0.6f, 0.5f};
    matte.texture = {Pattern::Plain, 1, {grey, grey, grey, grey}};
    matte.diffuse = 0.7f;
    matte.exponent = 1;
    matte.tint = {1, 1, 1};
    scene.add(plane({0, 0, 0}, scene.add(matte)));
    Material shiny = matte;
    shiny.specular = 0.5f;
    shiny.exponent = 64;
    int plain = scene.add(shiny);
    shiny.diffuse = 0.2f;
    shiny.reflect = 0.6f;
    int mirror = scene.add(shiny);

    float radius = 1.6f / std::sqrt((float)count);
    for (int i = 0; i < count; ++i) {
        auto random = [&](int k) { return unitFloat(pcg((uint32_t)(4 * i + k))); };
        scene.add(sphere({random(0) * 8 - 4, radius + random(1) * 3, random(2) * 6 - 4}, radius,
                         i % 3 ? plain : mirror));
    }
    for (Vec3 at : {Vec3{-6, 8, 7}, Vec3{7, 6, 4}}) scene.add(Light{at, Rgb{0.6f, 0.6f, 0.6f} * dot(at, at)});
    scene.ambientLow = scene.ambientHigh = {0.1f, 0.1f, 0.1f};
    scene.sky = plainSky({0.2f, 0.35f, 0.6f}, {0.2f, 0.35f, 0.6f});
}

void poseLights(Scene &scene, int count) {
    posePeerA(scene);
    scene.lightCount = count < 2 ? count : 2;
    for (int i = 2; i < count; ++i) {
        float turn = (float)i * 2.4f;
        Vec3 at = {8 * std::sin(turn), 5 + 0.5f * (float)i, 8 * std::cos(turn)};
        scene.add(Light{at, Rgb{0.2f, 0.2f, 0.2f} * dot(at, at)});
    }
}

} // namespace odraz::measure
