// Scene 6. Odraz.
#include "show/materials.h"
#include "show/show.h"

namespace odraz {

void poseOdraz(double, Hall *hall, Scene &scene) {
    HallLight light = {7, {1, 0.8f, 0.6f}, {}, 1};
    poseHall(*hall, light, 0, scene);
}

} // namespace odraz
