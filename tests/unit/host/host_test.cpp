#include "host/clock.h"
#include "host/cpu.h"
#include "host/files.h"
#include "host/headless.h"
#include "host/process.h"
#include "host/threads.h"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <unistd.h>
#include <vector>

using namespace odraz;

TEST(Threads, RunEveryPieceOnceRoundAfterRound) {
    static int abort = 0;
    Workers workers;
    ASSERT_EQ(startWorkers(workers, 4, &abort), nullptr);
    std::vector<int> seen(1000), who(1000);
    for (int round = 1; round <= 2000; ++round) {
        int pieces = round % 7 == 0 ? 1 : round % 5 == 0 ? 0 : 1000 / (round % 40 + 1);
        std::fill(seen.begin(), seen.end(), 0);
        parallelFor(workers, pieces, [&](int i, int worker) {
            ++seen[(size_t)i];
            who[(size_t)i] = worker;
        });
        for (int i = 0; i < 1000; ++i) ASSERT_EQ(seen[(size_t)i], i < pieces) << round;
        for (int i = 0; i < pieces; ++i) ASSERT_TRUE(who[(size_t)i] >= 0 && who[(size_t)i] < 4);
    }
    abort = 1;
    int ran = 0;
    parallelFor(workers, 100, [&](int, int) { ++ran; });
    EXPECT_EQ(ran, 0);
}

TEST(Machine, KnowsItself) {
    EXPECT_TRUE(cpuSuffices()); // or these tests would not have been compiled to run here
    EXPECT_GE(cpuCount(), 1);
    int64_t a = nanoseconds(), b = nanoseconds();
    EXPECT_LE(a, b);
    EXPECT_LT(b - a, 1000000000);
    char name[49];
    cpuName(name);
    EXPECT_LT(std::string(name).size(), 49u);
    EXPECT_EQ(std::string(name).find_first_of("(@)"), std::string::npos) << name;
    EXPECT_EQ(std::string(name).find("  "), std::string::npos) << name;
    EXPECT_GT(ownSize(), 0);
    auto *p = (unsigned char *)takeMemory(1 << 20);
    ASSERT_NE(p, nullptr);
    EXPECT_EQ(p[12345], 0);
    EXPECT_EQ(takeMemory(SIZE_MAX / 2), nullptr);
}

TEST(Files, AreWholeOrAbsent) {
    std::string folder = testing::TempDir() + "odraz_files";
    ASSERT_EQ(makeDirectory(folder.c_str()), nullptr);
    ASSERT_EQ(makeDirectory(folder.c_str()), nullptr); // again
    std::string path = folder + "/a";
    EXPECT_EQ(writeFile(path.c_str(), "hello", 5), nullptr);
    std::string text;
    std::ifstream(path) >> text;
    EXPECT_EQ(text, "hello");
    EXPECT_NE(access((path + ".part").c_str(), F_OK), 0);
    EXPECT_STREQ(writeFile((folder + "/none/a").c_str(), "x", 1), "no such directory");
    EXPECT_STREQ(makeDirectory(path.c_str()), "not a directory");
    EXPECT_STREQ(writeFile(std::string(5000, 'a').c_str(), "x", 1), "the name is too long");
    EXPECT_STREQ(writeAll(9999, "x", 1), "it is closed");
}

// The picture that a headless context clears is what is read back from it.
TEST(Headless, DrawsWithoutADisplay) {
    unsetenv("DISPLAY");
    Gl gl;
    const char *missing = openHeadlessGl(gl);
    if (missing) GTEST_SKIP() << missing;
    GLuint texture, framebuffer;
    gl.glGenTextures(1, &texture);
    gl.glBindTexture(GL_TEXTURE_2D, texture);
    gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.glGenFramebuffers(1, &framebuffer);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    ASSERT_EQ(gl.glCheckFramebufferStatus(GL_FRAMEBUFFER), (GLenum)GL_FRAMEBUFFER_COMPLETE);
    gl.glClearColor(0, 1, 0, 1);
    gl.glClear(GL_COLOR_BUFFER_BIT);
    unsigned char pixels[8 * 8 * 4];
    gl.glReadPixels(0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    for (int i = 0; i < 64; ++i) EXPECT_EQ(pixels[4 * i + 1], 255);
}
