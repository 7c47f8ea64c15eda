#include "trace/scene/material.h"

namespace odraz {

// The mean of a square wave over a width. The wave has period 1 and is +1 in [0, 1/2), -1 in [1/2, 1).
ODRAZ_INLINE static Float8 squareWave(Float8 x, Float8 halfWidth, Float8 perWidth) {
    auto integral = [](Float8 x) { return abs(x - round(x)); };
    return (integral(x + halfWidth) - integral(x - halfWidth)) * perWidth;
}

Rgb8 albedo(const Material &m, const Vec3x8 &q, const Vec3x8 &d, Float8 cosine, Float8 width, Int8 &cell) {
    Float8 stretch = 1.f / max(cosine, 0.02f);
    Float8 root = sqrt(stretch), meanWidth = width * root * sqrt(root);
    cell = Int8{};
    if (m.cell == 0) return colour(m.texture, q, meanWidth);

    // The sample's footprint is an ellipse that is long along the view: a circle across the view, projected
    // along d. Along the ellipse both waves change together, and the mean of a product is not the product of
    // means. So the mean is taken in parts
    constexpr float kParts = 3;
    stretch *= 1 / kParts;
    const float perPair = 0.5f / m.cell;
    Float8 x = q.x * perPair, z = q.z * perPair, narrow = width * perPair;
    Float8 alongX = d.x * stretch, alongZ = d.z * stretch;
    auto half = [&](Float8 along) { return max(narrow * sqrt(fmadd(along, along, 1.f)) * 0.5f, 2e-5f); };
    Float8 halfX = half(alongX), halfZ = half(alongZ), perX = 0.5f / halfX, perZ = 0.5f / halfZ, sum = {};
    alongX *= narrow, alongZ *= narrow;
    for (float part = 0.5f - kParts * 0.5f; part < kParts * 0.5f; ++part)
        sum +=
            squareWave(fmadd(alongX, part, x), halfX, perX) * squareWave(fmadd(alongZ, part, z), halfZ, perZ);
    // Exceed 0 .. 1 a little before clamping, so that rounding errors do not mix two textures inside a cell
    Float8 even = saturate(fmadd(sum, 0.504f / kParts, 0.5f));
    Int8 sharp = fmadd(max(abs(alongX), abs(alongZ)), kParts, narrow) < 0.5f;
    auto number = [](Float8 x) { return toInt(floor(clamp(x * 2.f, -1e6f, 1e6f))); };
    cell = (number(x) * 73 + number(z) * 1031 + 1) & sharp;

    Rgb8 result = {};
    if (any(even > 0.f)) result = colour(m.texture, q, meanWidth) * even;
    if (any(even < 1.f)) result += colour(m.other, q, meanWidth) * (1.f - even);
    return result;
}

Rgb meanAlbedo(const Material &m) {
    return m.cell == 0 ? meanColour(m.texture) : (meanColour(m.texture) + meanColour(m.other)) * 0.5f;
}

} // namespace odraz
