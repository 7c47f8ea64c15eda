#include "show/daylight.h"

#include "base/maths.h"

namespace odraz {

namespace {

// {sun's angle from the windows' normal towards the entrance, its height, sunlight, sky: low, high, glow};
// degrees
struct Hour {
    float aside, height;
    Rgb sunlight, low, high, glow;
};
constexpr Hour kDay[kHours] = {
    {62, 9, {2.4f, 1.3f, 0.65f}, {0.38f, 0.21f, 0.16f}, {0.06f, 0.09f, 0.22f}, {0.8f, 0.42f, 0.18f}},
    {44, 24, {3.7f, 3.0f, 2.2f}, {0.30f, 0.36f, 0.44f}, {0.06f, 0.14f, 0.38f}, {0.4f, 0.32f, 0.22f}},
    {22, 38, {4.1f, 3.7f, 3.1f}, {0.25f, 0.36f, 0.52f}, {0.06f, 0.15f, 0.42f}, {0.3f, 0.28f, 0.24f}},
    {0, 45, {4.2f, 3.8f, 3.2f}, {0.24f, 0.36f, 0.54f}, {0.06f, 0.15f, 0.42f}, {0.3f, 0.28f, 0.24f}},
    {-24, 36, {4.1f, 3.6f, 2.9f}, {0.26f, 0.36f, 0.50f}, {0.06f, 0.14f, 0.40f}, {0.3f, 0.26f, 0.22f}},
    {-44, 20, {3.7f, 2.6f, 1.5f}, {0.28f, 0.24f, 0.25f}, {0.06f, 0.10f, 0.28f}, {0.6f, 0.38f, 0.2f}},
    {-60, 7, {2.6f, 1.2f, 0.5f}, {0.36f, 0.15f, 0.09f}, {0.05f, 0.06f, 0.17f}, {0.9f, 0.38f, 0.13f}},
    {-62, 1, {}, {0.03f, 0.04f, 0.075f}, {0.01f, 0.018f, 0.045f}, {}},
};

Hour between(const Hour &a, const Hour &b, float t) {
    return {lerp(a.aside, b.aside, t), lerp(a.height, b.height, t), lerp(a.sunlight, b.sunlight, t),
            lerp(a.low, b.low, t),     lerp(a.high, b.high, t),     lerp(a.glow, b.glow, t)};
}

} // namespace

Daylight daylightAt(float hour) {
    int before = min(max((int)hour, 0), kHours - 2);
    Hour h = between(kDay[before], kDay[before + 1], hour - (float)before);
    float a = h.aside * (kPi / 180), e = h.height * (kPi / 180);
    Vec3 sun = {-cos(e) * cos(a), sin(e), cos(e) * sin(a)};
    Rgb ground = h.low * 0.35f + h.sunlight * (0.07f * max(sun.y, 0.f));
    return {{h.low, (h.high - ground) * 0.5f, (h.high + ground) * 0.5f - h.low, -1, sun, h.glow * 0.25f,
             h.glow, h.low * 0.8f + h.sunlight * 0.11f, 0.1f, hour * 0.7f},
            sun * 300.f,
            h.sunlight + h.glow * kNearGlow};
}

} // namespace odraz
