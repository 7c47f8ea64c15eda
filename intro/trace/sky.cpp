#include "trace/sky.h"

#include "base/maths.h"

namespace odraz {

Rgb8 radiance(const Sky &sky, const Vec3x8 &d) {
    Float8 up = saturate(d.y);
    Rgb8 light = broadcast(sky.low) + (sky.high - sky.low) * (up * (2.f - up));
    // The ground begins softly: haze
    light += (sky.ground - sky.low) * smoothstep(0.f, 0.08f, -d.y);
    if (maxComponent(sky.glow) > 0) {
        Float8 towards = max(dot(d, sky.sun), 0.f), square = towards * towards;
        Float8 wide = square * square, near = wide * wide;
        near = near * near * near * near;
        near = near * near;
        light += sky.glow * (wide * 0.25f + near) * select(d.y > 0.f, 1.f, 0.3f);
    }
    return light;
}

} // namespace odraz
