// Light that is shown while it is solved: it begins with direct light, grows, and ends as the solution.
#include "tests/support/headless_gl.h"
#include "tools/common/machine.h"
#include "tools/measure/measured.h"
#include "tools/radiosity/baked.h"
#include "tools/radiosity/growing.h"

#include <algorithm>
#include <cmath>

using namespace odraz;

namespace {

double sumOf(const std::vector<Rgb> &light) {
    double sum = 0;
    for (const Rgb &c : light) sum += (double)(c.x + c.y + c.z);
    return sum;
}

struct Grown {
    std::vector<std::vector<Rgb>> light; // as it was shown
    std::vector<Rgb> end;
    int directs = 0;
};

Grown grow(const char *kind, BakeSettings s) {
    Grown grown;
    s.growing = [&](const Bake &b, const float *radiosity) {
        grown.directs += !radiosity;
        grown.light.push_back(lightSoFar(b, radiosity));
    };
    Workers workers = serialWorkers();
    auto b = bake(generatedMesh(kind, 0), s, headlessGl(), workers, &kNever, {});
    grown.end = Baked(*b).light;
    return grown;
}

// The largest difference of two, as a share of the brightest light.
double apart(const std::vector<Rgb> &a, const std::vector<Rgb> &b) {
    double most = 0, off = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        most = std::max(most, (double)maxComponent(b[i]));
        off = std::max({off, std::fabs((double)(a[i].x - b[i].x)), std::fabs((double)(a[i].y - b[i].y)),
                        std::fabs((double)(a[i].z - b[i].z))});
    }
    return off / most;
}

} // namespace

TEST(Growing, BeginsDirectAndEndsAsTheSolution) {
    for (bool analytic : {true, false})
        for (bool adaptive : {false, true}) {
            BakeSettings s;
            s.analytic = analytic;
            s.adaptive = adaptive;
            s.way = analytic && !adaptive ? Way::kRays : Way::kPatches;
            Grown g = grow("cube", s);
            ASSERT_GT(g.light.size(), 5u);
            EXPECT_EQ(g.directs, s.way == Way::kPatches ? 1 : (int)g.light.size());
            for (size_t i = 0; i < g.light.size(); ++i) {
                ASSERT_EQ(g.light[i].size(), g.end.size());
                // Hidden corners may lose what visible ones gain
                if (i > 0) {
                    EXPECT_GT(sumOf(g.light[i]), sumOf(g.light[i - 1]) * 0.99999) << i;
                }
            }
            EXPECT_LT(sumOf(g.light[0]), 0.8 * sumOf(g.end));
            EXPECT_LT(apart(g.light.back(), g.end), 1e-3);
            EXPECT_GT(apart(g.light[1], g.end), 1e-2);
        }
}

TEST(Growing, ShowsDirectLightAloneFirst) {
    for (Way way : {Way::kRays, Way::kPatches}) {
        BakeSettings s;
        s.way = way;
        s.bounces = 0;
        Grown none = grow("corner", s);
        s.bounces = 3;
        Grown three = grow("corner", s);
        ASSERT_EQ(three.light.size(), 4u);
        // Without a bounce there is still what patches get of nothing: direct light
        EXPECT_LT(apart(three.light[0], none.end), 1e-6);
        EXPECT_LT(apart(three.light[3], three.end), 1e-6);
    }
}
