// Tests that solution files which `radiosity solve` did not write are refused, even if the checksum is right.
#include "tests/support/headless_gl.h"
#include "tests/support/thrown.h"
#include "tools/common/folders.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/export/points_export.h"
#include "tools/radiosity/export/render.h"
#include "tools/radiosity/solution/arrays.h"
#include "tools/radiosity/solution/saved_state.h"

using namespace odraz;
using namespace odraz::radiosity;

constexpr Rgb kGrey = {0.5f, 0.5f, 0.5f};

// A solution made by hand: two charts of two by one cells; each chart has a facet.
static Solution small() {
    Solution b;
    for (int k = 0; k < 2; ++k) {
        Chart c = {};
        c.corner = {0, (float)k, 0};
        c.u = {1, 0, 0}, c.v = {0, 0, -1}, c.n = {0, 1, 0};
        c.width = 2, c.height = 1, c.across = 2, c.down = 1, c.patchesAcross = c.patchesDown = 1;
        c.firstCell = 2 * k, c.firstTexel = 6 * k, c.firstFacet = k, c.facetCount = 1;
        b.charts.push_back(c);
        b.facets.push_back({k, {0, 2, 2, 0}, {0, 0, 1, 1}});
        for (int i = 0; i < 6; ++i) b.texels.push_back({k, i % 3, i / 3, 15, 0, false});
        for (int at : {6 * k, 6 * k + 1}) b.cells.push_back({{at, at + 1, at + 3, at + 4}, 0, k, 1});
        b.reflects.push_back(kGrey), b.emits.push_back({0, 0, (float)k});
    }
    b.light.assign(b.texels.size(), Rgb{1, 2, 3});
    b.material = {0, 0}, b.names = {'a', 0};
    return b;
}

class SolutionFile : public testing::Test {
protected:
    common::TemporaryFolder folder;
    std::string path = folder / "a.rad";

    // Whether the file is accepted; an accepted solution must be safe to use.
    bool taken(const Solution &b) {
        std::string body;
        b.put(body);
        common::writeWhole(path, withChecksum(kSolutionMagic, body));
        std::string wrong = thrown([&] {
            Solution again(path);
            exportCsv(again, folder / "a.csv");
            exportPolygons(again, folder / "a.ply", true);
            Workers workers = serialWorkers();
            RenderSettings s;
            s.width = 16, s.height = 9;
            placeCamera(again, s);
            render(again, s, workers, folder / "a.png");
        });
        EXPECT_TRUE(wrong.empty() || wrong.find("damaged") != std::string::npos) << wrong;
        return wrong.empty();
    }
};

TEST_F(SolutionFile, ComesBackAsItWas) { EXPECT_TRUE(taken(small())); }

TEST_F(SolutionFile, IsNotWrittenIfItCannotBeRead) {
    Solution b = small();
    b.light[4].y = 1e18f;
    EXPECT_NE(thrown([&] { b.save(folder / "b.rad"); }).find("is not written"), std::string::npos);
    EXPECT_THROW(common::readWhole(folder / "b.rad"), common::Refused);
}

TEST_F(SolutionFile, IsRefusedIfItIsInconsistent) {
    void (*const spoils[])(Solution &) = {
        [](Solution &b) { b.charts.clear(); },
        [](Solution &b) { b.charts[0].across = 9; },
        [](Solution &b) { b.charts[1].firstCell = -1; },
        [](Solution &b) { b.charts[1].firstFacet = 1 << 30; },
        [](Solution &b) { b.charts[1].facetCount = 2; },
        [](Solution &b) { b.charts[0].width = 0; },
        [](Solution &b) { b.charts[0].corner.y = NAN; },
        [](Solution &b) { std::memset((void *)&b.charts[0].open, 7, 1); },
        [](Solution &b) { b.facets[1].chart = 2; },
        [](Solution &b) { b.facets[1].u[2] = INFINITY; },
        [](Solution &b) { b.cells[0].corner[0] = -1; },
        [](Solution &b) { b.cells[1].corner[3] = 12; },
        [](Solution &b) { b.cells[1].corner[3] = b.cells[1].corner[0]; },
        [](Solution &b) { b.cells[2].corner[1] = 1; }, // a texel of another chart
        [](Solution &b) { b.cells[3].chart = -1; },
        [](Solution &b) { b.texels[3].chart = 9; },
        [](Solution &b) { b.texels[3].x = 1 << 30; },
        [](Solution &b) { b.light.pop_back(); },
        [](Solution &b) { b.light[4].y = NAN; },
        [](Solution &b) { b.reflects.pop_back(); },
        [](Solution &b) { b.emits.clear(); },
        [](Solution &b) { b.cellReflects.resize(3); },
        [](Solution &b) { b.cellReflects.resize(b.cells.size(), kGrey * NAN); },
        [](Solution &b) { b.material[1] = 2; }, // beyond the names
        [](Solution &b) { b.material.pop_back(); },
        [](Solution &b) { b.group = b.material, b.group[1] = 2; },
        [](Solution &b) { b.names.pop_back(); },
    };
    for (size_t i = 0; i < std::size(spoils); ++i) {
        Solution b = small();
        spoils[i](b);
        EXPECT_FALSE(taken(b)) << i;
    }
}

TEST(SavedState, IsReadAsItWasWritten) {
    common::TemporaryFolder folder;
    SavedState a;
    a.words = {"m.obj", "-o", "", "a\nb"};
    a.model = 321;
    a.rows = "rows";
    a.save(folder / "a.state");
    SavedState b(folder / "a.state");
    EXPECT_EQ(b.words, a.words);
    EXPECT_EQ(b.model, a.model);
    EXPECT_EQ(b.rows, a.rows);
    // Every wrong byte and every missing end is detected
    std::string all = common::readWhole(folder / "a.state");
    auto expectRefused = [&](const std::string &wrong) {
        common::writeWhole(folder / "b.state", wrong);
        EXPECT_THROW(SavedState(folder / "b.state"), common::Refused);
    };
    for (size_t i = 0; i < all.size(); ++i) {
        std::string wrong = all;
        wrong[i] = (char)(wrong[i] ^ 4);
        expectRefused(wrong);
        expectRefused(all.substr(0, i));
    }
    expectRefused(all + "x");
}
