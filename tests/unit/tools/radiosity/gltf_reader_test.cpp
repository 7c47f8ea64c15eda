// glTF as other programs write it, and damaged: its triangles, places, materials and lights.
#include "tools/common/temporary_folder.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/read/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace odraz;
using namespace odraz::radiosity;

namespace {

using Lines = std::vector<std::string>;

std::string base64(const std::string &bytes) {
    static const char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t three = 0;
        for (size_t k = 0; k < 3; ++k)
            three = three << 8 | (i + k < bytes.size() ? (uint8_t)bytes[i + k] : 0);
        for (size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : kDigits[three >> (18 - 6 * k) & 63];
    }
    return text;
}

// The numbers of a file, and its text around them.
struct Writer {
    std::string bytes, views, accessors;
    int count = 0;

    template <class T>
    int add(int component, const std::string &type, size_t items, const std::vector<T> &values,
            const std::string &more = "", const std::string &view = "") {
        const std::string comma = count ? "," : "";
        views += comma + R"({"buffer":0,"byteOffset":)" + std::to_string(bytes.size()) + R"(,"byteLength":)" +
                 std::to_string(values.size() * sizeof(T)) + view + "}";
        accessors += comma + R"({"bufferView":)" + std::to_string(count) + R"(,"componentType":)" +
                     std::to_string(component) + R"(,"count":)" + std::to_string(items) + R"(,"type":")" +
                     type + "\"" + more + "}";
        bytes.append((const char *)values.data(), values.size() * sizeof(T));
        bytes.resize((bytes.size() + 3) / 4 * 4);
        return count++;
    }
    std::string text(const std::string &rest, bool binary = false) const {
        return R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" + std::to_string(bytes.size()) +
               (binary ? "" : R"(,"uri":"data:application/octet-stream;base64,)" + base64(bytes) + "\"") +
               R"(}],"bufferViews":[)" + views + R"(],"accessors":[)" + accessors + "]," + rest + "}";
    }
};

const std::vector<float> kSquare = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}; // faces +z

// A file with the square as accessor 0 and its corners as accessor 1.
std::string square(const std::string &rest) {
    Writer w;
    w.add(5126, "VEC3", 4, kSquare);
    w.add<uint16_t>(5123, "SCALAR", 6, {0, 1, 2, 0, 2, 3});
    return w.text(rest);
}
const std::string kMesh = R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])";
const std::string kNode = R"("nodes":[{"mesh":0}],)";

std::string glb(const std::string &json, const std::string &binary) {
    auto word = [](size_t value) {
        uint32_t four = (uint32_t)value;
        return std::string((const char *)&four, 4);
    };
    std::string padded = json + std::string((4 - json.size() % 4) % 4, ' ');
    return "glTF" + word(2) + word(28 + padded.size() + binary.size()) + word(padded.size()) + "JSON" +
           padded + word(binary.size()) + std::string("BIN\0", 4) + binary;
}

struct Read {
    Mesh mesh;
    Lines notes;
    std::string error;

    explicit Read(const std::string &file, const std::string &name = "m.gltf",
                  const ReadSettings &settings = {},
                  const std::vector<std::pair<std::string, std::string>> &others = {}) {
        common::TemporaryFolder folder;
        common::writeWhole(folder / name, file);
        for (const auto &[other, content] : others) common::writeWhole(folder / other, content);
        try {
            mesh = readModel(folder / name, settings, notes);
        } catch (const common::Refused &e) {
            error = e.what();
        }
        cut(error, folder / "");
        for (std::string &note : notes) cut(note, folder / "");
    }
    double area() const { return areaOf(mesh); }
    // The sum of areas times normals
    Vec3d facing() const {
        Vec3d sum = {};
        for (const Triangle &t : mesh.triangles) sum = sum + normalOf(mesh, t) / 2;
        return sum;
    }

private:
    static void cut(std::string &text, const std::string &folder) {
        for (size_t at; (at = text.find(folder)) != std::string::npos;) text.erase(at, folder.size());
    }
};

void expectNear(Vec3d a, Vec3d b, double within = 1e-6) {
    for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], within) << k;
}

} // namespace

// Four points as two triangles, in each way to say so.
TEST(GltfReader, TakesAllTriangles) {
    struct Case {
        int mode;
        std::vector<uint32_t> corners;
    };
    for (const Case &c : {Case{4, {0, 1, 2, 0, 2, 3}}, Case{5, {0, 1, 3, 2}},
                          Case{5, {0, 1, 3, 3, 2, 2, 1, 3}}, Case{6, {0, 1, 2, 3}}})
        for (int type : {5121, 5123, 5125, 0}) {
            Writer w;
            std::vector<float> points;
            for (uint32_t k : c.corners) points.insert(points.end(), &kSquare[3 * k], &kSquare[3 * k] + 3);
            w.add(5126, "VEC3", type ? 4 : c.corners.size(), type ? kSquare : points);
            if (type == 5121)
                w.add<uint8_t>(type, "SCALAR", c.corners.size(), {c.corners.begin(), c.corners.end()});
            if (type == 5123)
                w.add<uint16_t>(type, "SCALAR", c.corners.size(), {c.corners.begin(), c.corners.end()});
            if (type == 5125) w.add(type, "SCALAR", c.corners.size(), c.corners);
            Read r(w.text(kNode + R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":)" +
                          std::to_string(c.mode) + (type ? R"(,"indices":1)" : "") + "}]}]"));
            EXPECT_EQ(r.error, "");
            if (c.corners.size() < 8 || type) expectNear(r.facing(), {0, 0, 1});
            EXPECT_EQ(r.mesh.triangles.size(), 2u) << c.mode << " " << type;
        }
}

TEST(GltfReader, TakesAllNumbers) {
    const std::string mesh = kNode + R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":6}]}])";
    { // Between other data, from the second point's place on
        Writer w;
        std::vector<float> wide;
        for (size_t i = 0; i < 12; i += 3)
            wide.insert(wide.end(), {9, 9, kSquare[i], kSquare[i + 1], kSquare[i + 2]});
        w.add(5126, "VEC3", 4, wide, R"(,"byteOffset":8)", R"(,"byteStride":20)");
        expectNear(Read(w.text(mesh)).facing(), {0, 0, 1});
    }
    { // Quantised: 65535 and 127 are 1, and whole numbers are themselves
        Writer w;
        w.add<uint16_t>(5123, "VEC3", 4, {0, 0, 0, 65535, 0, 0, 65535, 65535, 0, 0, 65535, 0},
                        R"(,"normalized":true)");
        expectNear(Read(w.text(mesh)).facing(), {0, 0, 1});
        Writer s;
        s.add<int8_t>(5120, "VEC3", 4, {-128, 0, 0, 0, 127, 0, 0, 0, 127, 127, 0, 0, -128, 127, 0, 0},
                      R"(,"normalized":true)", R"(,"byteStride":4)");
        expectNear(Read(s.text(mesh)).facing(), {0, 0, 2});
        Writer n;
        n.add<int16_t>(5122, "VEC3", 4, {-3, 0, 0, 3, 0, 0, 3, 5, 0, -3, 5, 0});
        expectNear(Read(n.text(mesh)).facing(), {0, 0, 30});
    }
    // Sparse: the third point moves from 1,1 to 3,3; and all of them, from nothing
    Writer w;
    w.add(5126, "VEC3", 4, kSquare,
          R"(,"sparse":{"count":1,"indices":{"bufferView":1,"componentType":5121},)"
          R"("values":{"bufferView":2}})");
    w.add<uint8_t>(5121, "SCALAR", 1, {2});
    w.add<float>(5126, "VEC3", 1, {3, 3, 0});
    expectNear(Read(w.text(mesh)).facing(), {0, 0, 3});
}

// A square of 2 x 3, turned by a quarter about x, then placed by its parent.
TEST(GltfReader, PlacesNodes) {
    Read r(square(
        R"("nodes":[{"mesh":0},{"children":[2],"translation":[10,0,0],"scale":[2,2,2]},)"
        R"({"mesh":0,"scale":[1,1.5,7],"rotation":[0.70710678,0,0,0.70710678],"translation":[1,1,1]}],)"
        R"("scene":0,"scenes":[{"nodes":[1]},{"nodes":[0]}],)" +
        kMesh));
    expectNear(r.facing(), {0, -6, 0});
    auto [lo, hi] = boxOf(r.mesh.points);
    expectNear(lo + toDouble(r.mesh.place), {12, 2, 2}, 1e-5);
    expectNear(hi + toDouble(r.mesh.place), {14, 2, 5}, 1e-5);
    EXPECT_EQ(r.notes, Lines{"m.gltf: one of its 2 scenes is read"});
    // A matrix has its columns one after the other; mirrored triangles face the way that they are seen from
    const std::string matrix = R"("nodes":[{"mesh":0,"matrix":[-2,0,0,0, 0,1,0,0, 0,0,1,0, 5,6,7,1]}],)";
    expectNear(Read(square(matrix + kMesh)).facing(), {0, 0, 2});
    const Mesh placed = Read(square(matrix + kMesh)).mesh;
    expectNear(boxOf(placed.points).second + toDouble(placed.place), {5, 7, 7});
    // Without a scene, all nodes that are no children; and one mesh several times
    EXPECT_NEAR(Read(square(R"("nodes":[{"mesh":0},{"mesh":0,"translation":[3,0,0],"children":[2]},)"
                            R"({"mesh":0,"translation":[3,0,0]}],)" +
                            kMesh))
                    .area(),
                3, 1e-6);
    // A skin stands as its mesh was bound: by the first joint, not by its own node
    Writer w;
    w.add(5126, "VEC3", 4, kSquare);
    w.add<float>(5126, "MAT4", 1, {3, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    Read skinned(
        w.text(R"("nodes":[{"mesh":0,"skin":0,"scale":[9,9,9]},{"translation":[4,0,0],"name":"hip"}],)"
               R"("skins":[{"joints":[1],"inverseBindMatrices":1}],)"
               R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":6}]}])"));
    expectNear(skinned.facing(), {0, 0, 3});
    EXPECT_EQ(skinned.notes, Lines{"m.gltf: skins are not bent: meshes stand as they were bound: node 0"});
}

TEST(GltfReader, TakesMaterials) {
    const std::string materials =
        R"("materials":[{"name":"a","doubleSided":true,"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,0.5],"metallicFactor":0},)"
        R"("emissiveFactor":[1,0.5,0],"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":8}}},)"
        R"({"name":"a","extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[0.2,0.3,0.4,1]}}},)"
        R"({"normalTexture":{"index":0},"pbrMetallicRoughness":{"baseColorFactor":[2,0,0,1]}}],)";
    auto primitive = [](int m) {
        return R"({"attributes":{"POSITION":0},"indices":1,"material":)" + std::to_string(m) + "}";
    };
    std::string meshes = R"("meshes":[)", nodes = R"("nodes":[)";
    for (int m = 0; m < 3; ++m) {
        meshes += std::string(m ? "," : "") + R"({"primitives":[)" + primitive(m) + "]}";
        nodes += std::string(m ? "," : "") + R"({"mesh":)" + std::to_string(m) + R"(,"translation":[)" +
                 std::to_string(3 * m) + ",0,0]}";
    }
    Read r(square(materials + nodes + "]," + meshes + "]"));
    ASSERT_EQ(r.mesh.materials.size(), 3u);
    const auto &m = r.mesh.materials;
    EXPECT_EQ(m[0].reflects, (std::array<float, 3>{0.5f, 0.25f, 1}));
    EXPECT_EQ(m[0].emits, (std::array<float, 3>{8, 4, 0}));
    EXPECT_EQ(m[1].reflects, (std::array<float, 3>{0.2f, 0.3f, 0.4f}));
    EXPECT_EQ(m[2].reflects, (std::array<float, 3>{1, 0, 0}));
    EXPECT_EQ(m[1].name, "a (2)");
    EXPECT_EQ(m[2].name, "unnamed 2");
    EXPECT_NEAR(r.area(), 4, 1e-6); // the first one has two sides
    EXPECT_EQ(
        r.notes,
        (Lines{"m.gltf: material unnamed 2: its baseColorFactor must lie between 0 and 1: more counts as 1",
               "m.gltf: alpha is not used, and all is opaque: material a",
               "m.gltf: materials with a name that was used before get a number: material a (2)",
               "m.gltf: metal counts as diffuse: material unnamed 2",
               "m.gltf: normalTexture is not used: material unnamed 2"}));
    // Changes name them
    EXPECT_EQ(Read(square(materials + nodes + "]," + meshes + "]"), "m.gltf",
                   {1, false, {readMaterialChange("--power", "a (2)=1,2,3")}})
                  .mesh.materials[1]
                  .emits,
              (std::array<float, 3>{1, 2, 3}));
    // Without any
    EXPECT_EQ(Read(square(kNode + kMesh)).mesh.materials[0].reflects[0], 0.7f);
}

// A picture of two rows, light above dark, in the file; its coordinates are bytes of the second set, turned
// by a quarter counter-clockwise and moved.
TEST(GltfReader, TakesPictures) {
    Writer w;
    w.add(5126, "VEC3", 4, kSquare);
    w.add<uint8_t>(5121, "VEC2", 4, {0, 0, 255, 0, 255, 255, 0, 255}, R"(,"normalized":true)");
    const std::string pnm = "P6 1 2 255\n\xff\xff\xff" + std::string(3, '\0');
    w.add<char>(5121, "SCALAR", 1, {pnm.begin(), pnm.end()});
    auto text = [&](const std::string &info, const std::string &image) {
        return w.text(
            kNode +
            R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_1":1},"mode":6,"material":0}]}],)"
            R"("textures":[{"source":0,"sampler":0}],"samplers":[{"wrapS":33071,"wrapT":33071}],"images":[)" +
            image +
            R"(],"materials":[{"pbrMetallicRoughness":{"metallicFactor":0,"baseColorFactor":[0.5,1,1,1],"baseColorTexture":{"index":0,)" +
            info + "}}}]");
    };
    const std::string
        plain = R"("texCoord":1)",
        moved =
            R"("extensions":{"KHR_texture_transform":{"texCoord":1,"offset":[0.25,0],"rotation":1.5707963267948966,"scale":[2,1]}})";
    Read r(text(plain, R"({"bufferView":2})"));
    ASSERT_EQ(r.error, "");
    EXPECT_EQ(r.notes, Lines{});
    const MeshPicture &p = r.mesh.materials[0].picture;
    EXPECT_EQ(p.tint, (std::array<float, 3>{0.5f, 1, 1}));
    EXPECT_TRUE(p.clamp);
    EXPECT_FLOAT_EQ(p.read().linear(0)[0], 1);
    EXPECT_FLOAT_EQ(p.read().linear(1)[0], 0);
    // v is counted from the bottom here
    EXPECT_EQ(r.mesh.coordinates[0], (std::array<float, 6>{0, 1, 1, 1, 1, 0}));
    r = Read(text(moved, R"({"uri":"data:image/x-portable-anymap;base64,)" + base64(pnm) + "\"}"));
    const std::array<float, 6> at = r.mesh.coordinates[0], right = {0.25f, 1, 0.25f, 3, 1.25f, 3};
    for (size_t k = 0; k < 6; ++k) EXPECT_NEAR(at[k], right[k], 1e-6) << k;
    EXPECT_FLOAT_EQ(r.mesh.materials[0].picture.read().linear(0)[0], 1);
    r = Read(text(plain, R"({"uri":"https://a/b.ppm"})"));
    EXPECT_EQ(r.notes, Lines{"m.gltf: a picture's URI has a scheme, and is not read: material unnamed 0"});
    // Beside the file, with a blank in its name; and missing
    common::TemporaryFolder folder;
    common::writeWhole(folder / "a b.ppm", pnm),
        common::writeWhole(folder / "m.gltf", text(plain, R"({"uri":"a%20b.ppm"})"));
    Lines notes;
    EXPECT_FLOAT_EQ(readModel(folder / "m.gltf", {}, notes).materials[0].picture.read().linear(0)[0], 1);
}

TEST(GltfReader, TakesLights) {
    const std::string lights =
        R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"directional","intensity":31.415926535897931,"color":[1,0.5,0]},)"
        R"({"type":"point","intensity":5},{"type":"spot","spot":{},"color":[0,1,0]}]}},)";
    auto node = [](int light, const char *more) {
        return R"({"extensions":{"KHR_lights_punctual":{"light":)" + std::to_string(light) + "}}," + more +
               "}";
    };
    // The sun shines along its -z: turned by a quarter about x, that is down
    Read r(square(lights + R"("nodes":[{"mesh":0},)" +
                  node(0, R"("rotation":[-0.70710678118,0,0,0.70710678118])") + "," +
                  node(1, R"("translation":[1,2,3])") + "," + node(2, R"("scale":[2,2,2])") + "]," + kMesh),
           "m.gltf", {10, false, {}});
    ASSERT_EQ(r.error, "");
    ASSERT_EQ(r.mesh.lights.suns.size(), 1u);
    expectNear(toDouble(r.mesh.lights.suns[0].towards), {0, 1, 0});
    expectNear(toDouble(r.mesh.lights.suns[0].light), {10, 5, 0}, 1e-5); // lux / pi
    ASSERT_EQ(r.mesh.lights.lamps.size(), 2u);
    const BallLamp &ball = r.mesh.lights.lamps[0];
    expectNear(toDouble(ball.centre), {10, 20, 30}, 1e-5);
    // Candela is radiance times the area of the disc, before --scale
    EXPECT_NEAR((double)(ball.radiance.x * ball.radius * ball.radius) * std::numbers::pi / 100, 5, 1e-4);
    EXPECT_EQ(r.mesh.lights.lamps[1].radiance.x, 0);
    EXPECT_EQ(r.notes,
              Lines{"m.gltf: 2 point or spot lights become balls, up to 0.00141 across; 1 spot shines "
                    "in all directions"});
    // A very bright ball is wide; a dark light is none; animations are noted
    auto one = [&](const char *intensity) {
        return Read(square(R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","intensity":)" +
                           std::string(intensity) + R"(}]}},"nodes":[{"mesh":0},)" +
                           node(0, R"("name":"n")") +
                           R"(],"animations":[{"name":"walk","channels":[],"samplers":[]}],)" + kMesh));
    };
    const std::string walk = "m.gltf: animations are not used: animation walk";
    EXPECT_EQ(one("1e12").notes,
              (Lines{"m.gltf: 1 point or spot light becomes a ball, up to 1.6 across", walk}));
    EXPECT_EQ(one("0").notes, Lines{walk});
    EXPECT_TRUE(one("0").mesh.lights.lamps.empty());
}

// The content decides, not the name.
TEST(GltfReader, TakesContainers) {
    Writer w;
    w.add(5126, "VEC3", 4, kSquare);
    const std::string rest = kNode + R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":6}]}])";
    const std::string whole = glb(w.text(rest, true), w.bytes);
    for (const char *name : {"m.glb", "m.gltf", "m.obj", "m"}) {
        EXPECT_NEAR(Read(whole, name).area(), 1, 1e-6) << name;
        EXPECT_NEAR(Read("\xef\xbb\xbf \n" + w.text(rest), name).area(), 1, 1e-6) << name;
    }
    EXPECT_NEAR(Read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "m.glb").area(), 0.5, 1e-6);
    std::string beside = w.text(rest, true);
    beside.replace(beside.find(R"("byteLength")"), 0, R"("uri":"a%20b.bin",)");
    EXPECT_NEAR(Read(beside, "m.gltf", {}, {{"a b.bin", w.bytes + "more"}}).area(), 1, 1e-6);
    EXPECT_EQ(Read(beside, "m.gltf", {}, {{"a b.bin", "short"}}).error, "m.gltf: buffer 0 has 5 of 48 bytes");
    EXPECT_NE(Read(beside).error.find("m.gltf: cannot read a b.bin"), std::string::npos)
        << Read(beside).error;
    for (size_t size = 4; size < whole.size(); size += 3)
        EXPECT_NE(Read(whole.substr(0, size), "m.glb").error.find("m.glb: "), std::string::npos) << size;
    // Chunks of other kinds may lie between
    const std::string more("\4\0\0\0MOREabcd", 12);
    std::string between = whole;
    between[8] = (char)(between[8] + 12), between.insert(12, more);
    ASSERT_GE((uint8_t)between[8], 12);
    EXPECT_NEAR(Read(between).area(), 1, 1e-6);
    std::string none = "glTF" + std::string("\2\0\0\0\30\0\0\0", 8) + more;
    EXPECT_EQ(Read(none).error, "m.gltf: has no JSON");
    // Damaged at the start: the name decides
    const std::string neither = "is neither .glb nor JSON in UTF-8: it is damaged, or another format";
    EXPECT_NEAR(Read(std::string(3000, '\n') + w.text(rest), "m").area(), 1, 1e-6);
    EXPECT_EQ(Read("").error, "m.gltf: is empty");
    EXPECT_EQ(Read("[]").error, "m.gltf: " + neither);
    EXPECT_EQ(Read(std::string("\xff\xfe{\0", 4)).error, "m.gltf: " + neither);
    EXPECT_EQ(Read("gLTF" + whole.substr(4), "m.GLB").error, "m.GLB: " + neither);
    EXPECT_EQ(Read("[]", "m.obj").error, "m.obj: holds no point");
    std::string other = whole;
    other[4] = 1;
    EXPECT_EQ(Read(other).error, "m.gltf: is glTF 1, and 2.0 is read");
    EXPECT_EQ(Read(whole.substr(0, 200)).error,
              "m.gltf: ends early: it has 200 of " + std::to_string(whole.size()) + " bytes");
}

TEST(GltfReader, RefusesDamage) {
    const std::string two =
        R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}])";
    auto changed = [&](const std::string &from, const std::string &to) {
        std::string text = square(two);
        size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return Read(text.replace(at, from.size(), to)).error;
    };
    EXPECT_EQ(changed("{", "{{"), "m.gltf: its JSON is damaged at byte 2");
    EXPECT_EQ(changed("asset", "assets"), "m.gltf: is JSON, but not glTF: it has no asset");
    EXPECT_EQ(changed("2.0", "1.0"), "m.gltf: is glTF 1.0, and 2.0 is read");
    EXPECT_EQ(changed("\"count\":4", "\"count\":5"),
              "m.gltf: an accessor of 5 items ends outside bufferView 0");
    EXPECT_EQ(changed("\"count\":4", "\"count\":9007199254740991"),
              "m.gltf: an accessor of 9007199254740991 items ends outside bufferView 0");
    EXPECT_EQ(changed("\"count\":4", "\"count\":4,\"byteOffset\":9007199254740991"),
              "m.gltf: an accessor of 4 items ends outside bufferView 0");
    EXPECT_EQ(changed("\"byteOffset\":0", "\"byteOffset\":9007199254740990"),
              "m.gltf: bufferView 0 ends outside its buffer");
    EXPECT_EQ(changed("\"byteLength\":48}", "\"byteLength\":48,\"byteStride\":252}"),
              "m.gltf: an accessor of 4 items ends outside bufferView 0");
    EXPECT_EQ(changed("\"bufferView\":0,", ""), "m.gltf: accessor 0 has no bufferView");
    EXPECT_EQ(changed("\"bufferView\":0", "\"bufferView\":7"), "m.gltf: there is no bufferView 7");
    EXPECT_EQ(changed("\"buffer\":0", "\"buffer\":1"), "m.gltf: there is no buffer 1");
    EXPECT_EQ(changed("VEC3", "VEC4"), "m.gltf: accessor 0 does not have the type that its use needs");
    EXPECT_EQ(changed("\"mesh\":0", "\"mesh\":1"), "m.gltf: there is no mesh 1");
    EXPECT_EQ(changed("\"mesh\":0", "\"mesh\":0,\"children\":[0]"), "m.gltf: holds no triangle");
    EXPECT_EQ(changed("[{\"mesh\":0}]",
                      "[{\"mesh\":0,\"children\":[1]},{\"children\":[0]}],\"scenes\":[{\"nodes\":[0]}]"),
              "m.gltf: node 0 has two parents, or is within itself");
    EXPECT_EQ(changed("\"indices\":1", "\"indices\":1,\"material\":3"), "m.gltf: there is no material 3");
    EXPECT_EQ(changed("\"indices\":1", "\"mode\":7"), "m.gltf: mesh 0 has a primitive of an unknown mode");
    EXPECT_EQ(changed("\"indices\":1", "\"mode\":1"), "m.gltf: holds no triangle");
    EXPECT_EQ(changed("\"asset\"", R"("extensionsRequired":["KHR_draco_mesh_compression"],"asset")"),
              "m.gltf: needs KHR_draco_mesh_compression, which is not read: export it without");
    EXPECT_EQ(
        changed("\"asset\"", "\"extras\":" + std::string(200, '[') + std::string(200, ']') + ",\"asset\""),
        "m.gltf: its JSON is nested too deeply");
    EXPECT_EQ(
        changed(
            "\"nodes\":",
            R"("materials":[{"name":"floor","pbrMetallicRoughness":{"baseColorFactor":[-1,0,0,1]}}],"nodes":)"),
        "m.gltf: material floor: baseColorFactor must lie between 0 and 1");
    EXPECT_TRUE(changed("data:application/octet-stream;base64,", "http://a/")
                    .starts_with("m.gltf: buffer 0 is not read, as its URI has a scheme: http://a/AAAA"));
    // Of another type: a property, and its right type
    const std::string index = "a whole number below 2^31", size = "a whole number below 2^53",
                      number = "a number", three = "a list of 3 numbers", floor = "\"materials\":[{",
                      light = R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"point",)";
    struct Wrong {
        std::string from, to, right;
    };
    for (const auto &[from, to, right] : {
             Wrong{"\"indices\":1", "\"material\":\"lamp\"", index},
             {"\"indices\":1", "\"material\":2.0", index},
             {"\"indices\":1", "\"material\":4294967296", index},
             {"\"indices\":1", "\"material\":-1", index},
             {"\"indices\":1", "\"indices\":-3", index},
             {"\"indices\":1", "\"indices\":{}", index},
             {"\"indices\":1", "\"mode\":-9", index},
             {"\"mesh\":0", "\"mesh\":-5", index},
             {"\"mesh\":0", "\"mesh\":4294967296", index},
             {"\"POSITION\":0", "\"POSITION\":0.5", index},
             {"\"nodes\":", "\"scene\":-5,\"nodes\":", index},
             {"\"nodes\":", "\"scene\":\"a\",\"nodes\":", index},
             {"{\"mesh\":0}", "{\"children\":[0.5],\"mesh\":0}", "a list of whole numbers below 2^31"},
             {"\"count\":4", "\"count\":4,\"sparse\":{\"count\":4294967296}", index},
             {"\"count\":4", "\"count\":18446744073709551616", size},
             {"\"byteOffset\":0", "\"byteOffset\":-1", size},
             {"\"byteOffset\":0", "\"byteOffset\":1e300", size},
             {"\"byteOffset\":0", "\"byteStride\":18446744073709551615", size},
             {"\"mesh\":0", "\"translation\":[\"a\",2,3]", three},
             {"\"mesh\":0", "\"translation\":5", three},
             {"\"mesh\":0", "\"scale\":[1,2]", three},
             {"\"mesh\":0", R"("extensions":{"KHR_lights_punctual":{"light":"a"}})", index},
             {"\"nodes\":", R"("extensions":{"KHR_lights_punctual":{"lights":"q"}},"nodes":)",
              "a list of objects"},
             {"\"nodes\":", light + R"("intensity":"8"}]}},"nodes":)", number},
             {"\"nodes\":", light + R"("color":[1]}]}},"nodes":)", three},
             {"\"nodes\":", floor + R"("pbrMetallicRoughness":{"baseColorFactor":"red"}}],"nodes":)",
              "a list of 4 numbers"},
             {"\"nodes\":", floor + R"("pbrMetallicRoughness":{"metallicFactor":"0"}}],"nodes":)",
              "a number, or a list of numbers"},
             {"\"nodes\":", floor + R"("doubleSided":1}],"nodes":)", "true or false"},
             {"\"nodes\":",
              floor +
                  R"("extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":"10"}}}],"nodes":)",
              number},
         }) {
        const std::string error = changed(from, to);
        EXPECT_TRUE(error.starts_with("m.gltf: ") && error.ends_with(" is not " + right))
            << to << ": " << error;
    }
    // What is not read may be anything
    EXPECT_EQ(changed("\"mesh\":0", R"("mesh":0,"extras":{"mesh":-1},"extensions":{"VRM":{"mesh":-1}})"), "");
    Writer w;
    w.add<float>(5126, "VEC3", 3, {0, 0, 0, 1, 0, 0, NAN, 1, 0});
    w.add<uint8_t>(5121, "SCALAR", 3, {0, 1, 3});
    EXPECT_EQ(Read(w.text(two)).error, "m.gltf: mesh 0 has an index beyond its 3 points");
    Writer n;
    n.add<float>(5126, "VEC3", 3, {0, 0, 0, 1, 0, 0, NAN, 1, 0});
    EXPECT_EQ(
        Read(n.text(R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])"))
            .error,
        "m.gltf: mesh 0 has a coordinate that is not a number below 1e18");
    // A chain of nodes as deep as there are nodes
    std::string chain = R"("nodes":[{"mesh":0})";
    for (int i = 0; i < 50000; ++i) chain += R"(,{"children":[)" + std::to_string(i) + "]}";
    EXPECT_NEAR(Read(square(chain + "]," + kMesh)).area(), 1, 1e-6);
}
