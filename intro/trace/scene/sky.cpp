#include "trace/scene/sky.h"

#include "base/maths.h"
#include "trace/texture/noise.h"

namespace odraz {

Sky plainSky(const Rgb &low, const Rgb &high) {
    return {low, (high - low) * 2.f, low - high, 0, {0, 1, 0}, {}, {}, {}, 0, 0};
}

Rgb8 radiance(const Sky &sky, const Vec3x8 &d, float width, Float8 spread) {
    Float8 y = max(d.y, sky.least);
    Rgb8 light = fmadd(fmadd(broadcast(sky.curve), y, broadcast(sky.slope)), y, broadcast(sky.low));
    if (maxComponent(sky.glow) > 0) {
        auto toFourth = [](Float8 x) {
            x = x * x;
            return x * x;
        };
        // The near glow, towards^64, is about exp(64 (towards - 1)): scaling the difference widens it
        Float8 towards = dot(d, sky.sun), share = 1.f / fmadd(spread * spread, 128.f, 1.f),
               near = max(fmadd(towards - 1.f, share, 1.f), 0.f);
        light += sky.glow * toFourth(fmadd(towards, 0.5f, 0.5f)) +
                 sky.near * (toFourth(toFourth(toFourth(near))) * share);
    }
    if (sky.cover > 0) {
        // Add a layer of clouds, which ends in haze at the horizon; fine detail fades before that
        Float8 up = max(d.y, 0.f), distance = 3.f / (up + 0.12f), at = distance * sky.cloudScale;
        Float8 density = fractalNoise({fmadd(d.x, at, sky.drift), broadcast(sky.drift * 0.3f), d.z * at}, 3,
                                      distance * width);
        density = smoothstep(0.f, 1.f, density + sky.cover) * smoothstep(0.f, 0.16f, up);
        light += (broadcast(sky.clouds) - light) * density;
    }
    return light;
}

} // namespace odraz
