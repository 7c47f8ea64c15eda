// Compares rays against many triangles with a test of every triangle in double precision.
#include "tests/support/random.h"
#include "tools/engine/vec3d.h"
#include "tools/radiosity/rays/ray_tree.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace odraz;
using namespace odraz::radiosity;

namespace {

struct Rays : Random {
    float signedOne() { return 2 * next() - 1; }
    Vec3 direction() {
        for (;;) {
            Vec3 d = {signedOne(), signedOne(), signedOne()};
            if (float l = dot(d, d); l > 0.01f && l < 1) return normalize(d);
        }
    }
};

// Moeller and Trumbore, 1997, in double; t, or infinity.
double meet(const RayTree::Corners &c, Vec3d o, Vec3d d) {
    Vec3d e1 = toDouble(c[1]) - toDouble(c[0]), e2 = toDouble(c[2]) - toDouble(c[0]), p = cross(d, e2);
    double det = dot(e1, p);
    Vec3d s = o - toDouble(c[0]), q = cross(s, e1);
    double u = dot(s, p) / det, v = dot(d, q) / det, t = dot(e2, q) / det;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : INFINITY;
}

std::vector<RayTree::Corners> soup(int count, float size, Rays random) {
    std::vector<RayTree::Corners> all;
    for (int i = 0; i < count; ++i) {
        Vec3 at = {random.signedOne(), random.signedOne(), random.signedOne()};
        RayTree::Corners c;
        for (Vec3 &p : c) p = at + random.direction() * size;
        all.push_back(c);
    }
    return all;
}

// A closed ball of triangles that share their corners.
std::vector<RayTree::Corners> ball(int rows, float radius, Vec3 centre) {
    std::vector<RayTree::Corners> all;
    int columns = 2 * rows;
    auto at = [&](int i, int j) {
        double a = 2 * M_PI * (i % columns) / columns, b = M_PI * j / rows;
        return centre + Vec3{(float)(std::sin(b) * std::cos(a)), (float)std::cos(b),
                             (float)(std::sin(b) * std::sin(a))} *
                            radius;
    };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            if (j > 0) all.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
            if (j + 1 < rows) all.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return all;
}

} // namespace

TEST(RayTree, MeetsWhatIsNearest) {
    for (int count : {1, 7, 8, 9, 100, 5000}) {
        auto triangles = soup(count, count > 50 ? 0.2f : 0.6f, {7});
        RayTree tree(triangles);
        Rays random = {3};
        int hits = 0, differ = 0;
        for (int i = 0; i < 2000; ++i) {
            Vec3 o = {2 * random.signedOne(), 2 * random.signedOne(), 2 * random.signedOne()},
                 d = normalize(
                     Vec3{0.5f * random.signedOne(), 0.5f * random.signedOne(), 0.5f * random.signedOne()} -
                     o);
            double nearest = INFINITY;
            int which = -1;
            for (size_t k = 0; k < triangles.size(); ++k)
                if (double t = meet(triangles[k], toDouble(o), toDouble(d)); t < nearest)
                    nearest = t, which = (int)k;
            RayHit hit = tree.nearest(o, d);
            hits += which >= 0;
            differ += hit.triangle != which; // by rounding, at edges and crossings
            if (hit.triangle == which && which >= 0) {
                EXPECT_NEAR((double)hit.t, nearest, 1e-5);
                const auto &c = triangles[(size_t)which];
                EXPECT_EQ(hit.back,
                          dot(cross(toDouble(c[1]) - toDouble(c[0]), toDouble(c[2]) - toDouble(c[0])),
                              toDouble(d)) > 0);
                EXPECT_TRUE(tree.blocked(o, d, hit.t * 1.001f));
                EXPECT_FALSE(tree.blocked(o, d, hit.t * 0.999f));
            }
        }
        EXPECT_GT(hits, count > 50 ? 100 : 0);
        EXPECT_LE(differ, 2) << count;
    }
}

TEST(RayTree, NothingPassesBetweenNeighbours) {
    for (float scale : {1e-6f, 1.f, 1e6f})
        for (Vec3 centre : {Vec3{0, 0, 0}, Vec3{3, -40, 7}}) {
            auto triangles = ball(40, scale, centre * scale);
            RayTree tree(triangles);
            Rays random = {11};
            int missed = 0;
            auto shoot = [&](Vec3 target) {
                Vec3 o = centre * scale + random.direction() * (0.5f * scale);
                RayHit hit = tree.nearest(o, normalize(target - o));
                missed += hit.triangle < 0;
            };
            for (int i = 0; i < 20000; ++i) {
                const auto &c = triangles[(size_t)(random.next() * (float)triangles.size())];
                shoot(c[0]);                                                       // a corner
                shoot(lerp(c[0], c[1], random.next()));                            // an edge
                shoot(lerp(lerp(c[0], c[1], random.next()), c[2], random.next())); // inside
            }
            EXPECT_EQ(missed, 0) << scale;
        }
}

TEST(RayTree, OfBothSidesOfASheetTheFront) {
    RayTree::Corners c = {Vec3{0.1f, 0.2f, 3}, Vec3{1.3f, 0.15f, 3.1f}, Vec3{0.3f, 1.7f, 2.8f}};
    for (int order = 0; order < 2; ++order) {
        RayTree::Corners back = {c[0], c[2], c[1]};
        RayTree tree(order ? std::vector{c, back} : std::vector{back, c});
        for (int i = 0; i < 100; ++i) {
            Vec3 d = normalize(Vec3{0.4f + 0.002f * (float)i, 0.6f, 3});
            EXPECT_FALSE(tree.nearest({}, d).back);
            EXPECT_FALSE(tree.nearestFront({}, d).back);
            EXPECT_FALSE(tree.nearest(Vec3{0, 0, 6}, {d.x, d.y, -d.z}).back);
        }
    }
}

TEST(RayTree, LooksThroughBacks) {
    std::vector<RayTree::Corners> all;
    for (int i = 1; i <= 20; ++i) { // every fifth faces the origin
        auto z = (float)i;
        RayTree::Corners c = {Vec3{-1, -1, z}, Vec3{0, 2, z}, Vec3{2, -1, z}};
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
}

TEST(RayTree, RaysAlongAxesAndBoxes) {
    // Walls without thickness; rays run in their planes or along axes
    std::vector<RayTree::Corners> all;
    for (int i = 0; i < 50; ++i) {
        float y = (float)i;
        all.push_back({Vec3{0, y, 0}, Vec3{1, y, 0}, Vec3{0, y, 1}});
    }
    RayTree tree(all);
    RayHit up = tree.nearest({0.25f, -1, 0.25f}, {0, 1, 0}),
           down = tree.nearest({0.25f, 60, 0.25f}, {0, -1, 0});
    EXPECT_EQ(up.triangle, 0);
    EXPECT_EQ(down.triangle, 49);
    EXPECT_NE(up.back, down.back);
    EXPECT_EQ(tree.nearest({-1, 20.5f, 0.25f}, {1, 0, 0}).triangle, -1);
    EXPECT_EQ(tree.nearest({0.25f, 10, 0.25f}, {0, 1, 0}).triangle, 11); // it starts on the tenth
}

TEST(RayTree, ManyInOnePlace) {
    // A group that no plane can divide is halved
    std::vector<RayTree::Corners> all(3000, {Vec3{0, 0, 1}, Vec3{1, 0, 1}, Vec3{0, 1, 1}});
    RayTree tree(all);
    EXPECT_EQ(tree.nearest({0.2f, 0.2f, 0}, {0, 0, 1}).triangle, 0);
    EXPECT_FALSE(tree.blocked({0.2f, 0.2f, 0}, {0, 0, 1}, 0.5f));
}
