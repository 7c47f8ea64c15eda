#include "trace/shade/soft_shadow.h"

namespace odraz {

void findBlockers(const Scene &scene, const Light &light, const Bounds &box, Blockers &found) {
    found.count = 0;
    Vec3 middle = (box.lo + box.hi) * 0.5f, axis = middle - light.position;
    float reach = length(box.hi - middle) + light.radius, distance = length(axis);
    axis = axis * (1 / max(distance, 1e-9f));
    for (int i = 0; i < scene.occluderCount; i += 8) {
        Vec3x8 to = load(scene.occluder, i) - light.position;
        Float8 along = dot(to, axis), wide = load(scene.occluderRadius + i) + reach;
        Vec3x8 across = to - axis * along;
        Int8 mayBlock = (along > -wide) & (along < distance + wide) & (dot(across, across) < wide * wide) &
                        (kLanes < scene.occluderCount - i);
        for (int lanes = laneBits(mayBlock); lanes; lanes &= lanes - 1)
            found.ball[found.count++] = (uint8_t)(i + __builtin_ctz((unsigned)lanes));
    }
}

Rgb8 softShadow(const Scene &scene, const Blockers &blockers, const Light &light, const Vec3x8 &p,
                const Vec3x8 &l, Float8 distance, Int8 ignored) {
    constexpr float kPassing = 0.84f;  // share of light that passes a glass ball, by Fresnel's equations
    constexpr float kHorn = 0.7f;      // h at the ball's centre, in squared radii
    constexpr float kMinSpot = 0.003f; // least blur, in squared radii
    Rgb8 share = broadcast(Rgb{1, 1, 1});
    Float8 widening = light.radius / distance;
    for (int i = 0; i < blockers.count; ++i) {
        int k = blockers.ball[i], shape = scene.occluderShape[k];
        float r = scene.occluderRadius[k];
        Vec3x8 to = {scene.occluder[0][k] - p.x, scene.occluder[1][k] - p.y, scene.occluder[2][k] - p.z};
        Float8 along = dot(to, l);
        Vec3x8 across = to - l * along;
        // Project the lamp's disc to the ball's distance
        Float8 lamp = max(along * widening, 1e-3f * r), square = dot(across, across), reach = lamp + r;
        Int8 meets = (along > 0.f) & (along < distance) & (ignored != shape) & (square < reach * reach);
        if (!any(meets)) continue;
        Float8 smaller = min(lamp, broadcast(r)), ratio = r / lamp,
               x = saturate((reach - sqrt(square)) * 0.5f / smaller);
        // Compute the overlap: a smooth step for discs of very different size, nearly a line for equal ones
        Float8 step = x * x * fmadd(x, -2.f, 3.f), even = smaller / max(lamp, broadcast(r));
        Float8 hidden =
            fmadd(fmadd(x, fmadd(x, 0.45f, 0.55f), -step), even, step) * min(ratio * ratio, broadcast(1.f));
        const Material &m = scene.materials[scene.shapes[shape].material];
        Rgb8 left = broadcast(Rgb{1, 1, 1}) * (1.f - hidden);
        if (m.ior > 0) {
            // Add the caustic. `before`: how far the point is before the focus of the rays near the axis, as
            // a share of the focus's distance from the ball. The nearer the lamp, the farther that focus
            Float8 before = fmadd(along * (1.f - along / distance), (m.ior - 1) * -2.f / (m.ior * r), 1.f),
                   narrow = max(before, 0.f), fold = narrow * narrow * narrow * kHorn,
                   beyond = max(fmadd(before, -0.9f, 0.09f), 0.f), blur = lamp * (0.7f / r);
            Float8 soft = fmadd(fmadd(beyond, beyond, fmadd(blur, blur, broadcast(kMinSpot))), 0.5f,
                                sqrt(fold) * blur),
                   off = fmadd(square, -1 / (r * r), fold), soft2 = soft * soft,
                   size = sqrt(fmadd(off, off, soft2));
            Float8 gain = sqrt((size + off) / (sqrt(fmadd(fold, fold, soft2)) + fold)) / size * hidden *
                          (0.5f * kPassing);
            left += m.tint * gain;
        }
        share = select(meets, share * left, share);
    }
    return share;
}

} // namespace odraz
