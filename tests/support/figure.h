// Expects a figure of at most a limit. Both are written to the report of --gtest_output=json:FILE, for
// RESULTS.md.
#pragma once

inline void expectAtMost(const std::string &what, double figure, double limit) {
    testing::Test::RecordProperty(what,
                                  testing::PrintToString(figure) + " <= " + testing::PrintToString(limit));
    EXPECT_LE(figure, limit) << what;
}
