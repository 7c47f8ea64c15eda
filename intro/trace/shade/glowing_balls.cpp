#include "trace/shade/glowing_balls.h"

#include "trace/shade/contribute.h"

namespace odraz {

// The greatest brightness of a widened image, in multiples of white. A brighter one would stay white even
// where the ball is too small to be seen.
static constexpr float kMaxBrightness = 6;

void addGlowingBalls(const Shading &c, const RayStream &in) {
    const Scene &scene = c.scene;
    const float bound = (c.bounces ? 1 : kMaxBrightness) / scene.exposure;
    for (int i = 0; i < in.count; i += 8) {
        Ray8 ray = {load(in.o, i), load(in.d, i)};
        Rgb8 light = {}, weight = load(in.weight, i);
        Int8 found = {};
        Uint8 marks = {};
        for (int k = 0; k < scene.glowingBallCount; ++k) {
            const Shape &s = scene.shapes[scene.glowingBall[k]];
            float r = s.half.x;
            Vec3x8 to = s.centre - ray.o;
            Float8 along = dot(to, ray.d), across2 = dot(to, to) - along * along;
            // Widen the image by a filter that is 1.5 times as wide as the sample there
            Float8 wide = fmadd(load(in.spread + i), along, load(in.width + i)) * 1.5f, square = wide * wide;
            Float8 reach = fmadd(square, 4.f, r * r);
            Float8 root = sqrt(reach), margin = fmadd(wide, c.quality.coarse * 0.36f, root);
            Int8 near = (along > 0.f) & (along - r * 1.01f < load(in.t + i)) & (across2 < margin * margin);
            if (!any(near)) continue;
            found |= near;
            Float8 cover = saturate((reach - across2) / (wide * root * 2.f));
            cover *= r * r / fmadd(square, 2.f, r * r);
            Rgb8 all = weight * scene.materials[s.material].emit;
            Float8 most = fmadd(r * r / square, bound, broadcast(bound));
            all = {min(all.x, most), min(all.y, most), min(all.z, most)};
            light += select(near, all * cover, Rgb8{});
            Int8 shows = near & (maxComponent(all) * scene.exposure > c.quality.markWeight);
            marks += (Uint8)shows & ((Uint8)loadInts(in.path + i) * 0x9e3779b1u + (uint32_t)k);
        }
        int32_t rays[8];
        store(rays, kLanes + i);
        if (c.samples.whole) marks = marks * (kLamps + 1) | ((Uint8)(marks != 0u) & 1u);
        if (any(found)) addLight(c, in, rays, min(in.count - i, 8), light, (Int8)marks);
    }
}

} // namespace odraz
