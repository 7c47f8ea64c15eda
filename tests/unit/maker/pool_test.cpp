#include "maker/pool.h"

#include <atomic>

using namespace odraz;
using namespace odraz::maker;

// Sums the numbers below `count` in pieces of `size`.
static long sum(Workers &workers, int count, int size) {
    long parts[kMaxWorkers] = {};
    parallelRanges(workers, count, size, [&](int first, int end, int worker) {
        for (int i = first; i < end; ++i) parts[worker] += i;
    });
    long all = 0;
    for (long part : parts) all += part;
    return all;
}

TEST(Pool, DoesAllWorkOnce) {
    for (int threads : {1, 2, 5, kMaxWorkers}) {
        Pool pool(threads);
        EXPECT_EQ(pool.workers().count, threads);
        for (int round = 0; round < 300; ++round)
            ASSERT_EQ(sum(pool.workers(), round, 1 + round % 7), (long)round * (round - 1) / 2);
    }
    EXPECT_EQ(Pool(0).workers().count, 1);
    EXPECT_EQ(Pool(1000).workers().count, kMaxWorkers);
}

// The host's workers crash here, which is why Pool exists.
TEST(Pool, SeveralAtOnce) {
    std::thread others[2];
    std::atomic<int> wrong = 0;
    auto work = [&] {
        Pool pool(3);
        for (int round = 0; round < 500; ++round) wrong += sum(pool.workers(), 100, 3) != 4950;
    };
    for (std::thread &t : others) t = std::thread(work);
    work();
    for (std::thread &t : others) t.join();
    EXPECT_EQ(wrong, 0);
}

TEST(Pool, GivesUp) {
    Pool pool(2);
    std::atomic<int> pieces = 0;
    parallelFor(pool.workers(), 1000000, [&](int, int) {
        if (++pieces == 100) pool.abort();
    });
    EXPECT_TRUE(pool.workers().aborted());
    EXPECT_LT(pieces, 1000000);
}
