#include "trace/scene/lightmap.h"

namespace odraz {

static Float8 along(Vec3 axis, Vec3x8 p, float perUnit) { return dot(p, axis) * perUnit; }

// Interpolates bilinearly between four values.
template <class Corner>
static Rgb8 bilinear(const float *const plane[3], Float8 x, Float8 y, Corner &&corner) {
    Int8 at[4] = {corner(0), corner(1), corner(2), corner(3)};
    auto channel = [&](const float *values) {
        auto row = [&](int k) {
            Float8 left = gather(values, at[k]), right = gather(values, at[k + 1]);
            return fmadd(x, right - left, left);
        };
        Float8 upper = row(0), lower = row(2);
        return fmadd(y, lower - upper, upper);
    };
    return {channel(plane[0]), channel(plane[1]), channel(plane[2])};
}

// The colours of patches, interpolated between their centres. `plane` holds them in rows of `across`.
static Rgb8 mosaicAt(const float *const plane[3], int across, int down, float sharpness, const Chart &c,
                     const Vec3x8 &q) {
    auto neighbours = [&](Vec3 axis, float size, int count, Int8 &low, Int8 &high) {
        Float8 x = clamp(along(axis, q, (float)count / size) - 0.5f, 0.f, (float)(count - 1));
        low = toInt(x);
        high = select(low < count - 1, low + 1, low);
        return saturate(fmadd(x - toFloat(low) - 0.5f, sharpness, 0.5f));
    };
    Int8 i[2], j[2];
    Float8 x = neighbours(c.u, c.width, across, i[0], i[1]), y = neighbours(c.v, c.height, down, j[0], j[1]);
    return bilinear(plane, x, y, [&](int k) { return j[k >> 1] * across + i[k & 1]; });
}

Rgb8 lightAt(const Lightmap &map, const Chart &c, const Vec3x8 &p) {
    Vec3x8 q = p - c.corner;
    Float8 x = clamp(along(c.u, q, (float)c.across / c.width), 0.f, (float)c.across),
           y = clamp(along(c.v, q, (float)c.down / c.height), 0.f, (float)c.down);
    Int8 i = toInt(min(x, (float)c.across - 0.5f)), j = toInt(min(y, (float)c.down - 0.5f));
    x -= toFloat(i), y -= toFloat(j);
    Int8 corner = j * (c.across + 1) + i + c.firstTexel;
    Rgb8 light =
        bilinear(map.plane, x, y, [&](int k) { return corner + ((k & 1) + (k >> 1) * (c.across + 1)); });
    if (map.mosaic > 0) {
        const float *const plane[3] = {map.patch[0] + c.firstPatch, map.patch[1] + c.firstPatch,
                                       map.patch[2] + c.firstPatch};
        light = light + (mosaicAt(plane, c.patchesAcross, c.patchesDown, map.sharpness, c, q) - light) *
                            broadcast(map.mosaic);
    }
    return light;
}

Rgb8 glossAt(const Lightmap &map, const Vec3x8 &p) {
    return mosaicAt(map.gloss, map.glossAcross, map.glossDown, 1, *map.glossy, p - map.glossy->corner);
}

Int8 patchAt(const Chart &c, const Vec3x8 &p, const Vec3x8 &d, Float8 cosine, Float8 width, Float8 &clear) {
    Vec3x8 q = p - c.corner;
    float perU = (float)c.patchesAcross / c.width, perV = (float)c.patchesDown / c.height;
    Float8 x = along(c.u, q, perU), y = along(c.v, q, perV);
    // Along each axis, find the share of an ellipse that a line covers. The ellipse is stretched along the
    // view. It is twice as wide as the sample, or lines would have stairs, and sparks where they cross
    static constexpr float kHalf = 0.01f;
    Float8 stretch = 1.f / max(cosine, 0.02f);
    auto cover = [&](Float8 x, float perUnit, Vec3 axis) {
        Float8 distance = abs(x - round(x)) * (1.f / perUnit), slant = dot(d, axis) * stretch;
        Float8 half = max(width * sqrt(fmadd(slant, slant, 1.f)), 1e-4f);
        return min((kHalf + half - distance) * 0.5f, min(half, broadcast(kHalf))) / half;
    };
    clear = 1.f - max(max(cover(x, perU, c.u), cover(y, perV, c.v)), 0.f);
    Int8 i = toInt(clamp(x, 0.f, (float)c.patchesAcross - 0.5f)),
         j = toInt(clamp(y, 0.f, (float)c.patchesDown - 0.5f));
    return j * c.patchesAcross + i + c.firstPatch;
}

} // namespace odraz
