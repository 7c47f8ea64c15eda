// Tests that glare neither loses nor makes light, whatever the size of the picture. (test_pictures.py tests
// that it is the same for every number of threads.)
#include "tests/support/threads.h"
#include "tools/support/heap_arena.h"
#include "trace/picture/development.h"
#include "trace/picture/glare.h"

using namespace odraz;

struct Glaring {
    HeapArena memory;
    Frame frame;
    Glare glare;

    Glaring(int width, int height)
        : memory(glareBytes(width, height) + ((size_t)width + 8) * (size_t)height * 16 + 8192) {
        EXPECT_TRUE(makeFrame(frame, memory.arena, width, height) &&
                    makeGlare(glare, memory.arena, width, height));
    }
    float &at(int c, int x, int y) { return frame.plane[c][y * frame.stride + x]; }
    void spread(int threads = 2) {
        Threads pool(threads);
        spreadGlare(glare, frame, pool.workers);
    }
    void fill(float r, float g, float b) {
        const float colour[3] = {r, g, b};
        for (int c = 0; c < 3; ++c)
            std::fill_n(frame.plane[c], (size_t)frame.stride * (size_t)frame.height, colour[c]);
    }
    // Returns the spread light, row by row, with `ends` more pixels at both ends of each row, which repeat
    // the border.
    std::vector<float> spreadLight(int c, int ends = 0) const {
        std::vector<float> all;
        const Glare::Level &l = glare.level[1];
        for (int y = 0; y < l.height; ++y)
            all.insert(all.end(), l.plane[c] + y * l.stride - ends,
                       l.plane[c] + y * l.stride + l.width + ends);
        return all;
    }
    double sum(int c) const {
        std::vector<float> all = spreadLight(c);
        return std::accumulate(all.begin(), all.end(), 0.) * 16; // a texel has 16 pixels
    }
};

const std::pair<int, int> kGlareSizes[] = {{1, 1},  {2, 3},    {17, 9},    {64, 1},
                                           {1, 64}, {333, 97}, {320, 180}, {1280, 720}};

TEST(Glare, LeavesAnEvenPictureAsItIs) {
    for (auto [width, height] : kGlareSizes) {
        Glaring h(width, height);
        h.fill(0.3f, 1.3f, 2.3f);
        h.spread();
        for (int c = 0; c < 3; ++c)
            for (float v : h.spreadLight(c, 1)) ASSERT_NEAR(v, 0.3f + (float)c, 2e-6 * (1 + c)) << width;
    }
}

TEST(Glare, SpreadsWhatThereIsAndNoMore) {
    for (auto [x, y] : {std::pair{640, 360}, {641, 363}, {703, 312}, {500, 400}}) {
        Glaring h(1280, 720);
        h.at(1, x, y) = 1000;
        h.spread();
        EXPECT_NEAR(h.sum(1), 1000, 20); // the widest circles reach the picture's edges
        EXPECT_EQ(h.sum(0), 0);
        // The light falls with distance, equally on both sides
        const Glare::Level &l = h.glare.level[1];
        auto ring = [&](int by) {
            double all = 0;
            for (int dx : {-by, by})
                for (int dy : {-by, by}) all += l.plane[1][(y / 4 + dy) * l.stride + x / 4 + dx];
            return all;
        };
        for (int by = 2; by <= 32; by *= 2) EXPECT_GT(ring(by / 2), 1.5 * ring(by)) << by;
        EXPECT_GT(ring(32), 0);
    }
}

// Development shows the direct light of each pixel plus the spread light that it receives.
TEST(Glare, IsSeenInTheDevelopedPicture) {
    Glaring h(256, 128);
    h.fill(0.2f, 0.2f, 0.2f);
    Threads pool(2);
    auto curve = std::make_unique<ToneCurve>();
    makeToneCurve(*curve);
    auto developed = [&](const Glare *glare, const CameraLook &look) {
        develop(*curve, h.frame, pool.workers, 1, 3, glare, look);
        return std::vector<uint8_t>(h.frame.rgba, h.frame.rgba + 256 * 128 * 4);
    };
    std::vector<uint8_t> plain = developed(nullptr, kPlainLook);
    h.spread();
    EXPECT_EQ(developed(&h.glare, {0.3f, 0, 0}), plain); // an even picture: nothing to see
    // A lamp in the middle: there is light around it, hardly any far away
    h.at(0, 128, 64) = 1e4f;
    h.spread();
    std::vector<uint8_t> lamp = developed(&h.glare, {0.05f, 0, 0});
    auto at = [&](const std::vector<uint8_t> &p, int x, int y) {
        return (int)p[((size_t)y * 256 + (size_t)x) * 4];
    };
    EXPECT_GT(at(lamp, 132, 68), at(plain, 132, 68) + 40);
    EXPECT_LT(at(lamp, 132, 68), 256);
    EXPECT_GT(at(lamp, 132, 68), at(lamp, 190, 68) + 20);
    h.at(0, 128, 64) = 0.2f;
    // Corners darken, the middle does not
    std::vector<uint8_t> dark = developed(nullptr, {0, 0.5f, 0});
    EXPECT_NEAR(at(dark, 128, 64), at(plain, 128, 64), 1);
    EXPECT_LT(at(dark, 0, 0), at(plain, 0, 0) - 25);
    EXPECT_NEAR(at(dark, 0, 0), at(dark, 255, 127), 2);
    // Grain has the width given and the right mean, equal in all colours; white and black stay in range
    std::vector<uint8_t> grain = developed(nullptr, {0, 0, 96});
    double sum = 0, square = 0;
    int most = 0;
    for (size_t i = 0; i < grain.size(); i += 4) {
        int d = grain[i] - plain[i];
        sum += d, square += d * d, most = std::max(most, std::abs(d));
    }
    double count = (double)grain.size() / 4;
    EXPECT_NEAR(sum / count, 0, 0.05);
    EXPECT_NEAR(std::sqrt(square / count), 3 / std::sqrt(6.), 0.15); // a triangular distribution, rounded
    EXPECT_LE(most, 3);
    for (float v : {0.f, 1e9f}) {
        h.fill(v, v, v);
        for (uint8_t byte : developed(nullptr, {0, 0, 96}))
            ASSERT_TRUE(v > 0 ? byte > 250 : byte < 4 || byte == 255);
    }
}
