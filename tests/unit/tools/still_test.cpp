// Where a film stands still, from how much each second differs from the one before.
#include "tools/measure/detect/still.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace odraz;
using namespace odraz::measure;

static std::vector<std::pair<int, int>> pieces(const std::vector<double> &changes) {
    std::vector<std::pair<int, int>> all;
    for (const Piece &p : stillPieces(changes, 4, 1)) all.push_back({p.from, p.to});
    return all;
}
using Pieces = std::vector<std::pair<int, int>>;

TEST(Still, NeedsFourSecondsInOnePiece) {
    EXPECT_EQ(pieces({}), Pieces{});
    EXPECT_EQ(pieces({0, 0}), Pieces{});
    EXPECT_EQ(pieces({0, 0, 0}), (Pieces{{0, 4}}));
    EXPECT_EQ(pieces({9, 0, 0, 9, 0, 0, 9}), Pieces{});
    EXPECT_EQ(pieces({9, 0, 0, 0, 0, 9, 9, 0, 0, 0}), (Pieces{{1, 6}, {7, 11}}));
}

TEST(Still, TheMeanOfFourSecondsCounts) {
    EXPECT_EQ(pieces({9, 0.5, 1.5, 0.5, 9}), (Pieces{{1, 5}}));
    EXPECT_EQ(pieces({9, 1, 1, 1, 9}), Pieces{});
    EXPECT_EQ(pieces({1.5, 0, 1.4, 0, 1.5}), (Pieces{{0, 6}}));
}

TEST(Still, WhatIsLeftOutEndsAPiece) {
    double out = std::nan("");
    EXPECT_EQ(pieces({0, 0, out, 0, 0}), Pieces{});
    EXPECT_EQ(pieces({0, 0, 0, out, 0, 0, 0}), (Pieces{{0, 4}, {4, 8}}));
}
