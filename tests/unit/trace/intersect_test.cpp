// Compares rays and shapes with closed forms and with an oracle in double precision, and the tree with brute
// force; tries extremes.
#include "tests/support/dice.h"
#include "tests/support/model_bench.h"
#include "tests/support/room.h"
#include "tests/support/shapes.h"
#include "tools/support/vec3d.h"
#include "trace/rays/beam.h"

using namespace odraz;

static Ray8 ray(Vec3 o, Vec3 d) { return {broadcast(o), broadcast(normalize(d))}; }

static float hit(const Shape &s, Vec3 o, Vec3 d) { return distance(s, ray(o, d))[0]; }

// Returns the solid shapes in turn: both of their sides are hit and stop light.
static ShapeKind solid(int i) {
    std::vector<ShapeKind> kinds;
    for (const ShapeTraits &traits : kShapeTraits)
        if (traits.solid && traits.bounded) kinds.push_back(traits.kind);
    return kinds[(size_t)i % kinds.size()];
}

// Returns the distance to the nearest shape, by brute force.
static Float8 nearestOf(const Scene &scene, const Ray8 &r) {
    Float8 nearest = broadcast(kInfinity);
    for (int s = 0; s < scene.shapeCount; ++s) nearest = min(nearest, distance(scene.shapes[s], r));
    return nearest;
}

TEST(Plane, IsHitFromBothSidesAndNotAlong) {
    Shape s = plane({0, 1, 0}, 0);
    EXPECT_FLOAT_EQ(hit(s, {3, 5, 2}, {0, -1, 0}), 4);
    EXPECT_FLOAT_EQ(hit(s, {3, -5, 2}, {0, 1, 0}), 6);
    EXPECT_EQ(hit(s, {0, 5, 0}, {0, 1, 0}), kInfinity);
    EXPECT_EQ(hit(s, {0, 5, 0}, {1, 0, 0}), kInfinity);
    EXPECT_EQ(hit(s, {0, 1, 0}, {1, 0, 0}), kInfinity); // in the plane itself
}

TEST(Box, AgreesWithDoublePrecisionUnderRotation) {
    Dice dice(7);
    for (int i = 0; i < 20000; ++i) {
        Shape s = box(dice.point(5), {dice(0.1f, 3), dice(0.1f, 3), dice(0.1f, 3)}, 0);
        s.frame = dice.rotation();
        s.aligned = false;
        Vec3 o = dice.point(12), d = normalize(s.centre + dice.point(2) - o);
        Vec3d half = toDouble(s.half);
        double enter = -1e30, leave = 1e30;
        for (size_t k = 0; k < 3; ++k) {
            Vec3d axis = toDouble((&s.frame.u)[k]);
            double at = dot(axis, toDouble(o) - toDouble(s.centre)), step = dot(axis, toDouble(d));
            double a = (-half[k] - at) / step, b = (half[k] - at) / step;
            enter = std::fmax(enter, std::fmin(a, b));
            leave = std::fmin(leave, std::fmax(a, b));
        }
        float t = hit(s, o, d);
        if (leave - enter > 1e-3 && leave > 1e-3 && std::fabs(enter) > 1e-3) {
            ASSERT_NEAR(t, enter > 0 ? enter : leave, 1e-3);
        } else if (enter - leave > 1e-3 || leave < -1e-3) {
            ASSERT_EQ(t, kInfinity);
        }
    }
}

TEST(Box, IsHitByRaysAlongItsAxes) {
    Shape s = box({0, 0, 0}, {1, 2, 3}, 0);
    EXPECT_FLOAT_EQ(hit(s, {5, 0, 0}, {-1, 0, 0}), 4);
    EXPECT_FLOAT_EQ(hit(s, {0, 0, 0}, {0, 0, 1}), 3);
    EXPECT_EQ(hit(s, {5, 2.01f, 0}, {-1, 0, 0}), kInfinity);
    EXPECT_FALSE(std::isnan(hit(s, {5, 2, 0}, {-1, 0, 0}))); // in the plane of a face
}

TEST(Cylinder, HasASideAndTwoCaps) {
    Shape s = cylinder({0, 0, 0}, 1, 2, 0);
    EXPECT_FLOAT_EQ(hit(s, {5, 1, 0}, {-1, 0, 0}), 4);
    EXPECT_FLOAT_EQ(hit(s, {0.5f, 5, 0}, {0, -1, 0}), 3);
    EXPECT_FLOAT_EQ(hit(s, {0.5f, 0, 0}, {0, -1, 0}), 2);
    EXPECT_FLOAT_EQ(hit(s, {0, 1, 0}, {1, 0, 0}), 1);
    EXPECT_EQ(hit(s, {5, 2.1f, 0}, {-1, 0, 0}), kInfinity);
    EXPECT_EQ(hit(s, {1.1f, 5, 0}, {0, -1, 0}), kInfinity);
    EXPECT_EQ(hit(s, {5, 1, 1.01f}, {-1, 0, 0}), kInfinity);
    EXPECT_NEAR(hit(s, {3, 4, 0}, {-1, -1, 0}), std::sqrt(8.f), 1e-5); // over the rim onto the cap
}

TEST(Rect, IsMetFromItsLitSideOnly) {
    auto scene = emptyScene();
    scene->add(rect({0, 1, 0}, {0, 0, 1}, {1, 0, 0}, 2, 0.5f)); // long along z
    scene->finish();
    auto meet = [&](Vec3 o, Vec3 d) {
        return intersect(*scene, {broadcast(o), broadcast(normalize(d))}, kLanes < 8).t[0];
    };
    EXPECT_FLOAT_EQ(meet({0, 3, 0}, {0, -1, 0}), 2);
    EXPECT_EQ(meet({0, -3, 0}, {0, 1, 0}), kInfinity);
    EXPECT_FLOAT_EQ(meet({0.49f, 3, 1.99f}, {0, -1, 0}), 2);
    EXPECT_EQ(meet({0.51f, 3, 0}, {0, -1, 0}), kInfinity);
    EXPECT_EQ(meet({0, 3, 2.01f}, {0, -1, 0}), kInfinity);
    EXPECT_EQ(meet({0, 3, 0}, {1, 0, 0}), kInfinity);
    EXPECT_EQ(meet({5, 1, 0}, {-1, 0, 0}), kInfinity); // in its plane
    // Light passes from neither side
    for (float side : {-1.f, 1.f}) {
        Ray8 r = {broadcast(Vec3{0, 1 + 2 * side, 0}), broadcast(Vec3{0, -side, 0})};
        EXPECT_EQ(transmittance(*scene, r, broadcast(9.f), kLanes < 8, broadcast(-1)).x[0], 0);
        EXPECT_EQ(transmittance(*scene, r, broadcast(9.f), kLanes < 8, broadcast(0)).x[0],
                  1); // the rectangle that the ray starts on
    }
}

// A room of rectangles lets no ray out, even along edges and into corners, at any size.
TEST(Rect, RoomsAreTight) {
    for (float scale : {1e-3f, 1.f, 1e4f}) {
        ModelBench bench;
        Vec3 half = Vec3{1.1f, 0.7f, 2.3f} * scale, off = Vec3{3, -5, 1} * scale;
        addRoom(*bench.model, off - half, off + half, scale);
        bench.pose();
        Dice dice(11);
        int lost = 0;
        for (int i = 0; i < 100000; ++i) {
            Ray8 ray;
            for (int k = 0; k < 8; ++k) {
                float to[3] = {dice(-1, 1), dice(-1, 1), dice(-1, 1)};
                // Aim half of them at edges, and some of these at corners
                if (i & 1) to[i % 3] = to[i % 3] < 0 ? -1.f : 1.f, to[(i + 1) % 3] = 1;
                if ((i & 7) == 7) to[(i + 2) % 3] = -1;
                Vec3 from = off + dice.point(0.999f) * half;
                setLane(ray.o, k, from);
                setLane(ray.d, k, normalize(off + Vec3{to[0], to[1], to[2]} * half - from));
            }
            Hit8 hit = intersect(*bench.scene, ray, kLanes < 8);
            for (int k = 0; k < 8; ++k) lost += hit.shape[k] < 0;
        }
        EXPECT_EQ(lost, 0) << scale;
    }
}

// --- The tree ---

// Tries packets, single rays and beams, in trees of mixed shapes and of balls alone.
TEST(Tree, FindsWhatBruteForceFinds) {
    Dice dice(7);
    auto scene = std::make_unique<Scene>();
    for (int round = 0; round < 24; ++round) {
        scene->clear();
        scene->add(Material{});
        int count = round < 20 ? round * 20 : 3000;
        float size = round < 20 ? 2 : 0.4f;
        for (int i = 0; i < count; ++i) {
            Vec3 c = dice.point(20);
            // Use every solid kind in turn, and now and then only balls
            ShapeKind kind = round % 4 == 3 ? ShapeKind::Sphere : solid(i);
            Shape s = shapeOf(kind, c, {dice(0.1f, size), dice(0.1f, size), dice(0.1f, size)});
            if (i % 2) s.frame = dice.rotation();
            scene->add(s);
        }
        scene->add(plane({0, -15, 0}, 0));
        scene->finish();
        for (int i = 0; i < 200; ++i) {
            Ray8 r;
            Vec3 common = dice.point(25), towards = dice.direction();
            int kind = i % 4; // 0: scattered, 1: along an axis, 2: a beam, 3: a wide one
            for (int k = 0; k < 8; ++k) {
                setLane(r.o, k, kind >= 2 ? common : dice.point(30));
                Vec3 d = dice.direction();
                setLane(r.d, k, kind < 2 ? d : normalize(towards + d * (kind == 2 ? 0.05f : 0.9f)));
            }
            if (kind == 1) r.d = broadcast(Vec3{i % 8 < 4 ? 1.f : 0.f, i % 8 < 4 ? 0.f : -1.f, 0});
            Hit8 h = intersect(*scene, r, kLanes >= 0);
            Float8 nearest = nearestOf(*scene, r);
            Rgb8 light = transmittance(*scene, r, broadcast(25.f), kLanes >= 0, broadcast(-1));
            for (int k = 0; k < 8; ++k) {
                ASSERT_EQ(h.t[k], nearest[k]) << round << " " << kind;
                ASSERT_EQ(light.x[k], nearest[k] < 25 ? 0 : 1) << round << " " << kind;
                if (h.shape[k] >= 0) {
                    ASSERT_EQ(distance(scene->shapes[h.shape[k]], r)[k], h.t[k]);
                }
            }
            if (kind < 2) continue;
            BeamBuilder builder(common, towards);
            builder.add(r.d * broadcast(25.f));
            if (!builder.narrow()) continue;
            Candidates candidates;
            Beam beam = builder.beam();
            findCandidates(*scene, beam, candidates);
            // Towards the light
            Ray8 back = {fmadd(r.d, broadcast(25.f), r.o), -r.d};
            light = transmittance(*scene, back, broadcast(25.f), kLanes >= 0, broadcast(-1));
            Rgb8 shared =
                transmittance(*scene, candidates, back, broadcast(25.f), kLanes >= 0, broadcast(-1));
            beam.limit[4] = -kInfinity; // primary rays have no end
            findCandidates(*scene, beam, candidates);
            Hit8 seen = intersect(*scene, candidates, common, r.d, kLanes >= 0);
            for (int k = 0; k < 8; ++k) {
                ASSERT_EQ(seen.shape[k], h.shape[k]) << round << " " << kind;
                ASSERT_EQ(seen.t[k], h.t[k]);
                ASSERT_EQ(shared.x[k], light.x[k]) << round << " " << kind;
            }
        }
    }
}

// Boxes are culled for a packet as a whole. Rays leave a mirror from different points; some lanes are
// inactive and point elsewhere; many rays barely hit a ball, where its box ends.
TEST(Tree, CullsNothingThatAnActiveRayHits) {
    Dice dice(7);
    auto scene = std::make_unique<Scene>();
    for (int round = 0; round < 12; ++round) {
        scene->clear();
        scene->add(Material{});
        const bool balls = round % 2;
        for (int i = 0; i < 300; ++i) {
            Vec3 half = {dice(0.1f, 0.5f), dice(0.1f, 0.5f), dice(0.1f, 0.5f)};
            scene->add(shapeOf(balls ? ShapeKind::Sphere : solid(i), dice.point(9), half));
        }
        scene->finish();
        for (int i = 0; i < 400; ++i) {
            float far = i % 3 == 0 ? 1000.f : 20.f, apart = dice(0, 2), spread = dice(0, 0.1f);
            Vec3 from = dice.direction() * far;
            int lanes = (int)dice(1, 255.99f);
            const Shape &aim = scene->shapes[(int)dice(0, 299.99f)];
            Ray8 r;
            for (int k = 0; k < 8; ++k) {
                // At the side of a ball that lies farthest along an axis
                Vec3 side = {0, (i & 1 ? 1.f : -1.f) * aim.half.x * dice(0.999f, 1.0001f), 0};
                Vec3 o = from + dice.point(apart), to = aim.centre + (k & 1 ? side : dice.point(spread * 20));
                setLane(r.o, k, o);
                setLane(r.d, k, lanes >> k & 1 ? normalize(to - o) : dice.direction());
            }
            Int8 active = ((Int8{} + lanes) >> kLanes & 1) != 0;
            Hit8 h = intersect(*scene, r, active);
            Float8 nearest = nearestOf(*scene, r), end = min(nearest * 1.001f, kInfinity);
            Rgb8 open = transmittance(*scene, r, end, active, broadcast(-1));
            for (int k = 0; k < 8; ++k) {
                if (!(lanes >> k & 1)) continue;
                ASSERT_EQ(h.t[k], nearest[k]) << round << " " << i;
                ASSERT_EQ(open.x[k], nearest[k] < kInfinity ? 0 : 1) << round << " " << i;
            }
        }
    }
}

TEST(Tree, TakesCoincidentShapes) {
    auto scene = emptyScene();
    scene->add(Material{});
    for (int i = 0; i < 200; ++i) scene->add(sphere({0, 0, 0}, 1, 0));
    scene->finish();
    Hit8 h = intersect(*scene, ray({0, 0, 5}, {0, 0, -1}), kLanes >= 0);
    EXPECT_FLOAT_EQ(h.t[0], 4);
}

// --- Surfaces ---

// From a hit, a ray along the outward normal must leave the shape, and a ray against it must stay inside, at
// any size and any distance of the camera: no acne, no leak.
TEST(Surface, OffsetOriginsLieOnTheirSide) {
    Dice dice(7);
    for (float size : {1e-3f, 1.f, 1e3f, 1e6f})
        for (float away : {3.f, 100.f, 1e4f})
            for (int i = 0; i < 1500; ++i) {
                Vec3 c = dice.point(size);
                Shape s = shapeOf(solid(i), c, {size, size * 0.5f, size});
                s.frame = dice.rotation();
                s.aligned = false;
                Vec3 o = c + dice.direction() * (size * away);
                Ray8 r = ray(o, c + dice.point(size * 0.3f) - o);
                Float8 t = distance(s, r);
                if (!(t[0] < kInfinity)) continue;
                Surface8 at = surfaceAt(s, r, t);
                float inside = distance(s, {offsetOrigin(s, at, broadcast(-1.f)), -at.n})[0];
                ASSERT_EQ(distance(s, {offsetOrigin(s, at, broadcast(1.f)), at.n})[0], kInfinity)
                    << size << " " << away;
                ASSERT_LT(inside, kInfinity) << size << " " << away;
                ASSERT_GT(inside, size * 1e-3f) << size << " " << away;
                ASSERT_NEAR(length(at.n)[0], 1, 1e-5);
            }
}

TEST(Surface, GivesEachFaceItsOwnNumber) {
    Shape s = box({0, 0, 0}, {1, 1, 1}, 0), c = cylinder({0, 0, 0}, 1, 1, 0);
    auto face = [](const Shape &s, Vec3 o) {
        Ray8 r = ray(o, -o);
        return surfaceAt(s, r, distance(s, r)).face[0];
    };
    std::set<int> seen;
    for (Vec3 o : {Vec3{5, 0, 0}, {-5, 0, 0}, {0, 5, 0}, {0, -5, 0}, {0, 0, 5}, {0, 0, -5}})
        seen.insert(face(s, o));
    EXPECT_EQ(seen.size(), 6u);
    EXPECT_NE(face(c, {0, 5, 0}), face(c, {0, -5, 0}));
    EXPECT_NE(face(c, {0, 5, 0}), face(c, {5, 0, 0}));
}
