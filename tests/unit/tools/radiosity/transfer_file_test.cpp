// Files of rooms: a round trip, and damaged files.
#include "tests/support/open_room.h"
#include "tests/support/sanitized.h"
#include "tests/support/thrown.h"
#include "tools/common/temporary_folder.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/solution/arrays.h"

#include <gtest/gtest.h>

#include <cstdio>

using namespace odraz;
using namespace odraz::radiosity;

namespace {

std::string fileOf(const TransferRoom &room) {
    common::TemporaryFolder folder;
    room.save(folder / "room.prt");
    return common::readWhole(folder / "room.prt");
}

// Whether a file is accepted; an accepted one must be safe to use.
bool accepted(const std::string &file) {
    common::TemporaryFolder folder;
    common::writeWhole(folder / "room.prt", file);
    std::string wrong = thrown([&] {
        TransferRoom room = TransferRoom::read(folder / "room.prt");
        Vec3 eye = {1, 2, 3};
        for (int rank : {-1, room.clusters.rank})
            litModel(room, {.sky = {}, .lamps = {}, .bands = room.bands, .rank = rank}, &eye);
    });
    EXPECT_TRUE(wrong.empty() || wrong.find(folder / "room.prt") == 0) << wrong;
    EXPECT_EQ(wrong.find('\n'), std::string::npos);
    return wrong.empty();
}

} // namespace

TEST(File, KeepsTheRoom) {
    TransferSettings settings = settingsOf(2, 16, 0.5);
    settings.glossy = "grey", settings.upIsZ = true;
    TransferRoom room = transferOf(openRoom(), settings);
    std::string file = fileOf(room);
    common::TemporaryFolder folder;
    common::writeWhole(folder / "room.prt", file);
    EXPECT_TRUE(TransferRoom::is(folder / "room.prt"));
    EXPECT_FALSE(TransferRoom::is(folder / "none.prt"));
    TransferRoom again = TransferRoom::read(folder / "room.prt");
    EXPECT_EQ(fileOf(again), file);
    EXPECT_EQ(again.lamps, std::vector<std::string>{"lamp"});
    EXPECT_EQ(again.bands, 2);
    EXPECT_TRUE(again.upIsZ);
}

// The checksum detects damage. A file with a forged checksum is refused or safe to use.
TEST(File, SurvivesDamage) {
    TransferSettings settings = settingsOf(2, 8, 4);
    settings.glossy = "grey", settings.rank = 1, settings.clusters = 2;
    TransferRoom room = transferOf(openRoom(), settings);
    std::string file = fileOf(room);
    const size_t sparse = kSanitized ? 4 : 1;
    size_t head = file.find('\n') + 1 + 8;
    ASSERT_TRUE(accepted(file));
    for (size_t end = 0; end < file.size(); end += end < 64 ? 1 : sparse * file.size() / 50)
        EXPECT_FALSE(accepted(file.substr(0, end))) << end;
    EXPECT_FALSE(accepted(file + "x"));
    std::string body = file.substr(head);
    EXPECT_FALSE(accepted(TransferRoom::withChecksum(body + "x")));
    for (size_t end = 0; end < body.size(); end += 1 + sparse * body.size() / 100)
        EXPECT_FALSE(accepted(TransferRoom::withChecksum(body.substr(0, end)))) << end;
    // Bytes changed: most of the file is small numbers, so some changes are accepted
    int taken = 0, tried = 0;
    for (size_t at = 0; at < body.size(); at += sparse * (at < 2048 ? 23 : body.size() / 50)) {
        for (int value : {0, 0xff, 0x80, 1}) {
            std::string other = body;
            other[at] = (char)(other[at] ^ value);
            if (other != body) taken += accepted(TransferRoom::withChecksum(other)), ++tried;
        }
        std::string flipped = file;
        flipped[head + at] = (char)(flipped[head + at] ^ 4);
        EXPECT_FALSE(accepted(flipped)) << at;
    }
    std::printf("%d of %d changed files could be worked with\n", taken, tried);
    EXPECT_GT(taken, 0);
    EXPECT_LT(taken, tried);
}
