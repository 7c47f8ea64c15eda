// Compares every float of each function's stated range with libm in double precision: the errors must not
// exceed those stated in base/maths.h. With ODRAZ_EVERY=N in the environment it tests one group of eight in
// N, which takes seconds.
#include "base/maths.h"
#include "tests/support/figure.h"

#include <atomic>
#include <cstdlib>

using namespace odraz;

static uint64_t step() {
    const char *every = std::getenv("ODRAZ_EVERY");
    return 8 * std::max<uint64_t>(1, every ? std::strtoull(every, nullptr, 10) : 1);
}

// Returns the largest excess(x), where x has eight lanes, over all floats with bits in [first, last]. Uses
// all cores.
template <class Excess> double worst(uint32_t first, uint32_t last, Excess excess) {
    unsigned count = std::max(1u, std::thread::hardware_concurrency());
    std::atomic<uint64_t> next{first};
    std::vector<double> most(count, -1);
    std::vector<std::thread> threads;
    for (unsigned t = 0; t < count; ++t)
        threads.emplace_back([&, t] {
            constexpr uint64_t kBlock = 1 << 20;
            const uint64_t eights = step();
            for (uint64_t begin; (begin = next.fetch_add(kBlock)) <= last;)
                for (uint64_t i = begin; i < begin + kBlock && i <= last; i += eights) {
                    // Lanes beyond the range repeat its last float
                    int32_t end = (int32_t)std::min<uint64_t>(7, last - i);
                    Float8 x = fromBits(select(kLanes < end, kLanes, broadcast(end)) + (int32_t)(uint32_t)i);
                    most[t] = std::max(most[t], excess(x));
                }
        });
    for (std::thread &t : threads) t.join();
    return *std::max_element(most.begin(), most.end());
}

// Returns the largest |y - right(x)| / bound(right(x)) of eight lanes.
template <class Right, class Bound> double largestError(Float8 x, Float8 y, Right right, Bound bound) {
    double most = 0;
    for (int k = 0; k < 8; ++k) {
        double exact = right((double)x[k]);
        most = std::max(most, std::fabs((double)y[k] - exact) / bound(exact));
    }
    return most;
}
template <class Right> double absoluteError(Float8 x, Float8 y, Right right) {
    return largestError(x, y, right, [](double) { return 1.; });
}

constexpr uint32_t kSign = 0x80000000u;
static uint32_t of(float x) { return (uint32_t)bits(x); }

// Tests positive arguments. Negative ones follow by symmetry, which is checked for each of them.
template <class Own, class Library> static void expectPeriodic(Own own, Library library, float sign) {
    double found = worst(0, of(8192), [&](Float8 x) { return absoluteError(x, own(x), library); });
    expectAtMost("largest error", found, 1.0e-7);
    EXPECT_EQ(worst(0, of(8192), [&](Float8 x) { return any(own(-x) != sign * own(x)) ? 1. : 0.; }), 0);
}
TEST(Exhaustive, sin) {
    expectPeriodic([](Float8 x) { return sin(x); }, [](double x) { return std::sin(x); }, -1);
}
TEST(Exhaustive, cos) {
    expectPeriodic([](Float8 x) { return cos(x); }, [](double x) { return std::cos(x); }, 1);
}

TEST(Exhaustive, acos) {
    auto library = [](double x) { return std::acos(x); };
    for (uint32_t sign : {0u, kSign}) {
        double found =
            worst(sign, sign | of(1), [&](Float8 x) { return absoluteError(x, acos(x), library); });
        expectAtMost(sign ? "largest error below 0" : "largest error above 0", found, 4.5e-7);
    }
}

TEST(Exhaustive, exp2) {
    auto relative = [](Float8 x) {
        auto library = [](double v) { return std::exp2(v); };
        return largestError(x, exp2(x), library, [](double right) { return right; });
    };
    expectAtMost("largest relative error above 0", worst(0, of(127.999f), relative), 1.5e-7);
    expectAtMost("largest relative error below 0", worst(kSign, of(-126.f), relative), 1.5e-7);
}

TEST(Exhaustive, log2) {
    auto excess = [](Float8 x) {
        auto library = [](double v) { return std::log2(v); };
        return largestError(x, log2(x), library,
                            [](double right) { return 1.2e-7 + 1.2e-7 * std::fabs(right); });
    };
    expectAtMost("share of the bound", worst(of(1.17549435e-38f), of(3.4028234e38f), excess), 1);
}

// There are too many pairs of arguments to test all. This tests every x of [2^-20, 2], with the exponents of
// the film and some near them.
TEST(Exhaustive, pow) {
    for (float y : {1 / 2.4f, 1.f, 5.f, 20.f, 64.f, 400.f}) {
        auto excess = [y](Float8 x) {
            Float8 p = pow(x, y);
            double most = 0;
            for (int k = 0; k < 8; ++k) {
                double exponent = y * std::log2((double)x[k]);
                if (std::fabs(exponent) > 126) continue;
                double right = std::exp2(exponent);
                most = std::max(most, std::fabs(p[k] - right) / right / (2.5e-7 * (1 + std::fabs(exponent))));
            }
            return most;
        };
        expectAtMost("exponent " + testing::PrintToString(y), worst(of(1.f / 1048576), of(2.f), excess), 1);
    }
}
