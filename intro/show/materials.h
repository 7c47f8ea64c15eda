// The film's materials: stone greys and warm wood, with a warm accent (copper) and a cold one (sky).
#pragma once

#include "trace/scene/scene.h"

namespace odraz {

extern const Material kDarkMarble; // black stone with pale veins, polished
extern const Material kSlate;      // dark and dull
extern const Material kBoards;     // a checker of stone and wood
extern const Material kLimestone;  // columns of the hall
extern const Material kHallFloor;  // a checker of two stones, polished
extern const Material kPlaster, kWarmPlaster, kOutside;
extern const Material kBeamAlong, kBeamAcross; // oak with its grain along world z, or x
extern const Material kGranite, kOak, kGlass, kMirror, kCopper;

Material metal(bool warm, float reflect); // copper if warm, else silver; reflect: reflectance as a mirror
Material lamp(const Rgb &radiance);       // only emits

// Fills a scene with fog and a little light. share: factor on the light.
void setGloom(Scene &scene, float share);

// Dusk under clouds that drift with the rows and glow near the sun. `late`, 0 .. 1: at 1 it is blue and the
// sun is low. kDuskSun: the sun's position, for a light.
Sky duskSky(float row, float late = 0);
inline constexpr Vec3 kDuskSun = {-13.7f, 4.9f, 10.6f};

} // namespace odraz
