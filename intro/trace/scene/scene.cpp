#include "trace/scene/scene.h"

#include "trace/scene/surface.h"

namespace odraz {

void Scene::clear() {
    shapeCount = materialCount = lightCount = 0;
    sky = {};
    shafts = {};
    ambientLow = ambientHigh = {};
    fog = lines = 0;
    lightmap = nullptr;
    exposure = 1;
    ballsOcclude = false;
    overflow = nullptr;
}

// A limit, and the error of exceeding it.
#define LIMIT(name) name, "scene too large: raise " #name " in trace/scene/scene.h"

// Returns the next free index of an array. In a full array it is the last one, and `overflow` is set.
int Scene::next(int &count, int most, const char *limit) {
    if (count < most) return count++;
    overflow = limit;
    return most - 1;
}

int Scene::add(const Material &m) {
    int i = next(materialCount, LIMIT(kMaxMaterials));
    materials[i] = m;
    return i;
}

Shape *Scene::add(const Shape &s) {
    Shape *to = &shapes[next(shapeCount, LIMIT(kMaxShapes))];
    *to = s;
    return to;
}

void Scene::add(const Light &l) { lights[next(lightCount, LIMIT(kMaxLights))] = l; }

void Scene::finish() {
    int bounded = 0;
    unboundedCount = occluderCount = glowingBallCount = 0;
    for (int i = 0; i < shapeCount; ++i) {
        Shape &s = shapes[i];
        s.aligned = s.frame.u.x == 1 && s.frame.v.y == 1 && s.frame.w.z == 1;
        if (!s.traits().bounded) {
            unbounded[next(unboundedCount, LIMIT(kMaxUnbounded))] = (uint16_t)i;
            continue;
        }
        box[i] = boundsOf(s);
        // Leave out shapes with a side that is not finite, or is too short to have a direction: their boxes
        // are not finite. Compare bits, without the sign, because the compiler assumes that floats are finite
        if ((uint32_t)bits(box[i].hi.x) * 2 >= (uint32_t)bits(kInfinity) * 2) continue;
        order[bounded++] = (uint16_t)i;
        if (!s.isBall()) continue;
        const Material &m = materials[s.material];
        if (m.onlyGlows()) {
            glowingBall[next(glowingBallCount, LIMIT(kMaxGlowingBalls))] = (uint16_t)i;
        } else if (ballsOcclude) {
            int k = next(occluderCount, LIMIT(kMaxOccluders));
            occluder[0][k] = s.centre.x, occluder[1][k] = s.centre.y, occluder[2][k] = s.centre.z;
            occluderRadius[k] = s.half.x;
            occluderShape[k] = (uint16_t)i;
        }
    }
    buildTree(*this, bounded);
    for (int i = 0; i < materialCount; ++i) mean[i] = meanAlbedo(materials[i]) * materials[i].diffuse;
}

} // namespace odraz
