// Tests the tracer at the limits of floats, against the same rays in double precision: far and near, large
// and small, grazing, starting on and inside surfaces, nested and coincident, sixty-four bounces, light on
// surfaces.
#include "base/maths.h"
#include "tests/support/dice.h"
#include "tests/support/figure.h"
#include "tests/support/traced_ray.h"
#include "tools/support/vec3d.h"

using namespace odraz;

static Vec3 lane(const Vec3x8 &v) { return {v.x[0], v.y[0], v.z[0]}; }

static Material plain(float diffuse) {
    Material m = matte({1, 1, 1});
    m.diffuse = diffuse;
    return m;
}

// Rays start one to a million radii away and pass at every distance from the middle, most of them near the
// edge. A ray counts as misjudged if the oracle, which gets the same floats, disagrees and half a unit in the
// last place of the coordinates could not move the ray across the edge. The usual b^2 - c misjudges rays that
// are far from the edge.
TEST(Extremes, BallsAreHitOrMissedAsInDouble) {
    Dice dice(5);
    for (float ratio : {1.f, 2.f, 10.f, 100.f, 1e3f, 1e4f, 1e5f, 1e6f}) {
        int wrong = 0;
        for (float radius : {1e-4f, 1e-2f, 1.f, 1e2f, 1e4f, 1e6f})
            for (int i = 0; i < 3000 && ratio * radius < 1e8f; ++i) {
                Vec3 towards = dice.direction(), o = towards * (-ratio * radius * 1.0001f);
                float graze =
                    i % 3 == 0 ? dice(0, 2) : 1 + std::pow(10.f, dice(-6, -1)) * (i & 1 ? 1.f : -1.f);
                Vec3 to = dice.perpendicular(towards) * (radius * graze);
                Vec3 d = normalize(to - o);
                Shape s = sphere({0, 0, 0}, radius, 0);
                float alone = distance(s, {broadcast(o), broadcast(d)})[0];
                Vec3d f = toDouble(o), v = toDouble(d);
                double unit = length(v), b = -dot(f, v) / unit,
                       near = std::sqrt(std::fmax(dot(f, f) - b * b, 0));
                bool hits = near <= radius && b > 0, misjudged = (alone < kInfinity) != hits;
                double doubt = length(f) * 4e-7, aside = std::fabs(near - radius);
                // The rounding error across the surface, divided by the cosine along the ray
                double root = std::sqrt(std::fmax(radius * radius - near * near, 0));
                if (alone < kInfinity && root > 0) {
                    ASSERT_NEAR(alone, (b - root) / unit, doubt * (2 + 2 * radius / root)) << ratio;
                }
                if (aside <= doubt * 0.15) continue;
                wrong += misjudged;
                ASSERT_FALSE(misjudged && aside > doubt) << ratio << " " << radius;
            }
        if (ratio <= 1e4f) expectAtMost(testing::PrintToString(ratio) + " radii away: misjudged", wrong, 0);
    }
}

TEST(Extremes, BeamsHitWhatRaysHit) {
    Dice dice(5);
    auto scene = std::make_unique<Scene>();
    for (float ratio : {1.5f, 10.f, 1e3f, 1e4f, 1e6f})
        for (float radius : {1e-4f, 1.f, 1e4f})
            for (int i = 0; i < 500 && ratio * radius < 1e8f; ++i) {
                scene->clear();
                scene->add(Material{});
                Vec3 towards = dice.direction(), o = towards * (-ratio * radius);
                scene->add(sphere({0, 0, 0}, radius, 0));
                scene->finish();
                Vec3x8 d;
                for (int k = 0; k < 8; ++k) {
                    float graze = 1 + std::pow(10.f, dice(-6, 0)) * (k & 1 ? 1.f : -1.f);
                    setLane(d, k, normalize(dice.perpendicular(towards) * (radius * graze) - o));
                }
                BeamBuilder builder(o, towards);
                builder.add(d * broadcast(3 * ratio * radius));
                if (!builder.narrow()) continue;
                Candidates candidates;
                findCandidates(*scene, builder.beam(), candidates);
                Hit8 shared = intersect(*scene, candidates, o, d, kLanes >= 0),
                     alone = intersect(*scene, {broadcast(o), d}, kLanes >= 0);
                for (int k = 0; k < 8; ++k) {
                    ASSERT_EQ(shared.shape[k], alone.shape[k]) << ratio << " " << radius;
                    ASSERT_EQ(shared.t[k], alone.t[k]) << ratio << " " << radius;
                }
            }
}

// A ray that leaves on the side from which it came never hits the same ball again; a ray that goes inside
// hits the far side.
TEST(Extremes, RaysLeaveTheSurfacesThatTheyStartOn) {
    Dice dice(5);
    for (float radius : {1e-4f, 1.f, 1e3f, 1e6f})
        for (float away : {0.f, 1.f, 1e3f})
            for (int i = 0; i < 4000; ++i) {
                Vec3 centre = dice.direction() * (away * radius);
                Shape s = sphere(centre, radius, 0);
                Vec3 o = centre + dice.direction() * (radius * 3);
                Vec3 to = centre + dice.direction() * (radius * dice(0, 0.999f));
                Ray8 r = {broadcast(o), broadcast(normalize(to - o))};
                Float8 t = distance(s, r);
                if (!(t[0] < kInfinity)) continue;
                Surface8 at = surfaceAt(s, r, t);
                Vec3 n = lane(at.n), d = dice.direction();
                float grazing = std::pow(10.f, dice(-4, 0));
                Vec3 out = normalize(dice.perpendicular(n) + n * grazing),
                     in = normalize(d - n * (dot(d, n) + grazing));
                ASSERT_EQ(distance(s, {offsetOrigin(s, at, broadcast(1.f)), broadcast(out)})[0], kInfinity)
                    << radius << " " << away << " " << grazing;
                float inside = distance(s, {offsetOrigin(s, at, broadcast(-1.f)), broadcast(in)})[0];
                ASSERT_LT(inside, kInfinity) << radius << " " << away << " " << grazing;
                double chord = -2 * (double)dot(in, n) * radius;
                double moved = (double)errorBound(at.p, broadcast(magnitude(s)))[0];
                ASSERT_NEAR(inside, chord, 1e-3 * radius + 4 * moved / grazing) << grazing;
            }
}

// Compares a path inside a mirrored ball with the same path in double precision: even after sixty-four
// bounces chords have equal length, points lie on the ball, and directions have unit length.
TEST(Extremes, SixtyFourBouncesStayTrue) {
    Dice dice(5);
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
        Shape s = sphere({0.3f, -0.2f, 0.1f}, 1.5f, 0);
        Vec3 o = s.centre, d = dice.direction();
        o = o + dice.direction() * 0.9f;
        Ray8 r = {broadcast(o), broadcast(d)};
        Vec3d p = toDouble(o) - toDouble(s.centre), v = toDouble(d) * (1 / length(toDouble(d)));
        for (int bounce = 0; bounce < 64; ++bounce) {
            Float8 t = distance(s, r);
            ASSERT_LT(t[0], kInfinity) << bounce;
            Surface8 at = surfaceAt(s, r, t);
            r.d = normalize(fmadd(at.n, dot(at.n, r.d) * -2.f, r.d));
            r.o = offsetOrigin(s, at, broadcast(-1.f));
            double b = dot(p, v), far = -b + std::sqrt(b * b - dot(p, p) + 2.25);
            p = p + v * far;
            Vec3d n = p * (1 / 1.5);
            v = v - n * (2 * dot(n, v));
            p = p * (1.5 / length(p)); // otherwise the oracle's own rounding would grow
            v = v * (1 / length(v));
            ASSERT_NEAR(length(lane(r.d)), 1, 3e-7) << bounce;
            ASSERT_NEAR(length(toDouble(lane(at.p)) - toDouble(s.centre)), 1.5, 2e-6) << bounce;
            worst = std::fmax(worst, length(toDouble(lane(at.p)) - toDouble(s.centre) - p));
        }
    }
    expectAtMost("largest error, radii", worst / 1.5, 0.02); // errors grow with every bounce, as they must
}

// Inside a cube of glass, beyond the critical angle, no light enters or leaves at any bounce.
TEST(Extremes, TotalReflectionHoldsEveryRay) {
    RayTracer g;
    Material glass = plain(0);
    glass.ior = 1.8f;
    g.scene->add(box({0, 0, 0}, {1, 1, 1}, g.scene->add(glass)));
    g.scene->sky = plainSky({1, 1, 1}, {1, 1, 1});
    Quality q = kExact;
    q.depth = 40;
    q.cutoff = 1e-5f;
    // Along a diagonal all three faces are met at 54.7 degrees; the critical angle is 33.7
    for (float scale : {0.1f, 0.5f, 0.9f}) {
        Vec3 eye = Vec3{0.01f, 0.02f, 0.03f} * scale, target = Vec3{1, 1.01f, 0.99f} * scale;
        EXPECT_EQ(g.trace(eye, target, q).radiance().x, 0) << scale;
    }
    // A little below the critical angle some light passes, by Fresnel's equations
    double angle = std::asin(1 / 1.8) * 0.9, sine = std::sin(angle) * 1.8, cosT = std::sqrt(1 - sine * sine),
           cosI = std::cos(angle), across = (1.8 * cosI - cosT) / (1.8 * cosI + cosT),
           along = (cosI - 1.8 * cosT) / (cosI + 1.8 * cosT);
    q.depth = 1;
    Sample s = g.trace({0, 0, 0}, {1, (float)std::tan(angle), 0}, q);
    EXPECT_NEAR(s.radiance().x, 1 - (across * across + along * along) / 2, 1e-4);
}

// Lights touch surfaces or lie inside them, shapes coincide, cameras are inside, below and on surfaces.
TEST(Extremes, PicturesStayFinite) {
    Dice dice(5);
    Material glass = plain(0.2f), mirror = plain(0.3f), matte = plain(0.8f);
    glass.ior = 1.5f;
    glass.specular = mirror.specular = 1;
    glass.exponent = 1000, mirror.exponent = 50;
    mirror.reflect = 0.9f;
    for (float scale : {1e-4f, 1e-2f, 1.f, 1e3f, 1e6f})
        for (int variant = 0; variant < 8; ++variant) {
            RayTracer g;
            mirror.fresnel = variant & 4;
            int a = g.scene->add(glass), b = g.scene->add(mirror), c = g.scene->add(matte);
            Vec3 middle = Vec3{3, 0, -2} * (variant & 1 ? scale : 0.f);
            auto at = [&](float x, float y, float z) { return middle + Vec3{x, y, z} * scale; };
            g.scene->add(plane(at(0, 0, 0), variant & 1 ? b : c));
            g.scene->add(plane(at(0, 0, 0), c)); // coincident
            g.scene->add(sphere(at(0, 1, 0), scale, a));
            g.scene->add(sphere(at(0, 1, 0), scale, b));
            g.scene->add(sphere(at(0, 1, 0), scale * 0.5f, c)); // nested
            g.scene->add(sphere(at(0, 1, 0), scale * 0.999999f, a));
            g.scene->add(box(at(2, 1, 0), {scale, scale, scale}, a)); // touching
            g.scene->add(box(at(2, 1, 0), {scale, scale, scale}, b));
            g.scene->add(cylinder(at(-2, 1, 0), scale, scale, a));
            for (int i = 0; i < 60; ++i) // enough for a tree, many in the same place
                g.scene->add(
                    sphere(at(dice(-3, 3), (float)(i % 3), dice(-3, 3)), scale * 0.2f, i % 2 ? a : b));
            for (Vec3 p : {at(0, 2, 0), at(0, 0, 0), at(1, 1, 0), at(0, 1, 0), at(-2, 2, 0)})
                g.scene->add(Light{p, {1, 1, 1}}); // on the ball, the floor, the box, inside, on a cap
            g.scene->sky = plainSky({1, 1, 1}, {1, 1, 1});
            g.scene->ballsOcclude = variant & 2;
            g.scene->finish();
            Vec3 eyes[8] = {at(0, 1, 5),    at(0, 1, 0),     at(0, -1, 3),        at(0, 2, 0),
                            at(1e5f, 1, 0), at(0, 1e-7f, 4), at(0, 1.999999f, 0), at(2, 1, 0)};
            View view = lookAt(eyes[variant], at(0, 1, 0), 30, 60, 40, 40);
            std::vector<float> x, y;
            for (int i = 0; i < 1600; ++i)
                x.push_back((float)(i % 40) + 0.5f), y.push_back((float)(i / 40) + 0.5f);
            for (const Sample &s : samplesAt(*g.scene, view, QualityName::Film, x, y)) {
                Rgb r = s.radiance();
                ASSERT_TRUE(r.x >= 0 && r.y >= 0 && r.z >= 0 && r.x < kInfinity) << scale << " " << variant;
            }
        }
}
