// Tests pictures that are traced in fewer pixels: they equal the pictures of a smaller film, scaled up, in
// any order. Also tests in-betweens of them.
#include "inside.h"
#include "tests/support/loaded_film.h"
#include "tests/support/pictures.h"
#include "tools/picture/psnr.h"
#include "trace/picture/enlarge.h"

using namespace odraz;

constexpr int kTracedWidth = 320, kTracedHeight = 180;
constexpr double kAtTable = 25, kAtFlake = 53, kAtCredits = 156; // the last one has letters

struct Loaded : LoadedFilm {
    Loaded(int width, int height, bool pairs) : LoadedFilm(2, width, height, pairs) {}
    std::vector<uint8_t> at(double seconds, TracedSize traced = {}, int slot = 0) {
        return bytesOf(picture(*intro, slot, seconds, named(QualityName::Draft), nullptr, traced));
    }
};

TEST(TracedSize, IsASmallerFilmScaledUp) {
    for (bool pairs : {false, true})
        for (TracedSize size : {TracedSize{160, 90}, {240, 135}, {319, 180}, {320, 177}}) {
            Loaded large(kTracedWidth, kTracedHeight, pairs), small(size.width, size.height, pairs);
            for (double seconds : {kAtTable, kAtCredits}) {
                std::vector<uint8_t> less = small.at(seconds),
                                     expected((size_t)(kTracedWidth * kTracedHeight * 4));
                less.resize(less.size() + 32);
                enlarge(less.data(), size.width, size.height, expected.data(), kTracedWidth, kTracedHeight,
                        large.threads.workers);
                EXPECT_TRUE(large.at(seconds, size) == expected) << size.width << ' ' << seconds;
            }
        }
}

TEST(TracedSize, LeavesNothingBehind) {
    Loaded film(kTracedWidth, kTracedHeight, true);
    for (double seconds : {kAtTable, kAtCredits}) {
        std::vector<uint8_t> before = film.at(seconds);
        film.at(seconds + 0.1, {160, 90});
        film.at(seconds + 0.2, {240, 135}, 1);
        between(*film.intro, 0, 1);
        EXPECT_TRUE(film.at(seconds) == before) << seconds;
    }
}

// The two times differ in their last bit.
TEST(TracedSize, AMomentHasItsOwnGrainHoweverItIsRounded) {
    Loaded film(kTracedWidth, kTracedHeight, false);
    EXPECT_TRUE(film.at(1551 / 60.0) == film.at(1551 * (1 / 60.0)));
}

// When the player changes the size, an in-between is made from pictures of two sizes. Its PSNR is at most
// 2 dB less than with equal sizes: one size may miss a line of the word's image in the marble, or an edge
// that a ball of the flake mirrors. Such a picture is shown for a sixtieth of a second.
TEST(TracedSize, InBetweensMayHaveTwo) {
    Loaded film(kTracedWidth, kTracedHeight, true);
    for (double seconds : {kAtTable, kAtFlake, kAtCredits}) {
        auto made = [&](TracedSize before, TracedSize after) {
            film.at(seconds - 1 / 60., before, 0);
            film.at(seconds + 1 / 60., after, 1);
            return bytesOf(between(*film.intro, 0, 1));
        };
        std::vector<uint8_t> truth = film.at(seconds, {}, 0);
        double alike = pictures::psnr(made({304, 171}, {304, 171}), truth);
        EXPECT_GT(pictures::psnr(made({304, 171}, {312, 176}), truth), alike - 2) << seconds;
        EXPECT_GT(pictures::psnr(made({312, 176}, {304, 171}), truth), alike - 2) << seconds;
    }
}
