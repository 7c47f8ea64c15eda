// The main() of a room's tests. `show_tests` runs all of them, `show_tests score_test` only the tests of
// score_test.cpp.
#include <cstdio>

int main(int argc, char **argv) {
    testing::InitGoogleTest(&argc, argv);
    if (argc > 1) {
        std::string filter;
        const testing::UnitTest &all = *testing::UnitTest::GetInstance();
        for (int s = 0; s < all.total_test_suite_count(); ++s) {
            const testing::TestSuite &suite = *all.GetTestSuite(s);
            for (int i = 0; i < suite.total_test_count(); ++i) {
                const testing::TestInfo &test = *suite.GetTestInfo(i);
                if (std::filesystem::path(test.file()).stem() == argv[1])
                    filter += std::string(suite.name()) + "." + test.name() + ":";
            }
        }
        if (filter.empty()) return std::fprintf(stderr, "there is no test file %s.cpp\n", argv[1]), 2;
        GTEST_FLAG_SET(filter, filter);
    }
    return RUN_ALL_TESTS();
}
