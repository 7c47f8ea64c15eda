// Scene 4. The hall, before light.
#include "show/materials.h"
#include "show/show.h"

namespace odraz {

void posePatches(double, Hall *hall, Scene &scene) {
    HallLight light = {kNoon, {}, {}, 1};
    poseHall(*hall, light, 0, scene);
}

void letterPatches(double, const Hall *, const Facts &, Frame &) {}

} // namespace odraz
