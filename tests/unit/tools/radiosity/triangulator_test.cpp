// Tests that the triangles of polygons of any shape and position have Newell's area and all face the same
// way.
#include "tools/radiosity/read/mesh_builder.h"

using namespace odraz;
using namespace odraz::radiosity;

using Point = std::array<double, 2>;
using Loop = std::vector<Point>;

static double side(const Point &a, const Point &b, const Point &c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
static bool crosses(const Loop &p, size_t i, size_t k) { // the sides that begin at i and k
    const auto &a = p[i], &b = p[(i + 1) % p.size()], &c = p[k], &d = p[(k + 1) % p.size()];
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

// Returns random points in random order. Reverses parts of the outline until no sides cross.
static Loop untangled(size_t count, std::mt19937 &random) {
    std::uniform_real_distribution<double> uniform(0, 1);
    Loop p(count);
    for (auto &at : p) at = {uniform(random), uniform(random)};
    for (bool again = true; again;) {
        again = false;
        for (size_t i = 0; i < count; ++i)
            for (size_t k = i + 2; k < count; ++k)
                if ((k + 1) % count != i && crosses(p, i, k)) {
                    std::reverse(p.begin() + (long)i + 1, p.begin() + (long)k + 1);
                    again = true;
                }
    }
    return p;
}

// Returns points around a centre, at random distances.
static Loop star(size_t count, std::mt19937 &random) {
    std::uniform_real_distribution<double> uniform(0.1, 1);
    Loop p;
    for (size_t i = 0; i < count; ++i) {
        double angle = 6.283185307 * (double)i / (double)count, r = uniform(random);
        p.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return p;
}

static Vec3d newell(const std::vector<Vec3d> &p) {
    Vec3d sum = {};
    for (size_t i = 0; i < p.size(); ++i) sum = sum + cross(p[i] - p[0], p[(i + 1) % p.size()] - p[0]);
    return sum / 2;
}

// Returns the polygon's points in a plane with these axes.
static std::vector<Vec3d> placed(const Loop &p, const Vec3d &u, const Vec3d &v, const Vec3d &at) {
    std::vector<Vec3d> points;
    for (const auto &q : p) points.push_back(at + u * q[0] + v * q[1]);
    return points;
}

struct Built {
    Mesh mesh;
    std::vector<std::string> notes;
    double area = 0; // the area of the triangles along Newell's normal; NaN if one faces the other way
    double newells;

    explicit Built(const std::vector<Vec3d> &points) {
        Polygons polygons;
        polygons.points = points;
        polygons.polygons.push_back({0, -1, 1});
        for (size_t i = 0; i < points.size(); ++i) polygons.corners.push_back({(int)i, -1});
        mesh = buildMesh("m", polygons, {}, {}, notes);
        newells = length(newell(points));
        Vec3d up = normalize(newell(points));
        for (const Triangle &t : mesh.triangles) {
            double along = dot(normalOf(mesh, t), up) / 2;
            area += along > 0 ? along : NAN;
        }
    }
    explicit Built(const Loop &onFloor) : Built(placed(onFloor, {0, 0, 1}, {1, 0, 0}, {})) {}
};

TEST(Triangulator, DividesTenThousandRandomPolygons) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    int wrong = 0;
    for (size_t k = 0; k < 10000; ++k) {
        Loop p = k % 2 ? untangled(4 + k % 37, random) : star(4 + k % 37, random);
        auto axis = [&] { return normalize(Vec3d{normal(random), normal(random), normal(random)}); };
        Vec3d n = axis(), u = normalize(cross(n, axis())), v = cross(n, u);
        if (k % 4 < 2) u = {0, 0, 1}, v = {1, 0, 0};
        if (k % 3 == 0) std::reverse(p.begin(), p.end());
        for (double offset : {0., 1e6}) {
            Built built(placed(p, u, v, {offset, -offset, offset}));
            wrong += !(std::fabs(built.area - built.newells) <= 1e-6 * built.newells) || !built.notes.empty();
        }
    }
    EXPECT_EQ(wrong, 0);
}

// Corners in a line, notches, and holes, which bridges join to the outline. In the last polygon two of them
// end in one corner.
TEST(Triangulator, DividesAllShapesBothWays) {
    const std::pair<Loop, double> cases[] = {
        {{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}, {0, 1}}, 4},
        {{{0, 0}, {1, 1}, {2, 0}, {1, 8}}, 7},
        {{{1, 8}, {0, 0}, {1, 1}, {2, 0}}, 7},
        {{{0, 0}, {10, 1}, {0, 2}, {1, 1}}, 9},
        {{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {1, 1}, {1, 8}, {8, 8}, {8, 1}, {1, 1}}, 81 - 49},
        {{{0, 0},
          {9, 0},
          {9, 9},
          {0, 9},
          {0, 0},
          {1, 5},
          {1, 8},
          {4, 8},
          {4, 5},
          {1, 5},
          {0, 0},
          {5, 1},
          {5, 4},
          {8, 4},
          {8, 1},
          {5, 1}},
         81 - 18},
    };
    for (const auto &[loop, area] : cases)
        for (const Loop &p : {loop, Loop(loop.rbegin(), loop.rend())}) {
            Built built(p);
            EXPECT_NEAR(built.area, area, 1e-9);
            EXPECT_EQ(built.mesh.triangles.size(), p.size() - 2);
            EXPECT_TRUE(built.notes.empty());
        }
}

// The outline of squares that are joined as a tree: it touches itself at corners and along sides, encloses
// holes and slits, and turns back at the ends of slits.
struct Tiles {
    std::mt19937 &random;
    size_t most;
    std::set<std::array<int, 2>> taken = {};
    Loop outline = {};

    void add(int x, int y, size_t from) { // `from`: direction of the square that it joins
        taken.insert({x, y});
        for (size_t k = from + 1; k < from + 5; ++k) {
            const int dx[4] = {1, 0, -1, 0}, dy[4] = {0, 1, 0, -1};
            size_t to = k % 4;
            outline.push_back({x + (to < 2 ? 0.5 : -0.5), y + (to == 1 || to == 2 ? 0.5 : -0.5)});
            if (k < from + 4 && taken.size() < most && random() % 3 && !taken.count({x + dx[to], y + dy[to]}))
                add(x + dx[to], y + dy[to], (to + 2) % 4);
        }
    }
};

TEST(Triangulator, DividesWhatTouchesItself) {
    std::mt19937 random(3);
    int wrong = 0;
    for (size_t k = 0; k < 10000; ++k) {
        Tiles squares = {random, 2 + k % 60};
        squares.add(0, 0, 3);
        Loop &p = squares.outline;
        if (k % 3 == 0) std::reverse(p.begin(), p.end());
        Built built(placed(p, {3, 4, 0}, {-1, 2, 5}, {k % 2 * 1e5, 0, 0}));
        const double area = (double)squares.taken.size() * length(cross(Vec3d{3, 4, 0}, {-1, 2, 5}));
        wrong += !(std::fabs(built.area - area) <= 1e-6 * area) ||
                 (!built.notes.empty() && built.notes.back().find("cross") != std::string::npos);
    }
    EXPECT_EQ(wrong, 0);
}

// Some programs repeat the first point at the end, or leave lines that the outline follows there and back.
TEST(Triangulator, CutsSpikes) {
    for (const Loop &p :
         {Loop{{0, 0}, {4, 0}, {4, 2}, {8, 2}, {4, 2}, {4, 4}, {0, 4}},
          {{0, 0}, {4, 0}, {9, 1e-7}, {4, -1e-7}, {4, 4}, {0, 4}},
          {{0, 0}, {4, 0}, {4, 2}, {1, 2}, {4, 2}, {4, 2}, {4, 4}, {0, 4}, {0, 0}},
          {{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}, {-5, 4}, {-9, 4}, {-7, 4}, {0, 4}}}) {
        Built built(p);
        EXPECT_NEAR(built.area, built.newells, 1e-5);
        EXPECT_EQ(built.notes.size(), 1u); // triangles without area
    }
}

// Keeps a part that is edge-on along the axis of projection.
TEST(Triangulator, KeepsPartsOfFoldedPolygons) {
    Built built(std::vector<Vec3d>{{5, 0, 0}, {6, 0, 0}, {6, 5, .5}, {5, .5, 3}});
    EXPECT_EQ(built.mesh.triangles.size(), 2u);
    EXPECT_TRUE(built.notes.empty());
}

TEST(Triangulator, NotesCrossings) {
    Loop star;
    for (int k = 0; k < 5; ++k) star.push_back({std::cos(k * 2.5132741), std::sin(k * 2.5132741)});
    const Loop bow = {{0, 0}, {4, 0}, {1, 2}, {3, 2}}, even = {{0, 0}, {4, 0}, {0, 2}, {4, 2}},
               twice = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {3, 5}, {1, 5}},
               turned = {{0, 0}, {9, 0}, {9, 9}, {0, 0}, {4, 1}, {8, 1}, {8, 5}, {4, 1}}; // a hole
    for (const Loop &p : {star, bow, even, twice, turned}) {
        Built built(p);
        ASSERT_FALSE(built.notes.empty());
        EXPECT_NE(built.notes.back().find("cross themselves"), std::string::npos);
        EXPECT_FALSE(built.area <= 0); // NaN for `even`, whose area vector is 0
    }
}

// The time for a polygon of N corners grows about as N log N. This polygon is a comb of many teeth.
TEST(Triangulator, DividesLargePolygons) {
    const int teeth = 20000;
    Loop comb = {{0, -1e4}, {2. * teeth, -1e4}};
    for (int k = teeth; k > 0; --k) comb.push_back({2. * k - 1, 1. * teeth}), comb.push_back({2. * k - 2, 0});
    Built built(comb);
    EXPECT_NEAR(built.area / built.newells, 1, 1e-9);
}
