#include "maker/rebuilder.h"

#include "tools/common/folders.h"
#include "tools/common/whole_file.h"

#include <fstream>
#include <unistd.h>

using namespace odraz;
using namespace odraz::maker;

// A project whose target "live" copies a source to the shared object, unless the source is wrong.
class Project {
public:
    Project() {
        std::filesystem::create_directories(folder / "intro/show");
        write("CMakeLists.txt", "cmake_minimum_required(VERSION 3.20)\nproject(p NONE)\n"
                                "add_custom_target(live COMMAND sh ${CMAKE_SOURCE_DIR}/make "
                                "${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR})\n");
        write("make", "if grep -q oops $1/intro/show/a.cpp; then\n"
                      "echo building; echo $1/intro/show/a.cpp:3:1: `cat $1/intro/show/a.cpp`; echo b.cpp: "
                      "error: later; exit 1; fi\n"
                      "cp $1/intro/show/a.cpp $2/live/live.so\n");
        write("intro/show/a.cpp", "one");
        std::string command = "cmake -G Ninja -S " + (folder / "") + " -B " + build() + " >/dev/null";
        EXPECT_EQ(std::system(command.c_str()), 0);
    }
    void write(const std::string &name, const std::string &text) const {
        std::ofstream(folder / name) << text;
    }
    std::string read(const std::string &name) const { return common::readWhole(folder / name); }
    std::string build() const { return folder / "build"; }
    common::TemporaryFolder folder;
};

struct Rebuilding : testing::Test {
    Project p;
    Rebuilder r{p.build()};
    double now = 0;

    // Returns the next event other than the start of a build. Waits at most a quarter of an hour.
    Rebuilder::Event next() {
        for (int i = 0; i < 90000; ++i) {
            Rebuilder::Event event = r.poll(now += 0.01);
            if (event == Rebuilder::Event::Built || event == Rebuilder::Event::Failed) return event;
            usleep(10000);
        }
        return Rebuilder::Event::None;
    }
    // Polls for a while. Returns true if nothing happens.
    bool quiet() {
        for (int i = 0; i < 20; ++i, usleep(5000))
            if (r.poll(now += 0.01) != Rebuilder::Event::None) return false;
        return true;
    }
};

TEST_F(Rebuilding, BuildsWhatIsSaved) {
    ASSERT_EQ(r.problem(), "");
    EXPECT_TRUE(quiet());
    EXPECT_EQ(r.object(), p.build() + "/live/live.so");
    p.write("intro/show/a.cpp", "two");
    ASSERT_EQ(next(), Rebuilder::Event::Built);
    EXPECT_FALSE(r.building());
    EXPECT_EQ(p.read("build/live/live.so"), "two");
    EXPECT_GT(r.saved(), 0);
    // Most editors write another file and rename it
    p.write("intro/show/.a.cpp.swp", "three");
    EXPECT_TRUE(quiet()); // not a source
    std::filesystem::rename(p.folder / "intro/show/.a.cpp.swp", p.folder / "intro/show/a.cpp");
    ASSERT_EQ(next(), Rebuilder::Event::Built);
    EXPECT_EQ(p.read("build/live/live.so"), "three");
}

TEST_F(Rebuilding, ReportsTheFirstError) {
    for (std::string line :
         {"error: oops", "sorry, unimplemented: oops"}) { // the second for rows out of order
        p.write("intro/show/a.cpp", line);
        ASSERT_EQ(next(), Rebuilder::Event::Failed);
        EXPECT_EQ(r.error(), "intro/show/a.cpp:3:1: " + line);
        EXPECT_TRUE(quiet());
    }
    p.write("intro/show/a.cpp", "well");
    ASSERT_EQ(next(), Rebuilder::Event::Built);
    EXPECT_EQ(p.read("build/live/live.so"), "well");
}

TEST_F(Rebuilding, BuildsAgainWhatWasSavedMeanwhile) {
    p.write(
        "make",
        "cp $1/intro/show/a.cpp $2/live/live.so; touch $2/copied; until [ -e $2/go ]; do sleep 0.01; done\n");
    p.write("intro/show/a.cpp", "two");
    auto copied = [&] { return std::filesystem::exists(p.folder / "build/copied"); };
    auto event = Rebuilder::Event::None;
    for (int i = 0; i < 90000 && !copied() && event != Rebuilder::Event::Failed; ++i, usleep(10000))
        event = r.poll(now += 0.01);
    ASSERT_TRUE(copied() && r.building());
    p.write("intro/show/a.cpp", "three");
    p.write("build/go", "");
    ASSERT_EQ(next(), Rebuilder::Event::Built);
    EXPECT_EQ(p.read("build/live/live.so"), "three");
    EXPECT_TRUE(quiet());
}

TEST_F(Rebuilding, WatchesNewFolders) {
    std::filesystem::create_directory(p.folder / "intro/show/scenes");
    EXPECT_TRUE(quiet());
    p.write("intro/show/scenes/new.cpp", "new");
    EXPECT_EQ(next(), Rebuilder::Event::Built);
}

TEST(Rebuilder, ReportsWhatItCannotWatch) {
    common::TemporaryFolder empty;
    Rebuilder r(empty / "");
    EXPECT_NE(r.problem().find("not a build folder"), std::string::npos);
    EXPECT_EQ(r.poll(1), Rebuilder::Event::None);
}

TEST_F(Rebuilding, HashesTheSolvers) {
    std::string objects = "build/intro/maker/CMakeFiles/live.dir/__/";
    for (const char *room : {"show", "radiosity", "transfer"})
        std::filesystem::create_directories(p.folder / (objects + room));
    p.write(objects + "show/film.cpp.o", "1");
    p.write(objects + "transfer/room.cpp.o", "1");
    p.write(objects + "radiosity/solve.cpp.o", "1");
    uint64_t before = r.solverHash();
    p.write(objects + "show/film.cpp.o", "2");
    EXPECT_EQ(r.solverHash(), before);
    p.write(objects + "radiosity/solve.cpp.o", "2");
    uint64_t solved = r.solverHash();
    EXPECT_NE(solved, before);
    p.write(objects + "transfer/room.cpp.o", "2");
    EXPECT_NE(r.solverHash(), solved);
}
