#include "show/daylight.h"

#include "base/maths.h"

namespace odraz {

namespace {

struct SunAndSky {
    // The sun's angles in degrees: from the windows' normal towards the entrance, and upwards
    float azimuth, elevation;
    Rgb sunlight;
    Rgb low, high, glow; // the sky at the horizon, above, and around the sun
};
// Rows in the enum's order
constexpr SunAndSky kDay[] = {
    [kSunrise] =
        {62, 9, {0.24f, 0.2f, 0.2f}, {0.04f, 0.13f, 0.34f}, {0.02f, 0.12f, 0.48f}, {0.7f, 0.15f, 0.06f}},
    [kMorning] =
        {40, 24, {1.9f, 1.2f, 0.6f}, {0.16f, 0.31f, 0.66f}, {0.05f, 0.14f, 0.48f}, {0.26f, 0.26f, 0.26f}},
    [kForenoon] =
        {22, 38, {3.5f, 2.6f, 1.7f}, {0.16f, 0.34f, 0.76f}, {0.05f, 0.14f, 0.6f}, {0.3f, 0.28f, 0.24f}},
    [kNoon] = {0, 45, {3.6f, 2.7f, 1.75f}, {0.16f, 0.34f, 0.76f}, {0.05f, 0.14f, 0.6f}, {0.3f, 0.28f, 0.24f}},
    [kAfternoon] =
        {-24, 36, {3.5f, 2.5f, 1.5f}, {0.18f, 0.34f, 0.72f}, {0.05f, 0.13f, 0.55f}, {0.3f, 0.26f, 0.22f}},
    [kEvening] =
        {-42, 20, {2.9f, 2.05f, 1.3f}, {0.36f, 0.26f, 0.17f}, {0.1f, 0.15f, 0.32f}, {0.6f, 0.36f, 0.2f}},
    [kSunset] =
        {-49, 8, {1.8f, 1.1f, 0.75f}, {0.35f, 0.18f, 0.09f}, {0.12f, 0.24f, 0.54f}, {0.6f, 0.32f, 0.18f}},
    [kNight] = {-52, 1, {}, {0.003f, 0.008f, 0.022f}, {0.003f, 0.01f, 0.03f}, {}},
};
static_assert(sizeof kDay / sizeof *kDay == kHours);

SunAndSky between(const SunAndSky &a, const SunAndSky &b, float t) {
    return {lerp(a.azimuth, b.azimuth, t), lerp(a.elevation, b.elevation, t), lerp(a.sunlight, b.sunlight, t),
            lerp(a.low, b.low, t),         lerp(a.high, b.high, t),           lerp(a.glow, b.glow, t)};
}

} // namespace

Daylight daylightAt(float hour) {
    int before = min(max((int)hour, 0), kHours - 2);
    SunAndSky h = between(kDay[before], kDay[before + 1], hour - (float)before);
    float a = h.azimuth * (kPi / 180), e = h.elevation * (kPi / 180);
    Vec3 sun = {-cos(e) * cos(a), sin(e), cos(e) * sin(a)};
    Rgb ground = h.low * 0.35f + h.sunlight * (0.07f * max(sun.y, 0.f));
    return {{h.low, (h.high - ground) * 0.5f, (h.high + ground) * 0.5f - h.low, -1, sun, h.glow * 0.25f,
             h.glow, h.low * 0.8f + h.sunlight * 0.11f, 0.1f, hour * 0.7f},
            sun * 300.f,
            h.sunlight + h.glow * kNearGlow};
}

} // namespace odraz
