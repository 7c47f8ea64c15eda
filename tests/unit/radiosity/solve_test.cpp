// Tests solving for many right-hand sides, against closed forms.
#include "radiosity/solve.h"
#include "tools/engine/heap_arena.h"

#include <gtest/gtest.h>

using namespace odraz;

namespace {

// Two patches that see only each other, for several right-hand sides of increasing reflectance.
struct Facing {
    static constexpr int kUnknowns = 1100;
    HeapArena memory{(size_t)1 << 20};
    Workers workers = serialWorkers();
    Link links[2] = {{1, 1}, {0, 1}};
    FormFactorRow rows[2] = {{links, 1, true}, {links + 1, 1, true}};
    FormFactors factors = {links, rows, 2, 2};
    System s;

    Facing() {
        EXPECT_TRUE(makeSystem(s, memory.arena, factors, 2, kUnknowns));
        for (int i = 0; i < 2 * s.columns; ++i) {
            s.reflectance[i] = reflectance(i % s.columns);
            s.direct[i] = i < s.columns ? 1 : 0;
        }
    }
    static float reflectance(int k) { return k < kUnknowns ? 0.9f * (float)k / kUnknowns : 0; }
};

} // namespace

// B = rho + rho^2 B' and B' = rho B, for any number of right-hand sides.
TEST(Solve, ManyRightHandSidesAtOnce) {
    Facing f;
    solve(f.s, f.workers, 1e-6f, 5000);
    for (int k = 0; k < Facing::kUnknowns; ++k) {
        double rho = (double)Facing::reflectance(k), exact = rho / (1 - rho * rho);
        ASSERT_NEAR((double)f.s.radiosity[k], exact, 1e-5 * exact + 1e-9) << k;
        ASSERT_NEAR((double)f.s.radiosity[f.s.columns + k], rho * exact, 1e-5 * exact + 1e-9) << k;
    }
}
