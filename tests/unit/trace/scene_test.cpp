// Tests what a scene reports: the traits of its shapes, and which of its arrays is full.
#include "tests/support/shapes.h"
#include "trace/rays/intersect.h"
#include "trace/shade/diffuse.h"

using namespace odraz;

static const Shape &put(Scene &scene, ShapeKind kind, Vec3 centre) {
    return *scene.add(shapeOf(kind, centre, {1, 1, 1}));
}

static float meet(const Shape &s, Vec3 o, Vec3 d) {
    return distance(s, {broadcast(o), broadcast(normalize(d))})[0];
}

TEST(Shapes, HaveTheirTraits) {
    for (const ShapeTraits &traits : kShapeTraits) {
        SCOPED_TRACE((int)traits.kind);
        auto scene = emptyScene();
        scene->add(Material{});
        const Vec3 centre = {3, 5, -2}, in = centre + Vec3{0.2f, 0, 0.3f};
        const Shape &s = put(*scene, traits.kind, centre);
        scene->finish();
        EXPECT_EQ(scene->unboundedCount, traits.bounded ? 0 : 1);
        EXPECT_EQ(scene->nodeCount, traits.bounded ? 1 : 0);
        EXPECT_TRUE(s.aligned);

        // Rays from inside hit solid shapes but not flat ones; rays from above hit all
        EXPECT_LT(meet(s, in + Vec3{0, 9, 0}, {0, -1, 0}), kInfinity);
        EXPECT_EQ(meet(s, in + Vec3{0, 0.1f, 0}, {0, 1, 0}) < kInfinity, traits.solid);
        EXPECT_EQ(meet(s, in - Vec3{0, 9, 0}, {0, 1, 0}) < kInfinity, !traits.oneSided);

        // The box contains every hit, and equals the extents where these are known
        if (traits.bounded) {
            Bounds b = scene->box[0];
            for (float x = -1.4f; x < 1.5f; x += 0.1f)
                for (float z = -1.4f; z < 1.5f; z += 0.1f) {
                    Vec3 o = centre + Vec3{x, 9, z};
                    float t = meet(s, o, {0, -1, 0});
                    if (t == kInfinity) continue;
                    constexpr float kSlack = 1e-4f;
                    // The surface is where the ray hit, and faces up
                    Surface8 at = surfaceAt(s, {broadcast(o), broadcast(Vec3{0, -1, 0})}, broadcast(t));
                    EXPECT_LT(length(at.p - (o - Vec3{0, t, 0}))[0], kSlack);
                    EXPECT_NEAR(length(at.n)[0], 1, kSlack);
                    EXPECT_GE(at.n.y[0], 0);
                    EXPECT_TRUE(at.face[0] >= 0 && at.face[0] <= 5);
                    EXPECT_TRUE(o.x > b.lo.x - kSlack && o.x < b.hi.x + kSlack && o.z > b.lo.z - kSlack &&
                                o.z < b.hi.z + kSlack && o.y - t > b.lo.y - kSlack &&
                                o.y - t < b.hi.y + kSlack);
                }
            if (traits.extents) {
                EXPECT_LT(length(b.hi - (centre + s.half)), 1e-5f);
            }
        } else {
            EXPECT_FALSE(traits.extents);
        }
    }
}

// Shapes with sides of 0, or sides that are not finite, neither crash nor hide others. The frame of a
// rectangle is its sides divided by their lengths, so that it is not a number if a side has no length.
TEST(Shapes, WithoutASizeAreLeftOut) {
    const Float8 none = broadcast(kInfinity);
    for (const ShapeTraits &traits : kShapeTraits)
        for (float side : {0.f, -0.f, 1e-42f, std::nanf(""), -std::nanf(""), HUGE_VALF, -HUGE_VALF})
            for (int along = 0; along < 3 && traits.bounded; ++along) {
                SCOPED_TRACE((int)traits.kind);
                SCOPED_TRACE(side);
                SCOPED_TRACE(along);
                auto scene = emptyScene();
                scene->add(Material{});
                constexpr int kBalls = 20;
                for (int i = 0; i < kBalls; ++i) {
                    scene->add(sphere({(float)(3 * i), 0, 0}, 1, 0));
                    for (bool normalised : {false, true}) {
                        Shape s = shapeOf(traits.kind, {(float)(3 * i), 3, 1}, {0.1f, 0.1f, 0.1f});
                        float *half[] = {&s.half.x, &s.half.y, &s.half.z};
                        *half[along] = side;
                        if (s.isBall()) s.half = {side, side, side};
                        Vec3 *axes[] = {&s.frame.u, &s.frame.v, &s.frame.w};
                        if (normalised)
                            *axes[along] = *axes[along] * side * (1 / length(*axes[along] * side));
                        scene->add(s);
                    }
                }
                scene->finish();
                ASSERT_EQ(scene->overflow, nullptr);
                for (int i = 0; i < kBalls; ++i) {
                    Ray8 down = {broadcast(Vec3{(float)(3 * i), 9, 0}), broadcast(Vec3{0, -1, 0})};
                    Hit8 hit = intersect(*scene, down, kLanes >= 0);
                    ASSERT_EQ(hit.t[0], 8) << i;
                    ASSERT_EQ(hit.shape[0], 3 * i);
                    ASSERT_EQ(transmittance(*scene, down, none, kLanes >= 0, kLanes >= 0).x[0], 0);
                }
            }
}

// Neighbouring shapes continue each other's texture if their kind has the trait `joins`.
TEST(Shapes, JoinTheirTexturesOrNot) {
    Texture cloud = {.pattern = Pattern::Plaster, .scale = 1, .palette = {{0, 0, 0}, {1, 1, 1}, {0, 0, 0}}};
    for (const ShapeTraits &traits : kShapeTraits) {
        auto scene = emptyScene();
        scene->add(Material{.texture = cloud, .diffuse = 1});
        put(*scene, traits.kind, {0.3f, 0, 0});
        put(*scene, traits.kind, {1.7f, 0, 0.4f});
        scene->finish();
        Vec3x8 p = {toFloat(kLanes) * 0.1f + 0.6f, broadcast(0.5f), broadcast(0.2f)};
        auto colour = [&](int shape) {
            Int8 cell;
            return diffuseColour(*scene, scene->shapes[shape], p, broadcast(Vec3{0, -1, 0}), broadcast(1.f),
                                 broadcast(1e-3f), cell);
        };
        EXPECT_EQ(all(colour(0).x == colour(1).x), traits.joins) << (int)traits.kind;
    }
}

// Nothing is dropped silently: the error names the constant to raise.
TEST(Scene, NamesTheLimitThatIsExceeded) {
    auto scene = emptyScene();
    auto fills = [&](const char *limit, int most, auto &&add) {
        scene->clear();
        for (int i = 0; i < most; ++i) add();
        scene->finish();
        EXPECT_EQ(scene->overflow, nullptr) << limit;
        add();
        scene->finish();
        ASSERT_NE(scene->overflow, nullptr) << limit;
        EXPECT_EQ(std::string(scene->overflow),
                  "scene too large: raise " + std::string(limit) + " in trace/scene/scene.h");
    };
    fills("kMaxMaterials", kMaxMaterials, [&] { scene->add(Material{}); });
    fills("kMaxLights", kMaxLights, [&] { scene->add(Light{{}, {1, 1, 1}}); });
    fills("kMaxShapes", kMaxShapes, [&] { scene->add(sphere({}, 1, 0)); });
    fills("kMaxUnbounded", kMaxUnbounded, [&] { scene->add(plane({}, 0)); });
    fills("kMaxOccluders", kMaxOccluders, [&] {
        scene->ballsOcclude = true;
        scene->add(sphere({}, 1, 0));
    });
    scene->clear();
    EXPECT_EQ(scene->overflow, nullptr);
}
