// Tests the light shown during solving: it starts with direct light, grows, and ends with the solution.
#include "tests/support/read_model.h"
#include "tools/radiosity/solve/solve.h"
#include "tools/support/machine.h"

using namespace odraz;
using namespace odraz::radiosity;

static double sumOf(const std::vector<Rgb> &light) {
    return std::accumulate(light.begin(), light.end(), 0.,
                           [](double sum, const Rgb &c) { return sum + (double)(c.x + c.y + c.z); });
}

// The largest difference of a channel between a and b, as a share of the brightest channel of b.
static double largestDifference(const std::vector<Rgb> &a, const std::vector<Rgb> &b) {
    EXPECT_EQ(a.size(), b.size());
    float most = 0, off = 0;
    for (size_t i = 0; i < a.size() && i < b.size(); ++i) {
        Rgb d = a[i] - b[i];
        most = max(most, maxComponent(b[i]));
        off = max(off, max(maxComponent(d), maxComponent(-d)));
    }
    return (double)off / (double)most;
}

struct Watched {
    std::vector<std::vector<Rgb>> light; // the light of each call, in order
    std::vector<Rgb> end;
};

static Watched watch(const char *kind, SolveSettings s = {}) {
    Watched watched;
    s.watcher = [&](const auto &light) { watched.light.push_back(light().light); };
    Workers workers = serialWorkers();
    watched.end = solveModel(generatedMesh(kind), s, {}, workers, &kNever, {}).solution.light;
    return watched;
}

TEST(LightSoFar, BeginsDirectAndEndsAsTheSolution) {
    Watched g = watch("cube");
    ASSERT_GT(g.light.size(), 5u);
    for (size_t i = 0; i < g.light.size(); ++i) {
        ASSERT_EQ(g.light[i].size(), g.end.size());
        // Hidden corners may get darker while visible ones get brighter
        EXPECT_GT(sumOf(g.light[i]), i ? sumOf(g.light[i - 1]) * 0.99999 : 0) << i;
    }
    EXPECT_LT(sumOf(g.light[0]), 0.8 * sumOf(g.end));
    EXPECT_LT(largestDifference(g.light.back(), g.end), 1e-3);
    EXPECT_GT(largestDifference(g.light[1], g.end), 1e-2);
}

TEST(LightSoFar, ShowsDirectLightAloneFirst) {
    SolveSettings s;
    s.bounces = 0;
    Watched none = watch("corner", s);
    s.bounces = 3;
    Watched three = watch("corner", s);
    ASSERT_EQ(three.light.size(), 4u);
    // Without a bounce, direct light remains
    EXPECT_LT(largestDifference(three.light[0], none.end), 1e-6);
    EXPECT_LT(largestDifference(three.light[3], three.end), 1e-6);
}
