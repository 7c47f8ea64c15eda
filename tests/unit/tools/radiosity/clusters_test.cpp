// Tests clustered PCA on data with known singular values or structure, and on extreme data.
#include "tools/radiosity/transfer/clusters.h"

#include "tests/support/dice.h"

using namespace odraz;
using namespace odraz::radiosity;

struct Data {
    int rows, columns;
    std::vector<float> values;
    Data(int rows, int columns) : rows(rows), columns(columns), values((size_t)rows * (size_t)columns) {}
    template <class Of> Data(int rows, int columns, Of of) : Data(rows, columns) {
        for (int r = 0; r < rows; ++r)
            for (int c = 0; c < columns; ++c) at(r, c) = of(r, c);
    }
    float &at(int r, int c) { return values[(size_t)r * (size_t)columns + (size_t)c]; }
    float at(int r, int c) const { return values[(size_t)r * (size_t)columns + (size_t)c]; }
};

struct Result : Clusters {
    double error = 0, size = 0; // squared Frobenius norms

    Result(
        const Data &d, const ClusterSettings &settings,
        int (*seed)(int row, int count) = [](int row, int count) { return row % count; }) {
        std::vector<int> seeds;
        for (int r = 0; r < d.rows; ++r) seeds.push_back(seed(r, settings.count));
        Workers workers = serialWorkers();
        std::vector<float> even((size_t)d.columns, 1.f);
        (Clusters &)*this = findClusters(d.values, d.columns, even, std::move(seeds), settings, workers);
        for (int r = 0; r < d.rows; ++r) {
            int cluster = of[(size_t)r];
            EXPECT_TRUE(cluster >= 0 && cluster < count);
            for (int c = 0; c < d.columns; ++c) {
                double v = (double)axesOf(cluster)[c], exact = (double)d.at(r, c);
                for (int k = 0; k < rank; ++k)
                    v += (double)weights[(size_t)(r * rank + k)] *
                         (double)axesOf(cluster)[(1 + k) * d.columns + c];
                EXPECT_TRUE(std::isfinite(v));
                error += (v - exact) * (v - exact), size += exact * exact;
            }
        }
    }
    double percent() const { return 100 * std::sqrt(error / size); }
};

// The singular values of falling(): their number, at most 40, and value k. They halve after each `half`
// values.
static int countOf(int rows, int columns) { return std::min({40, rows - 1, columns - 1}); }
static double valueOf(int k, double half) { return 12 * std::exp2(-k / half); }

// Makes rows about a mean. Singular vector k is a cosine, along rows and along columns. The cosines are
// orthonormal, and each sums to 0.
static Data falling(int rows, int columns, double half) {
    auto wave = [](int k, int i, int size) {
        return std::sqrt(2. / size) * std::cos(M_PI * (k + 1) * (i + 0.5) / size);
    };
    return {rows, columns, [&](int r, int c) {
                double sum = 3 + c * 0.1; // the mean
                for (int k = 0; k < countOf(rows, columns); ++k)
                    sum += valueOf(k, half) * wave(k, r, rows) * wave(k, c, columns);
                return (float)sum;
            }};
}

// Returns the squared error of the best mean and subspace.
static double bestLeft(const Data &d, double half, int dimensions) {
    double left = 0;
    for (int k = dimensions; k < countOf(d.rows, d.columns); ++k) left += std::pow(valueOf(k, half), 2);
    return left;
}

// Makes several flats (affine subspaces) with four dimensions each and distant means. Rows alternate between
// them.
static Data flats(int count, int rows, int columns) {
    Data d(rows, columns);
    Dice dice(9);
    Data basis(count * 5, columns, [&](int f, int) { return dice(-0.5f, 0.5f) * (f % 5 ? 1.f : 4.f); });
    for (int r = 0; r < rows; ++r)
        for (int k = 0; k < 5; ++k) {
            float weight = k ? dice(-0.5f, 0.5f) : 1;
            for (int c = 0; c < columns; ++c) d.at(r, c) += weight * basis.at(r % count * 5 + k, c);
        }
    return d;
}

// The last case has more columns than rows, like the floor's matrices.
TEST(Pca, LeavesNoMoreThanTheBestSubspace) {
    for (double half : {1., 3., 10., 4.})
        for (int dimensions : {8, 16, 24}) {
            Data d = half == 4 ? falling(60, 2000, half) : falling(300, 64, half);
            Result r(d, {.count = 1, .rank = dimensions, .rounds = 0, .iterations = 12});
            double best = bestLeft(d, half, dimensions), noise = r.size * 1e-13; // rounding
            EXPECT_LT(r.error, best * 1.05 + noise); // so the rms error is at most 2.5 % more
            EXPECT_GT(r.error, best * 0.999 - noise);
        }
}

TEST(Pca, AxesAreOrthonormal) {
    Data d = falling(300, 64, 3);
    Result r(d, {.count = 3, .rank = 16});
    for (int c = 0; c < 3; ++c)
        for (int a = 1; a <= 16; ++a)
            for (int b = 1; b <= a; ++b) {
                const float *u = r.axesOf(c) + a * 64, *v = r.axesOf(c) + b * 64;
                EXPECT_NEAR(std::inner_product(u, u + 64, v, 0.), a == b, 1e-5);
            }
}

// Clustering finds the flats although a third of the rows have wrong seeds. One subspace with the
// same number of axes cannot represent them.
TEST(Clustering, FindsTheFlats) {
    Data d = flats(4, 400, 48);
    ClusterSettings settings = {.count = 4, .rank = 8, .rounds = 8, .iterations = 4, .tried = 4};
    auto seed = [](int row, int) { return row % 3 ? row % 4 : (row / 3) % 4; };
    Result found(d, settings, seed);
    settings.rounds = 0;
    Result blocks(d, settings, seed), one(d, {.count = 1, .rank = 8, .rounds = 0, .iterations = 12});
    EXPECT_LT(found.percent(), 0.01);
    EXPECT_GT(one.percent(), 5);
    EXPECT_GT(blocks.percent(), 1);
}

// More rounds never increase the error.
TEST(Clustering, Descends) {
    Data d = falling(400, 64, 20);
    double last = 1e30;
    for (int rounds = 0; rounds < 6; ++rounds) {
        Result r(d, {.count = 8, .rank = 8, .rounds = rounds, .iterations = 8, .tried = 7},
                 [](int row, int) { return row / 50; });
        EXPECT_LT(r.error, last * 1.005) << rounds;
        last = r.error;
    }
}

TEST(Extremes, AreHeldExactly) {
    const std::tuple<const char *, Data, int, int, double> cases[] = {
        {"rows that are equal", {100, 24, [](int, int c) { return (float)c * 0.37f - 2; }}, 4, 8, 1e-4},
        {"nothing but zero", {50, 16}, 2, 8, 0},
        {"one row", {1, 8, [](int, int c) { return (float)c; }}, 1, 8, 0},
        {"more clusters than rows", falling(10, 16, 3), 40, 8, 1e-4},
        {"four dimensions where 16 are asked for", flats(1, 100, 40), 2, 16, 1e-3},
        {"one dimension", {60, 16, [](int r, int c) { return (float)(r * (c + 1)); }}, 1, 8, 1e-3},
    };
    for (const auto &[what, data, clusters, dimensions, percent] : cases) {
        Result r(data, {.count = clusters, .rank = dimensions});
        EXPECT_LE(std::sqrt(r.error), percent / 100 * std::sqrt(r.size)) << what;
    }
}
