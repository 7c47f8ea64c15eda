#include "trace/lightmap.h"

namespace odraz {

static Float8 along(Vec3 axis, Vec3x8 p, float perUnit) { return dot(p, axis) * perUnit; }

Rgb8 lightAt(const Lightmap &map, const Chart &c, const Vec3x8 &p) {
    // Element middles lie at whole numbers, the ring's at 0 and across + 1
    Vec3x8 q = p - c.corner;
    Float8 x = along(c.u, q, (float)c.across / c.width) + 0.5f,
           y = along(c.v, q, (float)c.down / c.height) + 0.5f;
    x = clamp(x, 0.5f, (float)c.across + 0.5f);
    y = clamp(y, 0.5f, (float)c.down + 0.5f);
    Int8 i = toInt(x), j = toInt(y);
    auto sharpen = [&](Float8 f) { return saturate(fmadd(f - 0.5f, map.sharpness, 0.5f)); };
    Float8 fx = sharpen(x - toFloat(i)), fy = sharpen(y - toFloat(j));
    Int8 texel = j * c.stride() + i + c.firstTexel;
    auto channel = [&](const float *plane) {
        auto row = [&](Int8 at) {
            Float8 left = gather(plane, at), right = gather(plane, at + 1);
            return fmadd(fx, right - left, left);
        };
        Float8 upper = row(texel), lower = row(texel + c.stride());
        return fmadd(fy, lower - upper, upper);
    };
    return {channel(map.plane[0]), channel(map.plane[1]), channel(map.plane[2])};
}

Int8 patchAt(const Chart &c, const Vec3x8 &p, Float8 width, Float8 &clear) {
    Vec3x8 q = p - c.corner;
    float perU = (float)c.patchesAcross() / c.width, perV = (float)c.patchesDown() / c.height;
    Float8 x = along(c.u, q, perU), y = along(c.v, q, perV);
    // A line is a fixed width, or what a sample sees of it
    static constexpr float kHalf = 0.008f;
    auto off = [&](Float8 x, float perUnit) {
        Float8 distance = abs(x - round(x)) * (1.f / perUnit);
        Float8 wide = max(width, 2.f * kHalf);
        Float8 cover = saturate((kHalf + wide * 0.5f - distance) / wide) * (2.f * kHalf / wide);
        return 1.f - cover;
    };
    clear = off(x, perU) * off(y, perV);
    Int8 i = toInt(clamp(x, 0.f, (float)c.patchesAcross() - 0.5f)),
         j = toInt(clamp(y, 0.f, (float)c.patchesDown() - 0.5f));
    return j * c.patchesAcross() + i + c.firstPatch;
}

} // namespace odraz
