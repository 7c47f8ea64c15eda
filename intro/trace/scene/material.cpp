#include "trace/scene/material.h"

namespace odraz {

// The average of a square wave (+1 on even cells, -1 on odd ones) over [x - w/2, x + w/2]. Stretched a
// little, so that roundings leave the inside of a cell pure: the other one's texture need not be asked there.
ODRAZ_INLINE static Float8 squareWave(Float8 x, Float8 w) {
    auto integral = [](Float8 x) {
        Float8 folded = x - floor(x * 0.5f) * 2.f;
        return 1.f - abs(folded - 1.f);
    };
    w = max(w, 1e-4f);
    return clamp((integral(x + w * 0.5f) - integral(x - w * 0.5f)) * 1.004f / w, -1.f, 1.f);
}

Rgb8 albedo(const Material &m, const Vec3x8 &q, const Vec3x8 &d, Float8 cosine, Float8 width, Int8 &cell) {
    Float8 stretch = 1.f / max(cosine, 0.02f);
    Float8 root = sqrt(stretch), mean = width * root * sqrt(root);
    cell = Int8{};
    if (m.cell == 0) return colour(m.texture, q, mean);

    // The sample's footprint is an ellipse, long along the view: a circle across it, and its shadow along d
    Float8 x = q.x * (1.f / m.cell), z = q.z * (1.f / m.cell), narrow = width * (1.f / m.cell);
    Float8 alongX = d.x * stretch, alongZ = d.z * stretch;
    Float8 wx = narrow * sqrt(fmadd(alongX, alongX, 1.f)), wz = narrow * sqrt(fmadd(alongZ, alongZ, 1.f));
    Float8 even = fmadd(squareWave(x, wx) * squareWave(z, wz), 0.5f, 0.5f);
    Int8 sharp = max(wx, wz) < 1.f;
    cell =
        (toInt(floor(clamp(x, -1e6f, 1e6f))) * 73 + toInt(floor(clamp(z, -1e6f, 1e6f))) * 1031 + 1) & sharp;

    Rgb8 result = {};
    if (any(even > 0.f)) result = colour(m.texture, q, mean) * even;
    if (any(even < 1.f)) result += colour(m.other, q, mean) * (1.f - even);
    return result;
}

Rgb meanAlbedo(const Material &m) {
    return m.cell == 0 ? meanColour(m.texture) : (meanColour(m.texture) + meanColour(m.other)) * 0.5f;
}

} // namespace odraz
