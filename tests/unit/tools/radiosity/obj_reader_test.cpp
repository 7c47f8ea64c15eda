// Tests the reader of Wavefront OBJ with files as other programs write them: text, numbers, materials, notes.
#include "tests/support/read_model.h"
#include "tools/picture/picture.h"

#include <map>

using namespace odraz;
using namespace odraz::radiosity;

struct ReadObj : ReadModel {
    explicit ReadObj(const std::string &obj, const std::string &mtl = "", const ReadSettings &settings = {})
        : ReadModel(obj, "m.obj", settings, "m.mtl", mtl) {}
};

const std::string kObjSquare = "v 0 0 0\nv 0 0 12\nv 12 0 12\nv 12 0 0\n";

// Reads the square with a material of m.mtl.
static ReadObj squareOf(const std::string &mtl, const std::string &name = "a") {
    return ReadObj("mtllib m.mtl\n" + kObjSquare + "usemtl " + name + "\nf 1 2 3 4\n", mtl);
}

static std::string utf16(const std::string &text, bool mark, bool bigEndian) {
    std::string to;
    auto put = [&](uint16_t unit) {
        char low = (char)(unit & 255), high = (char)(unit >> 8);
        to += bigEndian ? high : low, to += bigEndian ? low : high;
    };
    if (mark) put(0xfeff);
    for (char c : text) put((uint8_t)c);
    return to;
}

// The square is read from each of these, without a note.
TEST(ObjReader, TakesAllFormsOfLines) {
    for (const char *polygon :
         {"f 1 2 3 4", "f 1/ 2/ 3/ 4/", "f 1// 2// 3// 4//", "f 1//0 2//0 3//0 4//0", "f 1/0/0 2/0 3/0/ 4",
          "f -4 -3/-1 -2//-1 -1/1/1", "fo 1 2 3 4", "f 1 2 \\\n3 4", "f 1 2 3 4 # 5", "f 1/9/9 2//9 3/-9 4",
          "f\t1\t2\t3\t4", "  f 1 2 3 4  \r", "f 1 2 3 4\r\r",
          "o\ng\ng a b c\ns off\ns 1\nf 1 2 3\ns\nf 1 3 4", "mg 1 0.5\nbevel on\n$!?\nf 1 2 3 4",
          "v 5 5 5\nf 1 2 3 4", "usemtl\nmtllib\nf 1 2 3 4"}) {
        ReadObj r(kObjSquare + "vt 0 0\nvn 0 1 0\n" + polygon + "\n");
        EXPECT_EQ(r.error, "") << polygon;
        EXPECT_NEAR(r.area(), 144, 1e-9) << polygon;
        EXPECT_EQ(r.notes, Lines{}) << polygon;
    }
    const std::string unit = "v -0 +0.0 0 1 0 0\nv .0 0. 1 # a\n  v 1e0 0 1.0E+00 1.0\nv 100e-2 0 \\\n.0e5\n";
    for (const std::string &text : {unit + "f 1 2 3 4", "f 1 2 3 4\n" + unit, unit + unit + "f 1 2 3 4"})
        EXPECT_NEAR(ReadObj(text).area(), 1, 1e-9) << text;
}

// Polygons of any shape are read; a note names those that are left out.
TEST(ObjReader, TakesAllShapes) {
    const std::tuple<std::string, double, std::string> cases[] = {
        {"v 0 0 0\nv 0 0 3\nv 1 0 3\nv 1 0 1\nv 3 0 1\nv 3 0 0\nf 1 2 3 4 5 6\n", 5, ""}, // not convex
        {"v 0 0 0\nv 0 0 1\nv 1 0 1\nf 1 2 3\nf 1 2\nf 3\nf\n", 0.5,
         "m.obj: left out 3 polygons with fewer than three points"},
        {"v 0 0 0\nv 0 0 1\nv 1 0 1\nf 1 2 3\nf 2 3 1\n", 0.5, "m.obj: left out 1 triangle given twice"},
        {"v 0 0 0\nv 0 0 1\nv 1 0 1\nf 1 2 3\nf 1 1 2\nf 1 2 2\n", 0.5,
         "m.obj: left out 2 triangles without area"},
    };
    for (const auto &[text, area, note] : cases) {
        ReadObj r(text);
        EXPECT_NEAR(r.area(), area, 1e-9) << text;
        EXPECT_EQ(r.notes, note.empty() ? Lines{} : Lines{note});
    }
}

TEST(ObjReader, TakesAllKindsOfText) {
    const std::string text = kObjSquare + "f 1 2 3 4\n";
    EXPECT_NEAR(ReadObj("\xef\xbb\xbf" + text).area(), 144, 1e-9);
    EXPECT_NEAR(ReadObj(text.substr(0, text.size() - 1) + "\\").area(), 144, 1e-9); // nothing follows
    for (bool big : {false, true})
        for (bool mark : {false, true}) {
            EXPECT_NEAR(ReadObj(utf16(text, mark, big)).area(), 144, 1e-9);
            std::string wide;
            for (char c : (mark ? "m" : "") + text) // m becomes the byte order mark
                for (int k = 0; k < 4; ++k)
                    wide += mark && wide.size() < 4 ? (big ? "\0\0\xfe\xff" : "\xff\xfe\0\0")[k]
                            : k == (big ? 3 : 0)    ? c
                                                    : '\0';
            EXPECT_EQ(ReadObj(wide).error, "m.obj: it is UTF-32: save it as UTF-8");
        }
    EXPECT_EQ(ReadObj(std::string("\xff\xfe\0\xd8v\0", 6)).error, // half of a surrogate pair
              "m.obj: its UTF-16 is damaged: save it as UTF-8");
    // Names beyond ASCII are the same in both files
    std::string obj = utf16("mtllib m.mtl\n" + kObjSquare + "usemtl caf?\nf 1 2 3 4\n", true, false);
    obj[obj.find('?')] = '\xe9';
    ReadObj r(obj, "newmtl caf\xc3\xa9\nKd 0 1 0\n");
    EXPECT_EQ(r.notes, Lines{});
    EXPECT_EQ(r.mesh.materials[0].reflects[1], 1);
    EXPECT_EQ(r.mesh.materials.size(), 1u);
}

// Errors name the line, counted as editors count lines.
TEST(ObjReader, NamesTheLine) {
    const std::string zip("\x1f\x8b\b\0\0", 5),
        neither = ": is neither Wavefront OBJ nor glTF 2.0 (.gltf, .glb), which are read";
    const std::pair<std::string, std::string> cases[] = {
        {"v 0 0 0\r\nv 0 0 \\\r\n 1\r\nf 1 2 9\r\n", ":4: there is no point 9: the file has 2"},
        {"\xef\xbb\xbfv 0 0\n", ":1: a point needs three coordinates"},
        {"# a\\\n\nv 0 0 0,5\n", ":3: a point needs three coordinates: 0,5 is not a number"},
        {"v 0 0 1e400\n", ":1: a coordinate is not a number below 1e18"},
        {"v 0 0 nan\n", ":1: a coordinate is not a number below 1e18"},
        {kObjSquare + "f 1 2/x 3\n", ":5: a polygon's points are numbers, not 2/x"},
        {kObjSquare + "f 1 2 0/1\n", ":5: there is no point 0 before this polygon"},
        {kObjSquare + "f -5 -2 -1\n", ":5: there is no point -5 before this polygon"},
        {zip, neither},
        {"solid a\nfacet normal 0 1 0\nouter loop\nvertex 0 0 0\n", neither}, // STL
        {"ply\nformat ascii 1.0\nelement vertex 3\n0 0 0\n", neither},
        {std::string("ply\nformat binary_little_endian 1.0\nend_header\n\0\0\nv 1\n", 54), neither},
        {"#usda 1.0\ndef Mesh \"m\"\n{\n}\n", neither},
        {std::string("odraz radiosity 5\n\0\nv 1\n", 24), ": is a solution: give the model"},
        {"# by hand\nvn 0 1 0\n", ": holds no point"},
        {"", ": holds no point"},
        {kObjSquare + "l 1 2 3 4\n", ": holds no polygon"},
        {"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", ": holds no polygon with an area"},
    };
    for (const auto &[text, error] : cases) EXPECT_EQ(ReadObj(text).error, "m.obj" + error) << text;
}

TEST(ObjReader, NotesUnknownMaterials) {
    const std::string mtl = "newmtl floor\nKd 1 1 1\nnewmtl lamp\nKe 1 1 1\nnewmtl wall\nKd .5 .5 .5\n";
    EXPECT_EQ(squareOf(mtl, "wall").notes, Lines{});
    EXPECT_EQ(squareOf(mtl, "Lamp").notes,
              Lines{"m.obj: no material file has Lamp: it reflects 0.7; the nearest name is lamp"});
    EXPECT_EQ(squareOf(mtl, "floor_mat").notes,
              Lines{"m.obj: no material file has floor_mat: it reflects 0.7; the nearest name is floor"});
}

TEST(ObjReader, NotesWhatIsNotReadAsWritten) {
    const std::string obj = "MTLLIB m.mtl\nmtllib m.mtl m.mtl\n" + kObjSquare + "usemtl a\nf 1 2 3 4\n";
    ReadObj r(obj, "newmtl a\nKD 1 0 0\nmap_d a.png\nbump b.png\nnewmtl b\nKd 1 1 1\nMAP_BUMP b.png\nnewmtl "
                   "a\nKd 0 0 0\n");
    EXPECT_EQ(r.notes,
              (Lines{"m.obj: MTLLIB is read as mtllib",
                     "m.obj: material a: it is defined twice; the first definition is used",
                     "m.mtl: KD is read as Kd", "m.obj: MAP_BUMP is not used: material b",
                     "m.obj: bump is not used: material a", "m.obj: map_d is not used: material a"}));
    EXPECT_EQ(r.mesh.materials[0].reflects, (Colour{1, 0, 0}));
    EXPECT_EQ(ReadObj("mtllib m.mtl\n" + kObjSquare + "f 1 2 3 4\n", std::string("\x89PNG\0\0", 6)).notes,
              Lines{"m.mtl: is not a text file, and has no materials"});
}

// There is one note for each kind of unused statement. It names the first line or material.
TEST(ObjReader, NotesWhatIsNotUsed) {
    const std::string obj =
        "mtllib m.mtl\nv 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 0 1 1.0\nv 0 0 1 2\nvt nan 0\nvt 1 inf\nvt\nvt "
        ".5\nl 1 2\np 1\nvp 0 1\ncstype bezier\nsurf 0 1 0 1 1 2 3 4\nend\ncall x.obj\nusemap p\nusemtl a\n"
        "f 1/1 2/4 3/4\n";
    ReadObj r(obj,
              "newmtl a\nKd 1 0 0\nd 0.5\nmap_Kd -mm 0 .5 -s 1 1 -clamp on -boost 2 a.png\nbump -bm 1 "
              "b.png\nPr 1\nPm 0.5\nPc 1\nnewmtl b\nd 1\nTr 1\nTr 0.5\nPm 0\nPs 1\nmap_Ke -mm 0 1 a.png\n");
    EXPECT_EQ(
        r.notes,
        (Lines{"m.obj: colours of points are not used: line 2 and 1 more",
               "m.obj: coordinates of pictures (vt) are not numbers: line 6 and 2 more",
               "m.obj: other files (call) are not read: line 16",
               "m.obj: pictures of polygons (usemap) are not used: line 17",
               "m.obj: points and lines are left out: line 10 and 1 more",
               "m.obj: surfaces are left out: line 14", "m.obj: weights of points are not used: line 5",
               "m.obj: bump is not used: material a",
               "m.obj: clearcoat and sheen (Pc, Ps) are not used: material a and 1 more",
               "m.obj: map_Kd's -boost is not used: material a",
               "m.obj: map_Kd's -mm is not used: material a", "m.obj: map_Ke's -mm is not used: material b",
               "m.obj: metal counts as diffuse: material a",
               "m.obj: opacity is not used, so all surfaces are opaque: material a and 1 more",
               "m.obj: coordinates of pictures are missing, so their mean colours are used: a"}));
}

TEST(ObjReader, TakesColours) {
    auto with = [](const std::string &line) { return squareOf("newmtl a\n" + line + "\n"); };
    const std::tuple<std::string, Colour, std::string> cases[] = {
        {"Kd .5 .25 .125 # a wall", {.5f, .25f, .125f}, ""},
        {"Kd 0.5", {.5f, .5f, .5f}, ""},
        {"  Kd 1 0 0  \nKs 1 1 1\nTf 1 1 1\nillum 7\nd -halo 0\nTr 0.5\nNs 9\nNi 1.5\nPr 0.5",
         {1, 0, 0},
         "m.obj: opacity is not used, so all surfaces are opaque: material a"},
        {"Ks 1 1 1", {.7f, .7f, .7f}, "m.obj: material a: it has no Kd: it reflects 0.7"},
        {"Kd spectral a.rfl 1",
         {.7f, .7f, .7f},
         "m.obj: material a: its Kd is a spectrum, which is not read: it reflects 0.7"},
    };
    for (const auto &[line, reflects, note] : cases) {
        ReadObj r = with(line);
        EXPECT_EQ(r.mesh.materials[0].reflects, reflects) << line;
        EXPECT_EQ(r.notes, note.empty() ? Lines{} : Lines{note}) << line;
    }
    EXPECT_EQ(with("Ke 1e12").mesh.materials[0].emits[0], 1e12f);
    EXPECT_EQ(with("Ke 2e12").error, "m.obj: material a: Ke must lie between 0 and 1e12");
    EXPECT_EQ(with("Kd -1").error, "m.obj: material a: Kd must lie between 0 and 1");
    EXPECT_EQ(with("Kd 0,5 0,5 0,5").error, "m.obj: material a: Kd: 0,5 is not a number");
    EXPECT_EQ(with("Kd 2 0 0").mesh.materials[0].reflects[0], 1);
    EXPECT_NEAR(with("Kd xyz 0.4755 0.5 0.5445").mesh.materials[0].reflects[1], 0.5, 0.01);
}

// Finds material files whose names are in another case or have another system's folders, and materials whose
// names have blanks and #.
TEST(ObjReader, FindsMaterials) {
    for (const char *library : {"M.MTL", "C:\\\\my\\\\m.mtl", "none.mtl m.mtl"})
        for (const std::string name : {"a b", "a#1"}) {
            ReadObj r(std::string("mtllib ") + library + "\n" + kObjSquare + "usemtl " + name +
                          "\nf 1 2 3 4\n",
                      "newmtl a\nKd 0 0 0\nnewmtl \t" + name + " \nKd 0 1 0\n");
            const auto &used = r.mesh.materials.at((size_t)r.mesh.triangles.at(0).material);
            EXPECT_EQ(used.reflects[1], 1) << library << " " << name;
            EXPECT_EQ(r.notes.size(), library[0] == 'n' ? 1u : 0u) << library;
        }
    EXPECT_EQ(ReadObj("mtllib none.mtl\nusemtl a\n" + kObjSquare + "f 1 2 3 4\n").notes,
              Lines{"m.obj: its materials cannot be read: cannot read none.mtl: No such file or directory"});
}

// The mesh of a model far away is moved to the origin.
TEST(ObjReader, MovesFarModels) {
    ReadObj far(
        "v 460123 210 5411233\nv 460123 210 5411235.5\nv 460125 210 5411235.5\nv 460125 210 5411233\nf "
        "1 2 3 4\n");
    EXPECT_NEAR(far.area(), 5, 1e-8);
    EXPECT_GT(length(far.mesh.origin), 5e6f);
    for (const Vec3d &p : far.mesh.points) EXPECT_LT(length(p), 4);
    EXPECT_EQ(length(ReadObj(kObjSquare + "f 1 2 3 4\n").mesh.origin), 0);
    // Points that no polygon uses do not count
    ReadObj stray("v 0 0 0\nv 5411233 210 460123\nv 5411233 210 460123.5\nv 5411233.5 210 460123\nf 2 3 4\n");
    EXPECT_NEAR(stray.area(), 0.125, 1e-8);
    EXPECT_LT(stray.mesh.size(), 1);
}

TEST(ObjReader, PutsTheFirstPolygonInFront) {
    const std::string mtl = "newmtl wall\nKd .1 .1 .1\nnewmtl decal\nKd .9 .9 .9\n",
                      points = kObjSquare + "v 3 0 3\nv 3 0 15\nv 6 0 15\nv 6 0 3\n",
                      wall = "usemtl wall\nf 1 2 3 4\n", decal = "usemtl decal\nf 5 6 7 8\n";
    auto areas = [](const Mesh &mesh) {
        std::map<std::string, double> of;
        for (const Triangle &t : mesh.triangles)
            of[mesh.materials[(size_t)t.material].name] += length(normalOf(mesh, t)) / 2;
        return of;
    };
    ReadObj wallFirst("mtllib m.mtl\n" + points + wall + decal, mtl);
    EXPECT_NEAR(areas(wallFirst.mesh)["wall"], 144, 1e-9);
    EXPECT_NEAR(areas(wallFirst.mesh)["decal"], 9, 1e-4); // the part beyond the wall
    EXPECT_EQ(wallFirst.notes,
              Lines{"m.obj: polygons overlap in one plane, and the first is in front: line 13 (decal) behind "
                    "line 11 (wall)"});
    ReadObj decalFirst("mtllib m.mtl\n" + points + decal + wall, mtl);
    EXPECT_NEAR(areas(decalFirst.mesh)["wall"], 144 - 27, 1e-4);
    EXPECT_NEAR(areas(decalFirst.mesh)["decal"], 36, 1e-9);
    // Backs, neighbours and polygons a little in front do not overlap
    EXPECT_EQ(ReadObj(points + "f 1 2 3 4\nf 8 7 6 5\n").notes, Lines{});
    EXPECT_EQ(ReadObj(points + "f 1 2 3\nf 1 3 4\n").notes, Lines{});
    EXPECT_EQ(ReadObj(kObjSquare + "v 3 .001 3\nv 3 .001 9\nv 6 .001 9\nf 1 2 3 4\nf 5 6 7\n").notes,
              Lines{});
}

TEST(ObjReader, DividesLampsByTheirPicture) {
    const std::string obj =
        "mtllib m.mtl\n" + kObjSquare + "vt 0 0\nvt 0 1\nvt 1 1\nvt 1 0\nusemtl a\nf 1/1 2/2 3/3 4/4\n";
    common::TemporaryFolder folder;
    pictures::Image half = {64, 64, std::vector<uint8_t>(64 * 64 * 3)};
    for (size_t i = 0; i < half.rgb.size(); ++i) half.rgb[i] = i / 3 % 64 < 32 ? 0 : 255;
    pictures::writePng(folder / "half.png", half);
    ReadObj r(obj, "newmtl a\nKd 0 0 0\nKe 10 20 0\nmap_Ke " + (folder / "half.png") + "\n");
    const Lines oneSide = {"m.obj: its lamps shine on one side here, in Blender on both (--two-sided)"};
    EXPECT_EQ(r.notes, oneSide);
    double dark = 0, lit = 0, power = 0;
    for (const Triangle &t : r.mesh.triangles) {
        const auto &m = r.mesh.materials[(size_t)t.material];
        double area = length(normalOf(r.mesh, t)) / 2;
        EXPECT_EQ(m.name, "a");
        (m.emits[0] < 0.1f ? dark : lit) += m.emits[0] < 0.1f || m.emits[0] > 9.9f ? area : 0;
        power += area * (double)m.emits[1];
    }
    EXPECT_NEAR(dark, 72, 4);
    EXPECT_NEAR(lit, 72, 4);
    EXPECT_NEAR(power, 20 * 72, 1);
    // Without Ke the picture counts alone. If the picture cannot be read, Ke counts alone (see `none` below)
    ReadObj alone(obj, "newmtl a\nKd 0 0 0\nmap_Ke -clamp on " + (folder / "half.png") + "\n");
    EXPECT_EQ(std::max_element(alone.mesh.materials.begin(), alone.mesh.materials.end(),
                               [](auto &a, auto &b) { return a.emits[0] < b.emits[0]; })
                  ->emits[0],
              1);
    // Light above 1, in a picture of one pixel of 4, 8, 1
    common::writeWhole(folder / "bright.hdr",
                       std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x40\x80\x10\x84"));
    ReadObj bright(obj, "newmtl a\nKd 0 0 0\nKe .5 .5 .5\nmap_Ke " + (folder / "bright.hdr") + "\n");
    EXPECT_EQ(bright.notes, oneSide);
    EXPECT_NEAR(bright.mesh.materials[0].emits[0], 2, 0.03);
    EXPECT_NEAR(bright.mesh.materials[0].emits[1], 4, 0.03);
    ReadObj none(obj, "newmtl a\nKe 5 5 5\nmap_Ke none.png\n");
    EXPECT_EQ(none.mesh.materials[0].emits[0], 5);
    ASSERT_EQ(none.notes.size(), 2u);
    EXPECT_NE(none.notes[0].find("none.png"), std::string::npos);
}
