#include "host/cpu.h"
#include "host/files.h"
#include "host/process.h"
#include "host/threads.h"
#include "tools/common/folders.h"
#include "tools/common/whole_file.h"

#include <cpuid.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace odraz;

TEST(Threads, RunEveryPieceOnceRoundAfterRound) {
    static int abort = 0;
    Workers workers;
    ASSERT_EQ(startWorkers(workers, 4, &abort), nullptr);
    std::vector<int> seen(1000), workerOf(1000);
    for (int round = 1; round <= 2000; ++round) {
        int pieces = round % 7 == 0 ? 1 : round % 5 == 0 ? 0 : 1000 / (round % 40 + 1);
        std::fill(seen.begin(), seen.end(), 0);
        parallelFor(workers, pieces, [&](int i, int worker) {
            ++seen[(size_t)i];
            workerOf[(size_t)i] = worker;
        });
        for (int i = 0; i < 1000; ++i) ASSERT_EQ(seen[(size_t)i], i < pieces) << round;
        for (int i = 0; i < pieces; ++i) ASSERT_TRUE(workerOf[(size_t)i] >= 0 && workerOf[(size_t)i] < 4);
    }
    abort = 1;
    int ran = 0;
    parallelFor(workers, 100, [&](int, int) { ++ran; });
    EXPECT_EQ(ran, 0);
}

// Compares with the compiler's library, not with the kernel: under some hypervisors the kernel hides
// features. test_machine.py tests processors that lack a feature.
TEST(Machine, DetectsTheProcessorsFeatures) {
    EXPECT_EQ(cpuSuffices(), __builtin_cpu_supports("x86-64-v3") != 0);
}

// Compares with the processor's brand string, without trademarks and clock rate.
TEST(Machine, NamesTheProcessor) {
    char name[50];
    std::memset(name, 'x', sizeof name);
    cpuName(name);
    ASSERT_NE(std::memchr(name, 0, 49), nullptr);
    EXPECT_EQ(name[49], 'x');
    unsigned brand[13] = {};
    for (unsigned leaf = 0; leaf < 3; ++leaf) {
        unsigned *to = brand + 4 * leaf;
        ASSERT_TRUE(__get_cpuid(0x80000002 + leaf, to, to + 1, to + 2, to + 3));
    }
    std::string plain, got = name;
    std::istringstream words((const char *)brand);
    for (std::string word; words >> word && word[0] != '@';)
        plain += (plain.empty() ? "" : " ") + word.substr(0, word.find('('));
    EXPECT_EQ(got, plain);
    EXPECT_EQ(got.find_first_of("(@)"), std::string::npos) << got;
}

TEST(Machine, GivesMemoryThatIsZero) {
    constexpr size_t kSize = 1 << 20;
    auto *p = (unsigned char *)takeMemory(kSize);
    ASSERT_NE(p, nullptr);
    EXPECT_EQ(std::count(p, p + kSize, 0), (long)kSize);
    std::memset(p, 1, kSize);
    EXPECT_EQ(takeMemory(SIZE_MAX / 2), nullptr);
}

// Pages that lie only partly in the range are kept.
TEST(Machine, TakesBackWholePagesAlone) {
    constexpr size_t kSize = 1 << 20;
    auto *p = (unsigned char *)takeMemory(kSize);
    std::memset(p, 1, kSize);
    giveBack(p + 64, kSize - 128);
    EXPECT_EQ(std::count(p, p + kSize, 1), 2 * 4096); // Linux replaces pages by zeros
    std::memset(p, 1, kSize);
    giveBack(p + 64, 4096);
    giveBack(p, 0);
    EXPECT_EQ(std::count(p, p + kSize, 1), (long)kSize);
}

TEST(Machine, ReportsTheSizeOfItsFile) {
    EXPECT_EQ(ownSize(), (long)std::filesystem::file_size("/proc/self/exe"));
}

struct Files : testing::Test {
    common::TemporaryFolder temporary;
    std::string folder = temporary / "new", path = folder + "/a";
    Files() { EXPECT_EQ(makeDirectory(folder.c_str()), nullptr); }
    long count() const { return std::distance(std::filesystem::directory_iterator(folder), {}); }
};

TEST_F(Files, AreWholeOrAbsent) {
    EXPECT_EQ(makeDirectory(folder.c_str()), nullptr); // it exists already
    EXPECT_EQ(writeFile(path.c_str(), "hello", 5), nullptr);
    EXPECT_EQ(common::readWhole(path), "hello");
    EXPECT_EQ(count(), 1);
    EXPECT_STREQ(writeFile((folder + "/none/a").c_str(), "x", 1), "no such directory");
    EXPECT_STREQ(makeDirectory(path.c_str()), "not a directory");
    EXPECT_STREQ(writeFile(std::string(5000, 'a').c_str(), "x", 1), "the name is too long");
    EXPECT_STREQ(writeAll(9999, "x", 1), "it is closed");
}

// The name of the temporary file may be in use. Then writeFile() must not follow a link and must not wait for
// a pipe.
TEST_F(Files, LeaveOthersPartsAlone) {
    std::string theirs = folder + "/theirs"; // somebody else's file
    common::writeWhole(theirs, "precious");
    auto part = [&](int i) {
        std::string digits = std::to_string(getpid() + i); // reversed in the name
        return path + "." + std::string(digits.rbegin(), digits.rend()) + ".part";
    };
    ASSERT_EQ(symlink(theirs.c_str(), part(0).c_str()), 0);
    ASSERT_EQ(mkfifo(part(1).c_str(), 0666), 0);
    EXPECT_EQ(writeFile(path.c_str(), "hello", 5), nullptr);
    EXPECT_EQ(common::readWhole(path), "hello");
    EXPECT_EQ(common::readWhole(theirs), "precious");
    EXPECT_EQ(count(), 4);
    EXPECT_STREQ(writeFile((folder + "/" + std::string(254, 'a')).c_str(), "x", 1), "the name is too long");
}

TEST_F(Files, FillPipesThatDoNotBlock) {
    int ends[2];
    ASSERT_EQ(pipe2(ends, O_NONBLOCK), 0);
    std::vector<char> much(1 << 20, 'x');
    size_t got = 0;
    std::thread reader([&] {
        char some[4096];
        for (ssize_t n; (n = read(ends[0], some, sizeof some)) != 0;) {
            if (n > 0) got += (size_t)n;
            usleep(n > 0 ? 100 : 2000);
        }
    });
    EXPECT_EQ(writeAll(ends[1], much.data(), much.size()), nullptr);
    close(ends[1]);
    reader.join();
    close(ends[0]);
    EXPECT_EQ(got, much.size());
}
