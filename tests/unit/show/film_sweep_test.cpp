// Tests the whole film, four pictures a second, in draft and in film. No value is NaN, infinite or negative.
// No picture is black, except in a fade and on the last beat, and none equals the one before.
#include "inside.h"
#include "tests/support/loaded_film.h"
#include "tests/support/pictures.h"

using namespace odraz;

constexpr int kWidth = 320, kHeight = 180;

static void expectValidPictures(QualityName quality) {
    LoadedFilm film(1, kWidth, kHeight, false, &headlessGl());
    Intro *intro = film.intro;
    double before = -1;
    for (double t = 0; t < duration(); t += 0.25) {
        picture(*intro, 0, t, kQualities[(int)quality]);
        double sum = 0;
        for (float v : planesOf(intro->frame)) {
            ASSERT_TRUE(v >= 0 && v < 1e6f) << t << " s: " << v;
            sum += (double)v;
        }
        // Include the exposure: the hall at night is dark, with a high exposure
        double exposure = (double)intro->film.scene->exposure,
               mean = sum / (3. * kWidth * kHeight) * exposure,
               fade = (double)momentAt(kFilm, t * kRowsPerSecond).fade;
        if (fade > 0.05) {
            // (The point of light may be all that is seen, as when the door has died)
            EXPECT_GT(mean / fade, 0.00002) << t << " s is black";
            EXPECT_NE(mean, before) << t << " s equals the picture before";
        }
        before = mean;
    }
}
TEST(Film, EveryPictureOfDraftIsValid) { expectValidPictures(QualityName::Draft); }
TEST(Film, EveryPictureOfFilmIsValid) { expectValidPictures(QualityName::Film); }

// The last ball mirrors the word. Its strokes are one or two pixels wide, and even
// draft shows all of them.
TEST(Film, WordInTheBallIsWhole) {
    LoadedFilm film(1, 1280, 720, false, &headlessGl());
    Intro *intro = film.intro;
    const Frame &f = intro->frame;
    auto glows = [&](int x, int y) { return f.plane[0][y * f.stride + x] > 0.7f; };
    for (double t : {145.5, 146.5, 147.5}) {
        picture(*intro, 0, t, kQualities[(int)QualityName::Film]);
        std::vector<std::pair<int, int>> word;
        // Collect the word's pixels, above its reflection in the floor
        for (int y = 360; y < 460; ++y)
            for (int x = 480; x < 800; ++x)
                if (glows(x, y)) word.push_back({x, y});
        picture(*intro, 0, t, kQualities[(int)QualityName::Draft]);
        size_t lost = 0;
        for (auto [x, y] : word) {
            bool near = false;
            for (int k = 0; k < 9; ++k) near |= glows(x + k % 3 - 1, y + k / 3 - 1);
            lost += !near;
        }
        EXPECT_GT(word.size(), 200u) << t;
        EXPECT_LT((double)lost, 0.01 * (double)word.size()) << t;
    }
}
