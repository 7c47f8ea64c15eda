// Tests rays against many triangles. Compares the solver's tree (in floats) and the tree of the references
// (in double precision) with a test of every triangle.
#include "tests/support/dice.h"
#include "tests/support/sanitized.h"
#include "tools/radiosity/rays/ray_tree.h"
#include "tools/radiosity/reference/obstacles.h"

using namespace odraz;
using namespace odraz::radiosity;

using Hit = Obstacles::Hit;
using Corners = RayTree::Corners;

static std::vector<Obstacles::Triangle> inDouble(const std::vector<Corners> &all) {
    std::vector<Obstacles::Triangle> to;
    for (const Corners &c : all) to.push_back({toDouble(c[0]), toDouble(c[1]), toDouble(c[2])});
    return to;
}

struct Solvers {
    static constexpr double kOff = 1e-5;
    // The most wrong hits among 2,000, caused by rounding at edges and where triangles cross
    static constexpr int kDiffer = 2;
    RayTree tree;
    explicit Solvers(const std::vector<Corners> &all) : tree(all) {}
    Hit nearest(Vec3 o, Vec3 d) const {
        RayHit hit = tree.nearest(o, d);
        return {(double)hit.t, hit.triangle, hit.back};
    }
    bool blocked(Vec3 o, Vec3 d, double end) const { return tree.blocked(o, d, (float)end); }
};

struct Oracles {
    static constexpr double kOff = 1e-9;
    static constexpr int kDiffer = 0;
    Obstacles tree;
    explicit Oracles(const std::vector<Corners> &all) : tree(inDouble(all)) {}
    Hit nearest(Vec3 o, Vec3 d) const { return tree.nearest(toDouble(o), toDouble(d)); }
    bool blocked(Vec3 o, Vec3 d, double end) const { return tree.blocked(toDouble(o), toDouble(d), end); }
};

template <class Tree> class Trees : public testing::Test {};
using BothTrees = testing::Types<Solvers, Oracles>;
TYPED_TEST_SUITE(Trees, BothTrees);

// The hit of a ray and a triangle, by the signs of three volumes.
static Hit intersect(const Obstacles::Triangle &c, Vec3d o, Vec3d d) {
    Vec3d n = cross(c[1] - c[0], c[2] - c[0]);
    double t = dot(c[0] - o, n) / dot(d, n);
    for (size_t k = 0; k < 3; ++k) {
        Vec3d a = c[k] - o, b = c[(k + 1) % 3] - o;
        if (dot(cross(a, b), d) * dot(n, d) < 0) return {};
    }
    return t > 0 ? Hit{t, 0, dot(d, n) > 0} : Hit{};
}

// A closed ball of triangles that share their corners.
static std::vector<Corners> ball(int rows, float radius, Vec3 centre) {
    std::vector<Corners> all;
    int columns = 2 * rows;
    auto at = [&](int i, int j) {
        double a = 2 * M_PI * (i % columns) / columns, b = M_PI * j / rows;
        return centre +
               toFloat(Vec3d{std::sin(b) * std::cos(a), std::cos(b), std::sin(b) * std::sin(a)}) * radius;
    };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            if (j > 0) all.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
            if (j + 1 < rows) all.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return all;
}

TYPED_TEST(Trees, MeetWhatIsNearest) {
    Dice dice(7);
    for (int count : {0, 1, 3, 7, 8, 9, 17, 100, 3000})
        for (float size : {0.05f, count > 50 ? 0.2f : 0.8f}) {
            std::vector<Corners> all;
            for (int i = 0; i < count; ++i) {
                Vec3 at = dice.point(1);
                all.push_back({at, at + dice.point(size), at + dice.point(size)});
            }
            std::vector<Obstacles::Triangle> exact = inDouble(all);
            TypeParam tree(all);
            int met = 0, differ = 0;
            for (int i = 0; i < (kSanitized ? 200 : 2000); ++i) {
                Vec3 o = dice.point(2), d = normalize(dice.point(0.5f) - o);
                if (i % 7 == 0) d.x = 0; // parallel to sides of the boxes
                if (i % 11 == 0) d.y = -0.f;
                Hit best;
                for (size_t k = 0; k < exact.size(); ++k)
                    if (Hit h = intersect(exact[k], toDouble(o), toDouble(d)); h.t < best.t)
                        best = {h.t, (int)k, h.back};
                Hit hit = tree.nearest(o, d);
                met += best.met();
                differ += hit.number != best.number;
                if (hit.number != best.number || !best.met()) continue;
                ASSERT_NEAR(hit.t, best.t, TypeParam::kOff);
                ASSERT_EQ(hit.back, best.back);
                ASSERT_TRUE(tree.blocked(o, d, best.t * 1.001));
                ASSERT_FALSE(tree.blocked(o, d, best.t * 0.999));
            }
            EXPECT_GE(met, count < 3000 ? 0 : kSanitized ? 10 : 100);
            EXPECT_LE(differ, TypeParam::kDiffer) << count << " of " << size;
        }
}

// No ray leaves a closed body between two triangles, not even at their edges and corners.
TYPED_TEST(Trees, LeaveNoGaps) {
    for (float scale : {1e-6f, 1.f, 1e6f})
        for (Vec3 centre : {Vec3{0, 0, 0}, Vec3{3, -40, 7}}) {
            auto all = ball(40, scale, centre * scale);
            TypeParam tree(all);
            Dice dice(11);
            int missed = 0;
            auto shoot = [&](Vec3 target) {
                Vec3 o = centre * scale + dice.direction() * (0.5f * scale);
                missed += !tree.nearest(o, normalize(target - o)).met();
            };
            for (int i = 0; i < (kSanitized ? 2000 : 20000); ++i) {
                const Corners &c = all[(size_t)(dice(0, 0.9999f) * (float)all.size())];
                shoot(c[0]);                                                 // a corner
                shoot(lerp(c[0], c[1], dice(0, 1)));                         // an edge
                shoot(lerp(lerp(c[0], c[1], dice(0, 1)), c[2], dice(0, 1))); // inside
            }
            EXPECT_EQ(missed, 0) << scale;
        }
}

TYPED_TEST(Trees, PreferTheFrontOfASheet) {
    Dice dice(3);
    for (int i = 0; i < 500; ++i) {
        Corners c = {dice.point(1), dice.point(1), dice.point(1)}, back = {c[0], c[2], c[1]};
        Vec3 o = dice.point(3), d = (c[0] + c[1] + c[2]) * (1 / 3.f) - o;
        for (auto sheet : {std::vector{c, back}, std::vector{back, c}}) {
            Hit hit = TypeParam(sheet).nearest(o, d);
            ASSERT_TRUE(hit.met());
            EXPECT_FALSE(hit.back);
            EXPECT_NEAR(hit.t, 1, 1e-4);
        }
    }
}

// Walls without thickness; rays run in their planes or along axes.
TYPED_TEST(Trees, TakeRaysAlongAxesAndBoxes) {
    std::vector<Corners> all;
    for (int i = 0; i < 50; ++i) {
        float y = (float)i;
        all.push_back({Vec3{0, y, 0}, Vec3{1, y, 0}, Vec3{0, y, 1}});
    }
    TypeParam tree(all);
    Hit up = tree.nearest({0.25f, -1, 0.25f}, {0, 1, 0}), down = tree.nearest({0.25f, 60, 0.25f}, {0, -1, 0});
    EXPECT_EQ(up.number, 0);
    EXPECT_EQ(down.number, 49);
    EXPECT_NE(up.back, down.back);
    EXPECT_EQ(tree.nearest({-1, 20.5f, 0.25f}, {1, 0, 0}).number, -1);
    EXPECT_EQ(tree.nearest({0.25f, 10, 0.25f}, {0, 1, 0}).number, 11); // it starts on number 10
}

// A group that no plane can divide is halved.
TEST(RayTree, TakesManyInOnePlace) {
    RayTree tree(std::vector<Corners>(3000, {Vec3{0, 0, 1}, Vec3{1, 0, 1}, Vec3{0, 1, 1}}));
    EXPECT_EQ(tree.nearest({0.2f, 0.2f, 0}, {0, 0, 1}).triangle, 0);
    EXPECT_FALSE(tree.blocked({0.2f, 0.2f, 0}, {0, 0, 1}, 0.5f));
}

TEST(RayTree, LooksThroughBacks) {
    std::vector<Corners> all;
    for (int i = 1; i <= 20; ++i) { // every fifth triangle faces the origin
        auto z = (float)i;
        Corners c = {Vec3{-1, -1, z}, Vec3{0, 2, z}, Vec3{2, -1, z}};
        if (i % 5) std::swap(c[1], c[2]);
        all.push_back(c);
    }
    RayTree tree(all);
    EXPECT_EQ(tree.nearest({}, {0, 0, 1}).triangle, 0);
    EXPECT_TRUE(tree.nearest({}, {0, 0, 1}).back);
    EXPECT_EQ(tree.nearestFront({}, {0, 0, 1}).triangle, 4);
    EXPECT_EQ(tree.nearestFront({0, 0, 5.5f}, {0, 0, 1}).triangle, 9);
    EXPECT_EQ(tree.nearestFront({0, 0, 20.5f}, {0, 0, -1}).triangle, 18);
    EXPECT_EQ(tree.nearestFront({0, 0, 0.5f}, {0, 0, -1}).triangle, -1);
    // A sheet of two triangles that face opposite sides: a ray hits the one that faces its origin
    Corners c = {Vec3{-1, -1, 1}, Vec3{0, 2, 1}, Vec3{2, -1, 1}};
    for (int turned : {0, 1}) {
        std::vector<Corners> sheet = {c, {c[0], c[2], c[1]}};
        if (turned) std::swap(sheet[0], sheet[1]);
        EXPECT_EQ(RayTree(sheet).nearestFront({}, {0, 0, 1}).triangle, turned);
        EXPECT_EQ(RayTree(sheet).nearestFront({0, 0, 2}, {0, 0, -1}).triangle, 1 - turned);
    }
}
