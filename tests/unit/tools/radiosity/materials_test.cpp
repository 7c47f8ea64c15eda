// Tests options that change materials: reading, effect and errors.
#include "tests/support/read_model.h"
#include "tests/support/thrown.h"
#include "tools/radiosity/read/material_changes.h"

using namespace odraz::radiosity;

static std::vector<MeshMaterial> fiveMaterials() {
    MeshMaterial picture = {"cloth", {0.7f, 0.7f, 0.7f}, {}};
    picture.picture.path = "cloth.png", picture.picture.tint = {0.5f, 1, 1};
    return {{"white", {0.75f, 0.5f, 0.25f}, {}},
            {"lamp", {0.5f, 0.5f, 0.5f}, {20, 18, 15}},
            picture,
            {"a=b", {0.1f, 0.2f, 0.3f}, {}},
            {"unused", {0.9f, 0.9f, 0.9f}, {}}};
}
static std::vector<MeshMaterial> changed(const std::vector<std::pair<std::string, std::string>> &options) {
    std::vector<MeshMaterial> all = fiveMaterials();
    std::vector<MaterialChange> changes;
    for (const auto &[option, text] : options) changes.push_back(readMaterialChange(option, text));
    changeMaterials(all, {true, true, true, true, false}, changes);
    return all;
}

// The error message for a change.
static std::string refusal(const std::string &option, const std::string &text) {
    return thrown<common::Refused>([&] { changed({{option, text}}); });
}

TEST(Materials, GetColoursAndFactors) {
    EXPECT_EQ(changed({{"--reflectance", "white=.1,.2,.3"}})[0].reflects, (Colour{0.1f, 0.2f, 0.3f}));
    EXPECT_EQ(changed({{"--reflectance", "white=2e-1"}})[0].reflects, (Colour{0.15f, 0.1f, 0.05f}));
    EXPECT_EQ(changed({{"--reflectance", "a=b=1,1,1"}})[3].reflects, (Colour{1, 1, 1}));
    EXPECT_EQ(changed({{"--power", "white=1,2,3"}})[0].emits, (Colour{1, 2, 3}));
    EXPECT_EQ(changed({{"--power", "lamp=0"}})[1].emits, (Colour{0, 0, 0}));
    auto all = changed({{"--power", "lamp=2"}});
    for (size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i].reflects, fiveMaterials()[i].reflects);
        EXPECT_EQ(all[i].emits, i == 1 ? (Colour{40, 36, 30}) : fiveMaterials()[i].emits);
    }
}

TEST(Materials, WithoutNameAreAllOrAllLamps) {
    std::vector<MeshMaterial> all = changed({{"--reflectance", "0.5,0.5,0.5"}, {"--power", "7,8,9"}});
    for (size_t i = 0; i < 4; ++i) EXPECT_EQ(all[i].reflects, (Colour{0.5f, 0.5f, 0.5f})) << i;
    EXPECT_EQ(all[1].emits, (Colour{7, 8, 9}));
    for (size_t i : {0u, 2u, 3u}) EXPECT_EQ(all[i].emits, (Colour{})) << i;
    EXPECT_EQ(all[4].reflects, fiveMaterials()[4].reflects);
}

TEST(Materials, ChangeOneAfterTheOther) {
    auto all = changed({{"--reflectance", "0.4,0.4,0.4"},
                        {"--reflectance", "white=0.5"},
                        {"--power", "white=1,1,1"},
                        {"--power", "3"}});
    EXPECT_EQ(all[0].reflects, (Colour{0.2f, 0.2f, 0.2f}));
    EXPECT_EQ(all[0].emits, (Colour{3, 3, 3}));
    EXPECT_EQ(all[1].emits, (Colour{60, 54, 45}));
}

// A factor multiplies a picture; a colour replaces it.
TEST(Materials, WithPictures) {
    auto dimmed = changed({{"--reflectance", "cloth=0.5"}});
    EXPECT_EQ(dimmed[2].picture.tint, (Colour{0.25f, 0.5f, 0.5f}));
    EXPECT_EQ(dimmed[2].picture.path, "cloth.png");
    auto plain = changed({{"--reflectance", "cloth=0.2,0.3,0.4"}});
    EXPECT_EQ(plain[2].picture.path, "");
    EXPECT_EQ(plain[2].reflects, (Colour{0.2f, 0.3f, 0.4f}));
}

// 3 / 0.75 as a factor gives 1 within rounding.
TEST(Materials, ReflectAllLightAtMost) {
    EXPECT_EQ(changed({{"--reflectance", "white=1.3333333"}})[0].reflects[0], 1);
    EXPECT_EQ(refusal("--reflectance", "white=1.34"),
              "--reflectance white=1.34: white would reflect 1.005; the most is 1");
    EXPECT_EQ(refusal("--power", "lamp=1e12"), "--power lamp=1e12: lamp would emit 2e+13; the most is 1e12");
}

TEST(Materials, AreListedIfTheNameIsUnknown) {
    const std::string listed = ": no polygon has this material; the materials are white, lamp, cloth, a=b";
    EXPECT_EQ(refusal("--reflectance", "grey=1"), "--reflectance grey=1" + listed);
    EXPECT_EQ(refusal("--power", "unused=1,1,1"), "--power unused=1,1,1" + listed);
    EXPECT_NE(refusal("--power", "white=2").find("white emits no light: name a material"), std::string::npos);
    std::vector<MeshMaterial> dark = {{"white", {1, 1, 1}, {}}};
    EXPECT_THROW(changeMaterials(dark, {true}, {readMaterialChange("--power", "2")}), common::Refused);
    EXPECT_THROW(changeMaterials(dark, {true}, {readMaterialChange("--power", "2,2,2")}), common::Refused);
}

TEST(Materials, RefuseWhatIsNoColour) {
    for (const char *text :
         {"", "=1", "white=", "white=1,2", "white=1,2,3,4", "white=a", "white=1,,2", "white=1,1,1 ",
          "white=1;1;1", "white", "nan", "inf", "1,1,nan", "-1", "-0.1,0,0", "white=1e400"})
        for (const char *option : {"--reflectance", "--power"})
            EXPECT_NE(refusal(option, text), "") << option << " " << text;
    EXPECT_EQ(refusal("--reflectance", "1,1,1.01"), "--reflectance 1,1,1.01: a reflectance must be 0 to 1");
    EXPECT_EQ(refusal("--power", "1,1,2e12"), "--power 1,1,2e12: power must be 0 to 1e12");
}
