// Compares the oracles' rays with a test of every triangle and ball.
#include "tests/support/random.h"
#include "tools/radiosity/reference/obstacles.h"

#include <gtest/gtest.h>

using namespace odraz;
using namespace odraz::radiosity;

namespace {

struct Places : Random {
    double signedOne() { return 2 * (double)next() - 1; }
    Vec3d place() {
        double x = signedOne(), y = signedOne();
        return {x, y, signedOne()};
    }
};

// Where a ray hits a triangle, by the signs of three volumes.
Obstacles::Hit meet(const Obstacles::Triangle &c, Vec3d o, Vec3d d) {
    Vec3d n = cross(c[1] - c[0], c[2] - c[0]);
    double t = dot(c[0] - o, n) / dot(d, n);
    for (size_t k = 0; k < 3; ++k) {
        Vec3d a = c[k] - o, b = c[(k + 1) % 3] - o;
        if (dot(cross(a, b), d) * dot(n, d) < 0) return {};
    }
    return t > 0 ? Obstacles::Hit{t, 0, dot(d, n) > 0} : Obstacles::Hit{};
}

std::vector<Obstacles::Triangle> soup(int count, double size, Places random) {
    std::vector<Obstacles::Triangle> all;
    for (int i = 0; i < count; ++i) {
        Vec3d at = random.place();
        all.push_back({at, at + random.place() * size, at + random.place() * size});
    }
    return all;
}

} // namespace

TEST(Obstacles, MeetWhatIsFirst) {
    Places random = {};
    for (int count : {0, 1, 3, 5, 17, 2000})
        for (double size : {0.05, 1.}) {
            std::vector<Obstacles::Triangle> triangles = soup(count, size, random);
            Obstacles tree(triangles);
            int met = 0;
            for (int i = 0; i < 2000; ++i) {
                Vec3d o = random.place() * 2, d = random.place();
                if (i % 7 == 0) d.x = 0; // parallel to sides of the boxes
                if (i % 11 == 0) d.y = -0.;
                Obstacles::Hit best;
                for (size_t k = 0; k < triangles.size(); ++k)
                    if (Obstacles::Hit h = meet(triangles[k], o, d); h.t < best.t)
                        best = {h.t, (int)k, h.back};
                Obstacles::Hit hit = tree.nearest(o, d);
                ASSERT_EQ(hit.number, best.number) << count;
                if (!hit.met()) continue;
                ++met;
                ASSERT_NEAR(hit.t, best.t, 1e-9 * best.t);
                ASSERT_EQ(hit.back, best.back);
                ASSERT_TRUE(tree.blocked(o, d, best.t * 1.001));
                ASSERT_FALSE(tree.blocked(o, d, best.t * 0.999));
                Obstacles::Hit next = tree.nearest(o, d, best.t * 1.000001);
                ASSERT_TRUE(!next.met() || next.t > best.t);
            }
            if (count == 2000) {
                EXPECT_GT(met, 30);
            }
        }
}

// From inside a closed body no ray passes between two triangles, not even towards their edges and corners.
TEST(Obstacles, LeaveNoGaps) {
    constexpr int kAcross = 40;
    std::vector<Obstacles::Triangle> sheet;
    auto at = [](int i, int j) { return Vec3d{i / 7. - 2.5, 1 + i * j * 1e-4, j / 9. - 2}; };
    for (int i = 0; i < kAcross; ++i)
        for (int j = 0; j < kAcross; ++j) {
            sheet.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
            sheet.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    Obstacles tree(sheet);
    Places random = {};
    for (int i = 1; i < kAcross; ++i)
        for (int j = 1; j < kAcross; ++j)
            for (double share : {0., 0.25, 0.5}) {
                Vec3d o = random.place() * 0.1, to = at(i, j) * (1 - share) + at(i + 1, j) * share;
                EXPECT_TRUE(tree.nearest(o, to - o).met()) << i << " " << j << " " << share;
            }
}

TEST(Obstacles, PreferTheFrontOfASheet) {
    Places random = {};
    for (int i = 0; i < 500; ++i) {
        Obstacles::Triangle c = {random.place(), random.place(), random.place()}, back = {c[0], c[2], c[1]};
        Vec3d o = random.place() * 3, d = (c[0] + c[1] + c[2]) / 3 - o;
        for (auto sheet : {std::vector{c, back}, std::vector{back, c}}) {
            Obstacles::Hit hit = Obstacles(sheet).nearest(o, d);
            ASSERT_TRUE(hit.met());
            EXPECT_FALSE(hit.back);
            EXPECT_NEAR(hit.t, 1, 1e-9);
        }
    }
}

TEST(Obstacles, BallsAreMetFromOutsideAndInside) {
    Obstacles tree({{Vec3d{-9, -9, 5}, Vec3d{9, -9, 5}, Vec3d{0, 9, 5}}}, {{{0, 0, 0}, 1}, {{0, 0, 3}, 0.5}});
    Vec3d ahead = {0, 0, 1};
    EXPECT_EQ(tree.nearest({0, 0, -4}, ahead).number, 1); // behind the one triangle's number
    EXPECT_DOUBLE_EQ(tree.nearest({0, 0, -4}, ahead).t, 3);
    EXPECT_DOUBLE_EQ(tree.nearest({0, 0, -1}, ahead, 1e-7).t, 2); // from its own surface: the other side
    EXPECT_EQ(tree.nearest({0, 0, 1}, ahead, 1e-7).number, 2);
    EXPECT_EQ(tree.nearest({0, 0, 3.6}, ahead).number, 0);
    EXPECT_FALSE(tree.nearest({0, 2, -4}, {0, 1, 0}).met());
    EXPECT_TRUE(tree.blocked({0, 0, -4}, ahead, 3.1));
    EXPECT_FALSE(tree.blocked({0, 0, -4}, ahead, 2.9));
}
