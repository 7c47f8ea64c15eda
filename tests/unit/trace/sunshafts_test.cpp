// Compares shafts of sunlight with sums over many points along rays.
#include "trace/shade/sunshafts.h"

#include "base/maths.h"
#include "tests/support/dice.h"
#include "trace/texture/noise.h"

using namespace odraz;

static Sunshafts shaftsBy(Vec3 sun) {
    Sunshafts s = {};
    s.sun = normalize(sun);
    s.room = {{-4, 0, -9}, {4, 6, 9}};
    s.low = 1.5f, s.high = 5;
    for (float z : {-6.f, -2.f, 2.f}) s.from[s.openings] = z, s.to[s.openings++] = z + 1;
    for (float z : {-4.f, 0.f, 3.f}) s.pillarX[s.pillars] = -2, s.pillarZ[s.pillars++] = z;
    s.pillarRadius = 0.3f;
    s.scatter = {1, 1, 1};
    return s;
}

static bool lit(const Sunshafts &s, Vec3 p) {
    const Bounds &r = s.room;
    if (p.x < r.lo.x || p.x > r.hi.x || p.y < r.lo.y || p.y > r.hi.y || p.z < r.lo.z || p.z > r.hi.z)
        return false;
    Vec3 at = p + s.sun * ((r.lo.x - p.x) / s.sun.x);
    bool open = false;
    for (int i = 0; i < s.openings; ++i) open |= at.z > s.from[i] && at.z < s.to[i];
    if (!open || at.y < s.low || at.y > s.high) return false;
    for (int k = 0; k < s.pillars; ++k) {
        // `off`: the distance of the pillar's axis from the line to the sun, seen from above
        float x = s.pillarX[k] - p.x, z = s.pillarZ[k] - p.z;
        float off = (x * s.sun.z - z * s.sun.x) / std::hypot(s.sun.x, s.sun.z);
        if (x < 0 && std::fabs(off) < s.pillarRadius) return false;
    }
    return true;
}

// Expects a result between the sums for the thinnest and the thickest dust.
static void expectSum(const Sunshafts &s, Vec3 o, Vec3 towards, float hit) {
    Vec3 d = normalize(towards);
    constexpr int kSteps = 20000;
    double sum = 0, end = std::fmin(hit, 60.f);
    for (int i = 0; i < kSteps; ++i) sum += lit(s, o + d * (float)((i + 0.5) * end / kSteps));
    sum *= end / kSteps;
    double half = 0.5 + 0.5 * dot(d, s.sun), phase = 0.6 + 1.0 * half * half;
    float got = shaftLight(s, broadcast(o), broadcast(d), broadcast(hit)).x[0];
    ASSERT_TRUE(std::isfinite(got));
    EXPECT_GE(got, (sum * 0.4 - 0.02) * phase) << o.x << ' ' << o.y << ' ' << o.z;
    EXPECT_LE(got, (sum * 1.6 + 0.02) * phase) << d.x << ' ' << d.y << ' ' << d.z;
}

TEST(Sunshafts, AreAsLongAsTheyAreLit) {
    Dice dice(1);
    for (Vec3 sun : {Vec3{-1, 0.7f, 0}, {-1, 0.3f, 1.5f}, {-0.3f, 0.2f, -0.8f}})
        for (int i = 0; i < 200; ++i)
            expectSum(shaftsBy(sun), Vec3{0, 3, 0} + dice.point(1) * Vec3{3.9f, 2.9f, 8}, dice.point(1),
                      dice(0, 1) < 0.3f ? kInfinity : dice(0, 12));
}

TEST(Sunshafts, AreRightAtTheExtremes) {
    Sunshafts s = shaftsBy({-1, 0.5f, 0.25f});
    Vec3 inside = Vec3{-4, 3, 2.5f} - s.sun * 2.f;
    expectSum(s, inside, s.sun, 1e9f); // along the sun
    expectSum(s, inside, s.sun * -1.f, 1e9f);
    expectSum(s, {0, 5.9f, 8.9f}, s.sun, 1e9f); // next to all shafts
    expectSum(s, inside, {0, 0, 1}, 1e9f);
    expectSum(s, inside, {0, 1, 0}, 1e9f);
    expectSum(s, inside, {1, 0, 0}, 1e9f);
    expectSum(s, {-12, 8, 0}, {1, -0.6f, 0.1f}, 1e9f); // from outside
    expectSum(s, {-4, 3, -9}, {0, 0, 1}, 1e9f);        // in the wall itself
    expectSum(s, inside, {1, 0, 0}, 0);
    s.openings = 0;
    expectSum(s, inside, {0, 0, 1}, 1e9f);
}
