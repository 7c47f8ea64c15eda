// Compares enlarged pictures with the filter in double precision: no halos, no seams, the same with any
// number of threads.
#include "tests/support/threads.h"
#include "trace/picture/enlarge.h"

using namespace odraz;

constexpr size_t kMargin = 8;

struct Pixels {
    int width, height;
    std::vector<uint8_t> bytes; // with more bytes before and after it, which must not count

    Pixels(int w, int h, uint8_t margin = 0)
        : width(w), height(h), bytes((size_t)w * (size_t)h * 4 + kMargin + 32, margin) {}
    uint8_t *rgba() { return bytes.data() + kMargin; }
    int at(int x, int y, int c) const {
        x = std::clamp(x, 0, width - 1), y = std::clamp(y, 0, height - 1);
        return bytes[kMargin + ((size_t)y * (size_t)width + (size_t)x) * 4 + (size_t)c];
    }
    bool operator==(const Pixels &b) const { return bytes == b.bytes; }
};

static Pixels made(Pixels from, int width, int height, int threads = 1) {
    Threads pool(threads);
    Pixels to(width, height);
    enlarge(from.rgba(), from.width, from.height, to.rgba(), width, height, pool.workers);
    return to;
}

static Pixels noisy(int width, int height, unsigned seed = 1) {
    std::mt19937 random(seed);
    Pixels p(width, height, 255);
    for (uint8_t *v = p.rgba(), *end = v + width * height * 4; v < end; ++v) *v = (uint8_t)(random() & 255);
    return p;
}

struct Tap {
    int first;
    double t;
};
static Tap tapOf(int i, int from, int to) {
    double x = std::clamp((i + 0.5) * from / to - 0.5, 1., from - 3.);
    return {(int)x, x - (int)x};
}
static double cubic(const double (&p)[4], double t) {
    double v =
        p[1] + t / 2 *
                   (p[2] - p[0] +
                    t * (2 * p[0] - 5 * p[1] + 4 * p[2] - p[3] + t * (3 * (p[1] - p[2]) + p[3] - p[0])));
    return std::clamp(v, std::min(p[1], p[2]), std::max(p[1], p[2]));
}
static double exact(const Pixels &from, int width, int height, int x, int y, int c) {
    Tap px = tapOf(x, from.width, width), py = tapOf(y, from.height, height);
    double column[4];
    for (int j = 0; j < 4; ++j) {
        double row[4];
        for (int i = 0; i < 4; ++i) row[i] = from.at(px.first - 1 + i, py.first - 1 + j, c);
        column[j] = cubic(row, px.t);
    }
    return cubic(column, py.t);
}

struct Sizes {
    int width, height, toWidth, toHeight;
};
const Sizes kSizes[] = {{4, 4, 8, 8},          {5, 6, 9, 7},           {640, 360, 1280, 720},
                        {656, 369, 1365, 768}, {1264, 711, 1280, 720}, {8, 300, 8, 301},
                        {333, 5, 2560, 40},    {31, 17, 97, 64},       {1280, 720, 1280, 720}};

// Weights are in 64ths, and rows are rounded to bytes. Noise of full contrast shows the largest errors.
TEST(Enlarge, IsTheCubic) {
    for (const Sizes &s : kSizes) {
        Pixels from = noisy(s.width, s.height), to = made(from, s.toWidth, s.toHeight);
        double worst = 0, square = 0;
        for (int y = 0; y < s.toHeight; ++y)
            for (int x = 0; x < s.toWidth; ++x)
                for (int c = 0; c < 4; ++c) {
                    double off = std::abs(to.at(x, y, c) - exact(from, s.toWidth, s.toHeight, x, y, c));
                    worst = std::max(worst, off);
                    square += off * off;
                }
        EXPECT_LT(worst, 8) << s.width << ' ' << s.toWidth;
        EXPECT_LT(std::sqrt(square / s.toWidth / s.toHeight / 4), 1.6) << s.width << ' ' << s.toWidth;
    }
}

TEST(Enlarge, LeavesAPictureOfTheSameSizeUnchanged) {
    Pixels from = noisy(1000, 77), to = made(from, 1000, 77);
    for (int y = 1; y < 75; ++y)
        for (int x = 1; x < 998; ++x) ASSERT_EQ(from.at(x, y, x % 4), to.at(x, y, x % 4)) << x << ' ' << y;
}

TEST(Enlarge, LeavesAnEvenPictureEven) {
    for (const Sizes &s : kSizes)
        for (int value : {0, 1, 77, 128, 254, 255}) {
            // The surroundings of the picture have another colour
            Pixels from(s.width, s.height, (uint8_t)(255 - value));
            std::fill(from.rgba(), from.rgba() + s.width * s.height * 4, (uint8_t)value);
            Pixels to = made(from, s.toWidth, s.toHeight);
            EXPECT_EQ(std::count(to.rgba(), to.rgba() + s.toWidth * s.toHeight * 4, (uint8_t)value),
                      s.toWidth * s.toHeight * 4)
                << s.toWidth << ' ' << value;
        }
}

// The plain cubic would leave a halo along edges.
TEST(Enlarge, DoesNotRing) {
    Pixels from(100, 100);
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x)
            for (int c = 0; c < 4; ++c) from.rgba()[(y * 100 + x) * 4 + c] = x + y < 100 ? 60 : 200;
    Pixels to = made(from, 173, 173);
    for (int i = 0; i < 173 * 173 * 4; ++i) {
        ASSERT_GE(to.rgba()[i], 60);
        ASSERT_LE(to.rgba()[i], 200);
    }
    // It is sharp: a vertical edge between two pixels gets no wider than two of these pixels
    Pixels edge(64, 8);
    for (int i = 0; i < 64 * 8 * 4; ++i) edge.rgba()[i] = i / 4 % 64 < 32 ? 0 : 255;
    Pixels wide = made(edge, 256, 32);
    EXPECT_EQ(wide.at(32 * 4 - 5, 16, 0), 0);
    EXPECT_EQ(wide.at(32 * 4 + 4, 16, 0), 255);
}

// A slope stays a slope, without stairs where pixels of the smaller picture meet.
TEST(Enlarge, KeepsSlopes) {
    Pixels from(128, 16);
    for (int i = 0; i < 128 * 16 * 4; ++i) from.rgba()[i] = (uint8_t)(i / 4 % 128 * 2);
    Pixels to = made(from, 229, 29);
    for (int x = 3; x < 225; ++x) EXPECT_NEAR(to.at(x, 14, 1), ((x + 0.5) * 128 / 229 - 0.5) * 2, 0.8) << x;
}

TEST(Enlarge, IsTheSameOnAnyNumberOfThreads) {
    Pixels from = noisy(656, 369), one = made(from, 1283, 721);
    for (int threads : {2, 3, 8}) EXPECT_TRUE(made(from, 1283, 721, threads) == one) << threads;
}
