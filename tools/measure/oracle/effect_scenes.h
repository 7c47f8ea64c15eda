// Small scenes that each show one of the film's effects on balls: the light that balls block from the floor
// and from other balls, the light that glass throws on the floor, and highlights of lamps.
#pragma once

#include "trace/rays/view.h"

#include <vector>

namespace odraz::measure {

enum class Effect {
    Occlusion,       // of a lamp, the sky, or light through glass
    Highlight,       // Phong's
    HighlightAsLamp, // the same, compared with a mirror that is as bright and shows the lamp
    LampInMirror,
};

struct EffectBall {
    Vec3 centre;
    float radius;
};

struct EffectScene {
    const char *name;
    Effect effect;
    float lamp, sky; // radius of the lamp, 0: no lamp; the sky's share of the floor's light, 0 .. 1
    std::vector<EffectBall> balls;
    Material material; // of the balls
    Vec3 eye, target;
    float fov;
    bool bounces; // the comparison also includes light that bounces off matte places

    // Fills an empty scene. `bounced`: the share of the sky's light that a white floor sends up, 0 .. 1
    void pose(Scene &scene, float bounced) const;
    // Removes the effect from a finished scene.
    void strip(Scene &scene) const;
    // Replaces the effect in a posed scene by what it approximates.
    void makeTrue(Scene &scene) const;
};

// The first scene has no balls: it shows that the tracer and the paths measure light alike.
const std::vector<EffectScene> &effectScenes();

inline constexpr float kEffectFloor = 0.6f; // its albedo
// What the floor straight below the lamp shows of the scene's lamp and sky, with exposure.
inline constexpr float kEffectShown = 0.4f;

} // namespace odraz::measure
