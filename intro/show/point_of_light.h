// The point of light, the film's protagonist, as data. (While it writes the word, its scene draws it at the
// pen's tip.)
#pragma once

#include "trace/scene/scene.h"

namespace odraz {

struct PointOfLight {
    Vec3 at;     // metres, in the scene's own space
    float shine; // brightness: 0 is out, 1 full
};

// Returns the point of light on a row of a scene's story, or at a time of the film.
PointOfLight pointOf(int scene, float storyRow);
PointOfLight pointAt(double seconds);

inline constexpr Rgb kPointLight = {2.6f, 2.2f, 1.6f}; // its colour

// Adds it to a scene as a bright ball, and as a light unless `intensity`, its radiant intensity at full
// brightness, is black. Adds nothing while it is out.
void addPoint(Scene &scene, const PointOfLight &point, float radius, const Rgb &intensity);

} // namespace odraz
