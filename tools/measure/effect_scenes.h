// Small scenes, each of which shows one of the film's effects on balls: what they hide of lamps and sky, what
// glass gathers, how lamps shine on them.
#pragma once

#include "trace/rays/view.h"

#include <string>
#include <vector>

namespace odraz {

struct EffectScene {
    std::string name;
    // Fills a scene that is clear. `bounced`: what a white floor throws up of the sky, 0 .. 1
    void (*pose)(Scene &scene, float bounced);
    // Takes the effect away from a scene that is finished
    void (*strip)(Scene &scene);
    // What the effect stands for, where that is another scene; null: the same
    void (*truth)(Scene &scene);
    Vec3 eye, target;
    float fov;
    bool bounces; // light that goes on from matte places is worth comparing with, too
};

// The first one has no balls: what light is called is the same then.
const std::vector<EffectScene> &effectScenes();

inline constexpr float kEffectFloor = 0.6f; // its albedo
// What the floor shows of an effect scene's lamp and sky straight below the lamp, with exposure.
inline constexpr float kEffectShown = 0.4f;

} // namespace odraz
