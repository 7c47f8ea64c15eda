// Kept rows: the result equals a fresh solution, and damaged rows are harmless even with the right checksum.
#include "tests/support/headless_gl.h"
#include "tests/support/light.h"
#include "tests/support/thrown.h"
#include "tools/common/temporary_folder.h"
#include "tools/common/whole_file.h"
#include "tools/engine/machine.h"
#include "tools/measure/oracle/measured.h"
#include "tools/radiosity/solution/kept.h"
#include "tools/radiosity/solve/scaled.h"
#include "tools/radiosity/solve/solve.h"

#include <random>

using namespace odraz;
using namespace odraz::radiosity;

namespace {

Workers &workers() {
    static Workers all = allProcessors();
    return all;
}

class Relight : public testing::TestWithParam<bool> {
protected:
    Mesh mesh;
    SolveSettings settings;
    std::string rows, prepared;
    bool keptSky = false;

    // Keeps the rows of a small room.
    void keep() {
        mesh = measure::generatedMesh("cube", 0);
        settings.element = 9, settings.rays = 16, settings.hemicube = 8, settings.patch = 36;
        if (GetParam()) settings.way = Way::kPatches;
        settings.keepRows = [this](std::string r, std::string p) {
            rows = std::move(r), prepared = std::move(p);
        };
        keptSky = solveModel(mesh, settings, headlessGl(), workers(), &kNever, {}).evenSky;
        settings.keepRows = nullptr;
    }
    // The same materials without polygons, changed.
    Mesh changed(const std::vector<std::pair<std::string, std::string>> &options) const {
        Mesh to = mesh;
        to.triangles.clear(), to.points.clear();
        std::vector<MaterialChange> changes;
        for (const auto &[option, text] : options) changes.push_back(readMaterialChange(option, text));
        changeMaterials(to.materials, std::vector<bool>(to.materials.size(), true), changes);
        return to;
    }
    // A fresh solution with these materials.
    Solution solved(const Mesh &materials) {
        Mesh whole = mesh;
        whole.materials = materials.materials;
        settings.resumed = {};
        return solveModel(whole, settings, headlessGl(), workers(), &kNever, {}).solution;
    }
    Solution relit(const Mesh &materials, std::string_view rowsNow, std::string_view preparedNow) {
        settings.resumed = rowsNow;
        PreparedSolve ready(preparedNow, materials.materials.size());
        return relightModel(materials, ready, keptSky, settings, workers(), &kNever, {}).solution;
    }
};

} // namespace

TEST_P(Relight, EqualsAFreshSolution) {
    keep();
    Mesh materials = changed({{"--power", "lamp=1,30,7"}, {"--reflectance", "white=0.2,0.9,1"}});
    Solution kept = relit(materials, rows, prepared), fresh = solved(materials);
    EXPECT_LT(apart(kept.light, fresh.light), 1e-6);
    EXPECT_EQ(fresh.texels.size(), kept.texels.size());
    EXPECT_EQ(fresh.charts.size(), kept.charts.size());
    for (size_t i = 0; i < fresh.charts.size(); ++i) {
        EXPECT_EQ(fresh.emits[i].y, kept.emits[i].y);
        EXPECT_EQ(fresh.reflects[i].y, kept.reflects[i].y);
    }
}

TEST_P(Relight, NeedsDirectLightOfTheLampsThatShine) {
    keep();
    PreparedSolve ready(prepared, mesh.materials.size());
    std::vector<int> lamps = ready.direct.emitters;
    ASSERT_EQ(lamps.size(), 1u);
    EXPECT_TRUE(ready.fits(lamps));
    EXPECT_TRUE(ready.fits({}));
    EXPECT_FALSE(ready.fits({lamps[0] == 0 ? 1 : 0}));
    EXPECT_THROW(PreparedSolve(prepared, (size_t)lamps[0]), std::runtime_error);
    EXPECT_THROW(PreparedSolve(std::string_view(prepared).substr(0, 40), 9), std::runtime_error);
}

// Bytes are changed and the checksum computed again, as a forger would: the file is refused, or solved
// without an error of the sanitizers.
TEST_P(Relight, SurvivesForgedRows) {
    keep();
    settings.bounces = 1;
    Mesh materials = changed({{"--power", "lamp=2"}});
    std::mt19937 random(1);
    int runs = GetParam() ? 120 : 400, refused = 0, solved = 0; // patches take memory for large models
    for (int i = 0; i < runs; ++i) {
        std::string r = rows, p = prepared;
        std::string &to = i % 2 ? r : p;
        size_t at = i % 4 < 2 ? random() % to.size() : random() % std::min(to.size(), (size_t)4000);
        if (auto way = random() % 3; way == 0)
            to[at] = (char)(to[at] ^ (1 << random() % 8));
        else if (way == 1)
            to[at] = (char)random();
        else
            to.resize(at);
        ++(thrown([&] { relit(materials, r, p); }).empty() ? solved : refused);
    }
    EXPECT_GT(refused, runs / 4);
    EXPECT_GT(solved, runs / 8); // the value of a form factor may be any number
}

TEST_P(Relight, IsScaledWhereAllLampsChangeAlike) {
    keep();
    Solution base = solved(mesh);
    PreparedSolve ready(prepared, mesh.materials.size());
    using Changes = std::vector<std::pair<std::string, std::string>>;
    auto scales = [&](const Changes &changes, Solution b) {
        Mesh materials = changed(changes);
        std::vector<Rgb> before = b.light;
        if (!scaleLight(b, materials, ready, settings)) {
            EXPECT_EQ(std::memcmp(b.light.data(), before.data(), before.size() * sizeof(Rgb)), 0);
            return false;
        }
        Solution fresh = solved(materials);
        auto lit = [](const Rgb &c) { return maxComponent(c) > 0; };
        if (std::any_of(fresh.light.begin(), fresh.light.end(), lit))
            EXPECT_LT(apart(b.light, fresh.light), 1e-6);
        else
            EXPECT_TRUE(std::none_of(b.light.begin(), b.light.end(), lit));
        return true;
    };
    bool patches = GetParam();
    EXPECT_TRUE(scales({{"--power", "3"}}, base));
    EXPECT_TRUE(scales({{"--power", "1e-9"}}, base));
    EXPECT_FALSE(scales({{"--power", "0"}}, base)); // a fresh one gets an even sky
    settings.evenSky = false;
    EXPECT_TRUE(scales({{"--power", "0"}}, base));
    EXPECT_EQ(scales({{"--power", "1,2,3"}}, base), patches); // by rays there is one residual for all colours
    EXPECT_FALSE(scales({{"--power", "0,2,3"}}, base));
    EXPECT_FALSE(scales({{"--power", "3"}, {"--power", "white=1,1,1"}}, base));
    EXPECT_FALSE(scales({{"--power", "3"}, {"--reflectance", "white=0.99"}}, base));
    settings.surroundings.sky = evenSky({1, 1, 1});
    EXPECT_FALSE(scales({{"--power", "3"}}, base));
    settings.surroundings = {};
    Solution two = base; // one of two lamps changes
    for (size_t i = 0; i < two.emits.size(); ++i)
        if (maxComponent(two.emits[i]) == 0) {
            two.emits[i] = {1, 1, 1};
            break;
        }
    EXPECT_FALSE(scales({{"--power", "3"}}, two));
}

INSTANTIATE_TEST_SUITE_P(Ways, Relight, testing::Bool(),
                         [](const auto &info) { return info.param ? "Patches" : "Rays"; });

TEST(Kept, RowsAreReadAsTheyWereWritten) {
    common::TemporaryFolder folder;
    Kept a;
    a.words = {"m.obj", "-o", "", "a\nb"};
    a.model = 1, a.sky = 2, a.solution = 3, a.evenSky = true;
    a.names = {{"a.bin"}, {"a.mtl"}, {"x", "y"}, {1, 0}, {"x", "(none)"}, {1, 1}};
    a.place = {{1, 2, 3}};
    a.rows = "rows", a.prepared = "the rest";
    a.save(folder / "a.rows", Kept::Kind::kRows);
    Kept b(folder / "a.rows", Kept::Kind::kRows);
    EXPECT_EQ(b.words, a.words);
    EXPECT_EQ(b.model + 10 * b.sky + 100 * b.solution, 321u);
    EXPECT_TRUE(b.evenSky);
    EXPECT_EQ(b.names.parts, a.names.parts);
    EXPECT_EQ(b.names.libraries, a.names.libraries);
    EXPECT_EQ(b.names.asked, a.names.asked);
    EXPECT_EQ(b.names.known, a.names.known);
    EXPECT_EQ(b.names.all, a.names.all);
    EXPECT_EQ(b.names.used, a.names.used);
    EXPECT_EQ(b.place[0].z, a.place[0].z);
    EXPECT_EQ(b.rows, a.rows);
    EXPECT_EQ((uintptr_t)b.rows.data() % 8, 0u);
    EXPECT_EQ(b.prepared, a.prepared);
    EXPECT_THROW(Kept(folder / "a.rows", Kept::Kind::kState), common::Refused);
    // A wrong byte or a missing end is always detected
    std::string all = common::readWhole(folder / "a.rows");
    auto expectRefused = [&](const std::string &wrong) {
        common::writeWhole(folder / "b.rows", wrong);
        EXPECT_THROW(Kept(folder / "b.rows", Kept::Kind::kRows), common::Refused);
    };
    for (size_t i = 0; i < all.size(); ++i) {
        std::string wrong = all;
        wrong[i] = (char)(wrong[i] ^ 4);
        expectRefused(wrong);
        expectRefused(all.substr(0, i));
    }
    expectRefused(all + "x");
}
