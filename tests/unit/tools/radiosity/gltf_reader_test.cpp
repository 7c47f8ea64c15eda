// Tests the reader of glTF, with files as other programs write them and damaged ones: triangles, transforms,
// materials and lights.
#include "tests/support/read_model.h"
#include "tools/common/text.h"

#include <numbers>

using namespace odraz;
using namespace odraz::radiosity;

static std::string dataUri(const std::string &bytes) {
    std::string text = "data:application/octet-stream,";
    for (char byte : bytes) common::append(text, "%%%02x", (uint8_t)byte);
    return text;
}

// Replaces ' by ": JSON in this file is written with '.
static std::string json(std::string text) {
    std::replace(text.begin(), text.end(), '\'', '"');
    return text;
}

// Writes a file: lists of numbers, each with its own view and accessor, and the JSON around them.
struct Writer {
    std::string bytes, views, accessors;
    int count = 0;

    template <class T>
    Writer &add(const std::string &type, const std::vector<T> &values, const std::string &more = "",
                const std::string &view = "", size_t items = 0) {
        const int component =
            std::is_same_v<T, float> ? 5126 : 5120 + (int)sizeof(T) / 2 * 2 + std::is_unsigned_v<T>;
        const size_t width = type == "SCALAR" ? 1 : type == "MAT4" ? 16 : (size_t)(type.back() - '0');
        views += common::format("%s{'buffer':0,'byteOffset':%zu,'byteLength':%zu%s}", count ? "," : "",
                                bytes.size(), values.size() * sizeof(T), view.c_str());
        accessors += common::format("%s{'bufferView':%d,'componentType':%d,'count':%zu,'type':'%s'%s}",
                                    count ? "," : "", count, component, items ? items : values.size() / width,
                                    type.c_str(), more.c_str());
        bytes.append((const char *)values.data(), values.size() * sizeof(T));
        bytes.resize((bytes.size() + 3) / 4 * 4);
        ++count;
        return *this;
    }
    std::string text(const std::string &rest, const std::string &uri) const {
        return json("{'asset':{'version':'2.0'},'buffers':[{'byteLength':" + std::to_string(bytes.size()) +
                    uri + "}],'bufferViews':[" + views + "],'accessors':[" + accessors + "]," + rest + "}");
    }
    std::string text(const std::string &rest) const { return text(rest, ",'uri':'" + dataUri(bytes) + "'"); }
};

const std::vector<float> kSquare = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}; // faces +z
const std::string kNode = "'nodes':[{'mesh':0}],",
                  kMesh = "'meshes':[{'primitives':[{'attributes':{'POSITION':0},'indices':1}]}]",
                  kFan = "'meshes':[{'primitives':[{'attributes':{'POSITION':0},'mode':6}]}]";

// A file with the square as accessor 0 and its corners as accessor 1.
static std::string square(const std::string &rest) {
    return Writer().add("VEC3", kSquare).add<uint16_t>("SCALAR", {0, 1, 2, 0, 2, 3}).text(rest);
}

struct Read : ReadModel {
    using ReadModel::ReadModel;
    // The sum of areas times normals
    Vec3d facing() const {
        return std::accumulate(mesh.triangles.begin(), mesh.triangles.end(), Vec3d{},
                               [&](Vec3d sum, const Triangle &t) { return sum + normalOf(mesh, t) / 2; });
    }
};

// Reads the square with these nodes.
static Read readSquare(const std::string &nodes) { return Read(square(nodes + "," + kMesh)); }

static void expectNear(Vec3d a, Vec3d b, double within = 1e-6) {
    for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], within) << k;
}

// Four points form two triangles, in all modes and with all types of indices.
TEST(GltfReader, TakesAllTriangles) {
    const std::pair<int, std::vector<uint32_t>> cases[] = {
        {4, {0, 1, 2, 0, 2, 3}}, {5, {0, 1, 3, 2}}, {5, {0, 1, 3, 3, 2, 2, 1, 3}}, {6, {0, 1, 2, 3}}};
    for (const auto &[mode, corners] : cases)
        for (int wide : {1, 2, 4, 0}) {
            Writer w;
            std::vector<float> points;
            for (uint32_t k : corners) points.insert(points.end(), &kSquare[3 * k], &kSquare[3 * k] + 3);
            w.add("VEC3", wide ? kSquare : points);
            if (wide == 1) w.add<uint8_t>("SCALAR", {corners.begin(), corners.end()});
            if (wide == 2) w.add<uint16_t>("SCALAR", {corners.begin(), corners.end()});
            if (wide == 4) w.add("SCALAR", corners);
            Read r(w.text(kNode + "'meshes':[{'primitives':[{'attributes':{'POSITION':0},'mode':" +
                          std::to_string(mode) + (wide ? ",'indices':1" : "") + "}]}]"));
            EXPECT_EQ(r.error, "");
            if (corners.size() < 8 || wide) expectNear(r.facing(), {0, 0, 1});
            EXPECT_EQ(r.mesh.triangles.size(), 2u) << mode << " " << wide;
        }
}

TEST(GltfReader, TakesAllNumbers) {
    auto expectFacing = [](double z, const Writer &w) {
        expectNear(Read(w.text(kNode + kFan)).facing(), {0, 0, z});
    };
    // Interleaved with other data
    std::vector<float> wide;
    for (size_t i = 0; i < 12; i += 3)
        wide.insert(wide.end(), {9, 9, kSquare[i], kSquare[i + 1], kSquare[i + 2]});
    expectFacing(1, Writer().add("VEC3", wide, ",'byteOffset':8", ",'byteStride':20", 4));
    // Quantised: normalised 65535 and 127 are 1; other integers keep their values
    const std::string normal = ",'normalized':true";
    const std::vector<int8_t> bytes = {-128, 0, 0, 0, 127, 0, 0, 0, 127, 127, 0, 0, -128, 127, 0, 0};
    expectFacing(
        1, Writer().add<uint16_t>("VEC3", {0, 0, 0, 65535, 0, 0, 65535, 65535, 0, 0, 65535, 0}, normal));
    expectFacing(2, Writer().add("VEC3", bytes, normal, ",'byteStride':4", 4));
    expectFacing(30, Writer().add<int16_t>("VEC3", {-3, 0, 0, 3, 0, 0, 3, 5, 0, -3, 5, 0}));
    // Sparse: the third point moves from 1,1 to 3,3
    const std::string sparse = ",'sparse':{'count':1,'indices':{'bufferView':1,'componentType':5121},"
                               "'values':{'bufferView':2}}";
    expectFacing(
        3, Writer().add("VEC3", kSquare, sparse).add<uint8_t>("SCALAR", {2}).add<float>("VEC3", {3, 3, 0}));
}

// A square of 2 x 3, rotated by 90 degrees about x, then transformed by its parent.
TEST(GltfReader, PlacesNodes) {
    Read r = readSquare(
        "'nodes':[{'mesh':0},{'children':[2],'translation':[10,0,0],'scale':[2,2,2]},"
        "{'mesh':0,'scale':[1,1.5,7],'rotation':[0.70710678,0,0,0.70710678],'translation':[1,1,1]}],"
        "'scene':0,'scenes':[{'nodes':[1]},{'nodes':[0]}]");
    expectNear(r.facing(), {0, -6, 0});
    auto [lo, hi] = boxOf(r.mesh.points);
    expectNear(lo + toDouble(r.mesh.origin), {12, 2, 2}, 1e-5);
    expectNear(hi + toDouble(r.mesh.origin), {14, 2, 5}, 1e-5);
    EXPECT_EQ(r.notes, Lines{"m.gltf: one of its 2 scenes is read"});
    // Matrices are stored by columns. A mirrored triangle still faces the same side
    const Read mirrored = readSquare("'nodes':[{'mesh':0,'matrix':[-2,0,0,0, 0,1,0,0, 0,0,1,0, 5,6,7,1]}]");
    expectNear(mirrored.facing(), {0, 0, 2});
    expectNear(boxOf(mirrored.mesh.points).second + toDouble(mirrored.mesh.origin), {5, 7, 7});
    // Without a scene all root nodes are used. Nodes may share a mesh
    Read shared = readSquare("'nodes':[{'mesh':0},{'mesh':0,'translation':[3,0,0],'children':[2]},"
                             "{'mesh':0,'translation':[3,0,0]}]");
    EXPECT_NEAR(shared.area(), 3, 1e-6);
    // A skinned mesh keeps its bind pose: the transform of the first joint counts, not the transform of its
    // node
    Read skinned(Writer()
                     .add("VEC3", kSquare)
                     .add<float>("MAT4", {3, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1})
                     .text("'nodes':[{'mesh':0,'skin':0,'scale':[9,9,9]},{'translation':[4,0,0]}],"
                           "'skins':[{'joints':[1],'inverseBindMatrices':1}]," +
                           kFan));
    expectNear(skinned.facing(), {0, 0, 3});
    EXPECT_EQ(skinned.notes, Lines{"m.gltf: skins are not deformed: meshes keep their bind pose: node 0"});
    // Without an inverse bind matrix, the transform of the joint alone counts
    Read bare = readSquare("'nodes':[{'mesh':0,'skin':0,'scale':[9,9,9]},{'scale':[2,1,1]}],"
                           "'skins':[{'joints':[1]}]");
    EXPECT_EQ(bare.error, "");
    expectNear(bare.facing(), {0, 0, 2});
    // The weights of morph targets are the mesh's, unless the node has its own. Unused objects may be
    // incomplete
    for (const auto &[weights, area] :
         {std::pair{"", 4.}, {",'weights':[0]", 1.}, {",'weights':[0.5,7]", 2.25}}) {
        Read morphed(square("'nodes':[{'mesh':0" + std::string(weights) +
                            "}],'cameras':[{}],'animations':[{'name':'a','channels':[{'sampler':0}]}],"
                            "'meshes':[{'weights':[1],'primitives':[{'attributes':{'POSITION':0},'indices':1,"
                            "'targets':[{'POSITION':0}]}]}]"));
        expectNear(morphed.facing(), {0, 0, area});
        EXPECT_EQ(morphed.notes, Lines{"m.gltf: animations are not used: animation a"});
    }
}

TEST(GltfReader, TakesMaterials) {
    std::string rest =
        "'materials':[{'name':'a','doubleSided':true,"
        "'pbrMetallicRoughness':{'baseColorFactor':[0.5,0.25,1,0.5],'metallicFactor':0},"
        "'emissiveFactor':[1,0.5,0],'extensions':{'KHR_materials_emissive_strength':{'emissiveStrength':8}}},"
        "{'name':'a','extensions':"
        "{'KHR_materials_pbrSpecularGlossiness':{'diffuseFactor':[0.2,0.3,0.4,1]}}},"
        "{'normalTexture':{'index':0},'pbrMetallicRoughness':{'baseColorFactor':[2,0,0,1],'metallicFactor':1}"
        "}],'meshes':[";
    for (int m = 0; m < 3; ++m)
        rest += common::format("%s{'primitives':[{'attributes':{'POSITION':0},'indices':1,'material':%d}]}",
                               m ? "," : "", m);
    const std::string file = square(rest + "],'nodes':[{'mesh':0},{'mesh':1,'translation':[3,0,0]},"
                                           "{'mesh':2,'translation':[6,0,0]}]");
    Read r(file);
    ASSERT_EQ(r.mesh.materials.size(), 3u);
    const auto &m = r.mesh.materials;
    EXPECT_EQ(m[0].reflects, (Colour{0.5f, 0.25f, 1}));
    EXPECT_EQ(m[0].emits, (Colour{8, 4, 0}));
    EXPECT_EQ(m[1].reflects, (Colour{0.2f, 0.3f, 0.4f}));
    EXPECT_EQ(m[2].reflects, (Colour{1, 0, 0}));
    EXPECT_NEAR(r.area(), 4, 1e-6); // the first one is lit from both sides
    EXPECT_EQ(r.notes, (Lines{"m.gltf: material unnamed 2: its baseColorFactor is above 1, and counts as 1",
                              "m.gltf: alpha is not used, so all surfaces are opaque: material a",
                              "m.gltf: materials that share a name get a number: material a (2)",
                              "m.gltf: metal counts as diffuse: material unnamed 2",
                              "m.gltf: normalTexture is not used: material unnamed 2"}));
    // Options find materials by the new names
    const ReadSettings changed = {1, false, {readMaterialChange("--power", "a (2)=1,2,3")}};
    EXPECT_EQ(Read(file, "m.gltf", changed).mesh.materials[1].emits, (Colour{1, 2, 3}));
    // Without materials
    EXPECT_EQ(Read(square(kNode + kMesh)).mesh.materials[0].reflects[0], 0.7f);
}

// An embedded picture of two rows, light above dark. Its coordinates are bytes of the second set, rotated by
// 90 degrees and moved.
TEST(GltfReader, TakesPictures) {
    const std::string pnm = "P6 1 2 255\n\xff\xff\xff" + std::string(3, '\0');
    const Writer w = Writer()
                         .add("VEC3", kSquare)
                         .add<uint8_t>("VEC2", {0, 0, 255, 0, 255, 255, 0, 255}, ",'normalized':true")
                         .add<char>("SCALAR", {pnm.begin(), pnm.end()});
    auto read = [&](const std::string &info, const std::string &image) {
        return Read(w.text(kNode +
                           "'meshes':[{'primitives':[{'attributes':{'POSITION':0,'TEXCOORD_1':1},'mode':6,"
                           "'material':0}]}],'textures':[{'source':0,'sampler':0}],"
                           "'samplers':[{'wrapS':33071,'wrapT':33071}],'images':[" +
                           image +
                           "],'materials':[{'pbrMetallicRoughness':{'metallicFactor':0,"
                           "'baseColorFactor':[0.5,1,1,1],'baseColorTexture':{'index':0," +
                           info + "}}}]"),
                    "m.gltf", {}, "a b.ppm", pnm);
    };
    const std::string plain = "'texCoord':1";
    Read r = read(plain, "{'bufferView':2}");
    ASSERT_EQ(r.error, "");
    EXPECT_EQ(r.notes, Lines{});
    EXPECT_EQ(r.mesh.materials[0].picture.tint, (Colour{0.5f, 1, 1}));
    EXPECT_TRUE(r.mesh.materials[0].picture.clamp);
    EXPECT_FLOAT_EQ(r.picture.linear(0)[0], 1);
    EXPECT_FLOAT_EQ(r.picture.linear(1)[0], 0);
    // v points up here, down in glTF
    EXPECT_EQ(r.mesh.coordinates[0], (std::array<float, 6>{0, 1, 1, 1, 1, 0}));
    r = read("'extensions':{'KHR_texture_transform':{'texCoord':1,'offset':[0.25,0],"
             "'rotation':1.5707963267948966,'scale':[2,1]}}",
             "{'uri':'data:image/x-portable-anymap,P6 1%202%0a255%20%ff%FF%ff%00%00%00'}");
    EXPECT_EQ(r.notes, Lines{});
    const std::array<float, 6> at = r.mesh.coordinates[0], right = {0.25f, 1, 0.25f, 3, 1.25f, 3};
    for (size_t k = 0; k < 6; ++k) EXPECT_NEAR(at[k], right[k], 1e-6) << k;
    EXPECT_FLOAT_EQ(r.picture.linear(0)[0], 1);
    // A file next to the model, with a blank in its name; and a picture with a URL
    EXPECT_FLOAT_EQ(read(plain, "{'uri':'a%20b.ppm'}").picture.linear(0)[0], 1);
    EXPECT_EQ(read(plain, "{'uri':'https://a/b.ppm'}").notes,
              Lines{"m.gltf: a picture's URI has a scheme, and is not read: material unnamed 0"});
    // The model is read in spite of a damaged picture
    for (const auto &[image, why] : {std::pair{"{'uri':'data:image/png'}", "a data URI has no data"},
                                     {"{'bufferView':9}", "there is no bufferView 9"},
                                     {"{}", "a bufferView is missing"}})
        EXPECT_EQ(read(plain, image).notes,
                  Lines{std::string("m.gltf: a picture is damaged: ") + why + ": material unnamed 0"});
}

// Base64 with line breaks and blanks, partly percent-encoded.
TEST(GltfReader, TakesDataUris) {
    for (const char *by : {"\\n", " ", "%0A", "\\t\\r"}) {
        std::string text = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAA"; // kSquare
        for (size_t at = text.size(); at -= 8;) text.insert(at, by);
        for (size_t at; (at = text.find('g')) != std::string::npos;) text.replace(at, 1, "%67");
        Read r(Writer().add("VEC3", kSquare).text(kNode + kFan, ",'uri':'data:;base64," + text + "'"));
        EXPECT_EQ(r.error, "");
        expectNear(r.facing(), {0, 0, 1});
    }
}

TEST(GltfReader, TakesLights) {
    auto read = [](const std::string &lights, const std::string &rest, double scale) {
        return Read(
            square("'extensions':{'KHR_lights_punctual':{'lights':[" + lights + "]}}," + rest + kMesh),
            "m.gltf", {scale, false, {}});
    };
    auto node = [](int light, const char *more) {
        return common::format(",{'extensions':{'KHR_lights_punctual':{'light':%d}},%s}", light, more);
    };
    // A sun shines along its -z: downwards if rotated by -90 degrees about x
    Read r = read("{'type':'directional','intensity':31.415926535897931,'color':[1,0.5,0]},"
                  "{'type':'point','intensity':5},{'type':'spot','spot':{},'color':[0,1,0]}",
                  "'nodes':[{'mesh':0}" + node(0, "'rotation':[-0.70710678118,0,0,0.70710678118]") +
                      node(1, "'translation':[1,2,3]") + node(2, "'scale':[2,2,2]") + "],",
                  10);
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
    // Very bright balls are enlarged; dark lights are left out; animations are noted
    auto one = [&](const char *intensity) {
        return read("{'type':'point','intensity':" + std::string(intensity) + "}",
                    "'nodes':[{'mesh':0}" + node(0, "'name':'n'") +
                        "],'animations':[{'name':'walk','channels':[],'samplers':[]}],",
                    1);
    };
    const std::string walk = "m.gltf: animations are not used: animation walk";
    EXPECT_EQ(one("1e12").notes,
              (Lines{"m.gltf: 1 point or spot light becomes a ball, up to 1.6 across", walk}));
    EXPECT_EQ(one("0").notes, Lines{walk});
    EXPECT_TRUE(one("0").mesh.lights.lamps.empty());
}

// The content of a file selects the format, not its name.
TEST(GltfReader, TakesContainers) {
    auto word = [](size_t value) {
        uint32_t four = (uint32_t)value;
        return std::string((const char *)&four, 4);
    };
    auto chunk = [&](const std::string &kind, std::string content) {
        content.resize((content.size() + 3) / 4 * 4, ' ');
        return word(content.size()) + kind + content;
    };
    auto glb = [&](const std::string &chunks) {
        return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
    };
    Writer w;
    w.add("VEC3", kSquare);
    const std::string text = w.text(kNode + kFan), more = chunk("MORE", "abcd"),
                      both =
                          chunk("JSON", w.text(kNode + kFan, "")) + chunk(std::string("BIN\0", 4), w.bytes),
                      whole = glb(both), external = w.text(kNode + kFan, ",'uri':'a%20b.bin'");
    for (const char *name : {"m.glb", "m.gltf", "m.obj", "m"}) {
        EXPECT_NEAR(Read(whole, name).area(), 1, 1e-6) << name;
        EXPECT_NEAR(Read("\xef\xbb\xbf \n" + text, name).area(), 1, 1e-6) << name;
    }
    EXPECT_NEAR(Read(glb(more + both)).area(), 1, 1e-6); // chunks of other kinds are skipped
    EXPECT_NEAR(Read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "m.glb").area(), 0.5, 1e-6);
    EXPECT_NEAR(Read(external, "m.gltf", {}, "a b.bin", w.bytes + "more").area(), 1, 1e-6);
    EXPECT_NEAR(Read(std::string(3000, '\n') + text, "m").area(), 1, 1e-6);
    for (size_t size = 4; size < whole.size(); size += 3)
        EXPECT_TRUE(Read(whole.substr(0, size), "m.glb").error.starts_with("m.glb: ")) << size;
    const std::string neither = "is neither .glb nor JSON in UTF-8: it is damaged, or another format";
    const std::pair<Read, std::string> refused[] = {
        {Read(external, "m.gltf", {}, "a b.bin", "short"), "buffer 0 has 5 of 48 bytes"},
        {Read(external), "cannot read a b.bin: No such file or directory"},
        {Read(glb(more)), "has no JSON"},
        {Read(""), "is empty"},
        {Read("[]"), neither},
        {Read(std::string("\xff\xfe{\0", 4)), neither},
        {Read("gLTF" + whole.substr(4)), neither},
        {Read("glTF\1" + whole.substr(5)), "is glTF 1: only 2.0 is read"},
        {Read(whole.substr(0, 200)), "ends early: it has 200 of " + std::to_string(whole.size()) + " bytes"},
    };
    for (const auto &[read, error] : refused) EXPECT_EQ(read.error, "m.gltf: " + error);
    EXPECT_TRUE(Read("[]", "m.obj").error.starts_with("m.obj: is neither Wavefront OBJ nor glTF 2.0"));
}

// Replaces a part of a good file, and expects these errors.
TEST(GltfReader, RefusesDamage) {
    auto changed = [&](const std::string &from, const std::string &to) {
        std::string text = square(kNode + kMesh);
        size_t at = text.find(json(from));
        EXPECT_NE(at, std::string::npos) << from;
        return Read(text.replace(at, from.size(), json(to))).error;
    };
    const std::string outside = " items ends outside bufferView 0",
                      index = " is not a whole number below 2^31", size = " is not a whole number below 2^53",
                      before = "'nodes':", floor = "'materials':[{'name':'floor',",
                      nodes = "}],'nodes':", lights = "'extensions':{'KHR_lights_punctual':{'lights':";
    const std::tuple<std::string, std::string, std::string> cases[] = {
        {"{", "{{", "its JSON is damaged at byte 2"},
        {"asset", "assets", "is JSON, but not glTF: it has no asset"},
        {"2.0", "1.0", "is glTF 1.0: only 2.0 is read"},
        {"{'version':'2.0'}", "{'version':'1.0'},'scene':'s'", "is glTF 1.0: only 2.0 is read"},
        {"{'version':'2.0'}", "{'version':1.1},'scene':'s'", "is glTF 1.1: only 2.0 is read"},
        {"'asset':{'version':'2.0'}", "'scenes':{'s':{}},'scene':'s'", "is glTF 1.0: only 2.0 is read"},
        {"'2.0'", "'2.0','minVersion':'2.1'", "is glTF 2.1: only 2.0 is read"},
        {"{'version':'2.0'}", "[]", "asset is not an object"},
        {"'asset'", "'extensionsRequired':['KHR_draco_mesh_compression'],'asset'",
         "needs KHR_draco_mesh_compression, which is not read: export the model without it"},
        {"'count':4", "'count':5", "an accessor of 5" + outside},
        {"'count':4", "'count':9007199254740991", "an accessor of 9007199254740991" + outside},
        {"'count':4", "'count':4,'byteOffset':9007199254740991", "an accessor of 4" + outside},
        {"'byteLength':48}", "'byteLength':48,'byteStride':252}", "an accessor of 4" + outside},
        {"'byteOffset':0", "'byteOffset':9007199254740990", "bufferView 0 ends outside its buffer"},
        {"'bufferView':0,", "", "accessor 0 has no bufferView"},
        {"'buffer':0", "'buffer':1", "there is no buffer 1"},
        {"'buffer':0,", "", "a buffer is missing"},
        {"'componentType':5126,", "", "a componentType is missing"},
        {"VEC3", "VEC4", "accessor 0 has the wrong type for its use"},
        {"'mesh':0", "'mesh':0,'children':[0]", "holds no triangle"},
        {"[{'mesh':0}]", "[{'mesh':0,'children':[1]},{'children':[0]}],'scenes':[{'nodes':[0]}]",
         "node 0 has two parents, or is within itself"},
        {"'indices':1", "'indices':1,'material':3", "there is no material 3"},
        {"'indices':1", "'mode':7", "mesh 0 has a primitive of an unknown mode"},
        {"'indices':1", "'mode':1", "holds no triangle"},
        {before, floor + "'pbrMetallicRoughness':{'baseColorFactor':[-1,0,0,1]}" + nodes,
         "material floor: baseColorFactor must lie between 0 and 1"},
        // Wrong types
        {"'indices':1", "'material':'lamp'", "material" + index},
        {"'indices':1", "'material':4294967296", "material" + index},
        {"'indices':1", "'indices':-3", "indices" + index},
        {"'count':4", "'count':4,'sparse':{'count':-1}", "count" + size},
        {"'count':4", "'count':18446744073709551616", "count" + size},
        {"'byteOffset':0", "'byteOffset':1e300", "byteOffset" + size},
        {"{'mesh':0}", "{'children':[0.5],'mesh':0}", "children is not a list of whole numbers below 2^31"},
        {"'mesh':0", "'translation':['a',2,3]", "translation is not a list of numbers"},
        {"'mesh':0", "'mesh':0,'translation':[1,2]", "translation is not a list of 3 numbers"},
        {before, lights + "'q'}},'nodes':", "lights is not a list of objects"},
        {"[{'mesh':0}],",
         "[{'mesh':0,'extensions':{'KHR_lights_punctual':{'light':0}}}]," + lights + "[{'intensity':'8'}]}},",
         "intensity is not a number"},
        {before, floor + "'pbrMetallicRoughness':{'metallicFactor':'0'}" + nodes,
         "metallicFactor is not a number"},
        {before, floor + "'doubleSided':1" + nodes, "doubleSided is not true or false"},
    };
    for (const auto &[from, to, error] : cases) EXPECT_EQ(changed(from, to), "m.gltf: " + error);
    EXPECT_TRUE(changed("data:application/octet-stream,", "http://a/")
                    .starts_with("m.gltf: buffer 0 is not read, as its URI has a scheme: http://a/%00"));
    EXPECT_EQ(changed("data:application/octet-stream,", "data:;base64,*"), "m.gltf: a data URI is damaged");
    // Parts that are not read may have any type, and any depth
    EXPECT_EQ(changed("'mesh':0", "'mesh':0,'extras':{'mesh':-1},'extensions':{'VRM':{'mesh':-1}}"), "");
    EXPECT_EQ(changed("'mesh':0", "'mesh':0,'extras':" + std::string(100000, '[') + std::string(100000, ']')),
              "");
    Writer w;
    w.add<float>("VEC3", {0, 0, 0, 1, 0, 0, NAN, 1, 0});
    EXPECT_EQ(Read(w.text(kNode + kFan)).error,
              "m.gltf: mesh 0 has a coordinate that is not a number below 1e18");
    w.add<uint8_t>("SCALAR", {0, 1, 3});
    EXPECT_EQ(Read(w.text(kNode + kMesh)).error, "m.gltf: mesh 0 has an index beyond its 3 points");
    // A chain of 50,001 nodes
    std::string chain = "'nodes':[{'mesh':0}";
    for (int i = 0; i < 50000; ++i) chain += ",{'children':[" + std::to_string(i) + "]}";
    EXPECT_NEAR(readSquare(chain + "]").area(), 1, 1e-6);
}
