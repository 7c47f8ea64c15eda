// Tests damaged room files. (test_radiosity_transfer.py uses whole ones.)
#include "tests/support/open_room.h"
#include "tests/support/thrown.h"
#include "tools/common/folders.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/solution/arrays.h"

#include <gtest/gtest.h>

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

// The checksum detects damage. A file with a forged checksum is refused or safe to use. (The fuzzer tries
// many more files.)
TEST(File, SurvivesDamage) {
    TransferSettings settings = settingsOf(1, 8, 4);
    settings.glossy = "grey", settings.glossRays = 64, settings.rank = 1, settings.clusters = 2;
    std::string file = fileOf(transferOf(openRoom(), settings)), body = file.substr(file.find('\n') + 1 + 8);
    ASSERT_TRUE(accepted(file));
    EXPECT_FALSE(accepted(file + "x"));
    EXPECT_FALSE(accepted(withChecksum(kTransferMagic, body + "x")));
    for (size_t end = 0; end < body.size(); end += body.size() / 40) {
        EXPECT_FALSE(accepted(file.substr(0, end))) << end;
        EXPECT_FALSE(accepted(withChecksum(kTransferMagic, body.substr(0, end)))) << end;
        std::string flipped = file;
        flipped[file.size() - body.size() + end] ^= 4;
        EXPECT_FALSE(accepted(flipped)) << end;
    }
}
