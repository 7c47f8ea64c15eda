// Tests joining triangles into charts, and the elements of charts. (radiosity_errors compares solutions with
// paths.)
#include "tests/support/headless_gl.h"
#include "tools/radiosity/divide/facets.h"
#include "tools/radiosity/divide/regions.h"
#include "tools/radiosity/solve/solve.h"
#include "tools/support/machine.h"

using namespace odraz;
using namespace odraz::radiosity;

// A plane of squares of two triangles each, without the squares for which `hole` returns true.
template <class Hole> static Mesh grid(int across, int down, Hole &&hole) {
    Mesh mesh;
    mesh.materials.push_back({"plain", {0.5f, 0.5f, 0.5f}, {}});
    for (int j = 0; j <= down; ++j)
        for (int i = 0; i <= across; ++i) mesh.points.push_back({(double)i, 0, (double)-j});
    for (int j = 0; j < down; ++j)
        for (int i = 0; i < across; ++i) {
            if (hole(i, j)) continue;
            int a = j * (across + 1) + i, b = a + 1, c = b + across + 1, d = a + across + 1;
            mesh.triangles.push_back({{a, b, c}, 0});
            mesh.triangles.push_back({{a, c, d}, 0});
        }
    return mesh;
}

struct Joined {
    std::unique_ptr<Model> model = std::make_unique<Model>();
    Regions regions;
    explicit Joined(const Mesh &mesh) : regions(joinRegions(mesh, 0.5)) { fillModel(*model, regions); }
    double facetsArea() const {
        double area = 0;
        for (int i = 0; i < model->facetCount; ++i) area += areaOf(outlineOf(model->facets[i]));
        return area;
    }
};

// A grid is one rectangle, a window leaves four, an L is two.
TEST(Regions, AreFewRectangles) {
    const std::tuple<const char *, Mesh, int, double> cases[] = {
        {"grid", grid(20, 10, [](int, int) { return false; }), 1, 200},
        {"window", grid(9, 9, [](int i, int k) { return i >= 3 && i < 6 && k >= 2 && k < 5; }), 4, 72},
        {"L", grid(6, 6, [](int i, int k) { return i >= 2 && k >= 2; }), 2, 20},
    };
    for (const auto &[what, mesh, facets, area] : cases) {
        Joined j(mesh);
        EXPECT_EQ(j.model->chartCount, 1) << what;
        EXPECT_EQ(j.model->facetCount, facets) << what;
        EXPECT_NEAR(j.facetsArea(), area, 1e-3) << what;
        EXPECT_NEAR(j.model->charts[0].n.y, 1, 1e-6f) << what;
    }
}

TEST(Regions, OtherMaterialsBendsAndBacksStayApart) {
    Mesh mesh = grid(4, 1, [](int, int) { return false; });
    mesh.materials.push_back({"other", {0.2f, 0.2f, 0.2f}, {}});
    mesh.triangles[6].material = mesh.triangles[7].material = 1; // the last square
    EXPECT_EQ(Joined(mesh).model->chartCount, 2);
    mesh.points[0][1] = mesh.points[5][1] = 0.01; // the first square, tilted
    Joined three(mesh);
    EXPECT_EQ(three.model->chartCount, 3);
    EXPECT_NEAR(three.facetsArea(), 4, 1e-3);
    std::swap(mesh.triangles[2].corners[0], mesh.triangles[2].corners[1]); // half of the second: reversed
    EXPECT_EQ(Joined(mesh).model->chartCount, 5); // its other half touches the rest only at a corner
}

// Makes a mesh lit from both sides, as `--two-sided` does.
static void addBacks(Mesh &mesh) {
    for (size_t i = mesh.triangles.size(); i-- > 0;) {
        Triangle back = mesh.triangles[i];
        std::swap(back.corners[1], back.corners[2]);
        mesh.triangles.push_back(back);
    }
}

TEST(Regions, FrontsJoinFrontsAndBacksBacks) {
    Mesh mesh = grid(9, 9, [](int i, int k) { return i >= 3 && i < 6 && k >= 2 && k < 5; });
    addBacks(mesh);
    Joined j(mesh);
    ASSERT_EQ(j.model->chartCount, 2);
    EXPECT_EQ(j.model->facetCount, 8);
    EXPECT_NEAR(j.facetsArea(), 2 * 72, 1e-3);
    EXPECT_NEAR(j.model->charts[0].n.y * j.model->charts[1].n.y, -1, 1e-6f);
    for (size_t i = 0; i < mesh.triangles.size(); ++i)
        EXPECT_GT((double)j.model->charts[j.regions.chartOf[i]].n.y * normalOf(mesh, mesh.triangles[i]).y, 0);
}

// Regions end where two planes cross, because light changes there.
TEST(Regions, PlanesThatCrossAreCutThere) {
    Mesh mesh = grid(2, 1, [](int, int) { return false; });
    mesh.points.insert(mesh.points.end(), {{1, 1, 0}, {1, 1, -1}, {1, -1, 0}, {1, -1, -1}}); // from 6 on
    mesh.triangles.insert(mesh.triangles.end(),
                          {{{1, 4, 7}, 0}, {{1, 7, 6}, 0}, {{1, 9, 4}, 0}, {{1, 8, 9}, 0}});
    EXPECT_EQ(Joined(mesh).model->chartCount, 4);
    addBacks(mesh);
    EXPECT_EQ(Joined(mesh).model->chartCount, 8);
}

TEST(Regions, WhatIsNotMadeOfRectanglesKeepsItsTriangles) {
    Mesh mesh = grid(2, 2, [](int, int) { return false; });
    mesh.points[4] = {0.8, 0, -0.9}; // the middle point, moved; the outline stays a square
    EXPECT_EQ(Joined(mesh).model->facetCount, 1);
    mesh.points[8] = {2.5, 0, -2.4}; // a corner pulled out
    Joined askew(mesh);
    EXPECT_EQ(askew.model->chartCount, 1);
    EXPECT_EQ(askew.model->facetCount, 8);
    EXPECT_NEAR(askew.facetsArea(), 4.45, 1e-3); // by the shoelace formula
}

// The number of elements along a chart's side is limited. A note reports when this makes them longer.
TEST(Solution, ReportsWhereElementsAreLongerThanAsked) {
    Workers workers = serialWorkers();
    for (int length : {kMaxAcross, kMaxAcross + 10}) {
        Mesh mesh = grid(length, 1, [](int, int) { return false; });
        mesh.materials.push_back({"lamp", {}, {1, 1, 1}});
        int first = (int)mesh.points.size();
        mesh.points.insert(mesh.points.end(), {{0, 2, 0}, {0, 2, -1}, {1, 2, 0}});
        mesh.triangles.push_back({{first, first + 1, first + 2}, 1});
        SolveSettings s;
        s.element = 1;
        Solved solved = solveModel(mesh, s, headlessGl(), workers, &kNever, {});
        EXPECT_EQ(solved.report.notes.size(), length > kMaxAcross ? 1u : 0u);
        EXPECT_EQ(solved.solution.charts[0].across, kMaxAcross);
    }
}
