#include "tools/radiosity/generate/generate.h"

#include "tools/common/command_line.h"
#include "tools/common/whole_file.h"
#include "tools/radiosity/generate/obj_writer.h"
#include "tools/radiosity/read/mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

namespace odraz::radiosity {

namespace {

const std::vector<MeshMaterial> kMaterials = {
    {"white", {0.75f, 0.75f, 0.75f}, {}},
    {"red", {0.65f, 0.1f, 0.08f}, {}},
    {"green", {0.12f, 0.5f, 0.15f}, {}},
    {"stone", {0.5f, 0.48f, 0.42f}, {}},
    {"floor", {0.35f, 0.33f, 0.3f}, {}},
    {"lamp", {0.5f, 0.5f, 0.5f}, {20, 18, 15}},
    {"furnace", {0.5f, 0.5f, 0.5f}, {1, 1, 1}},
    {"shines", {}, {1, 1, 1}},
    {"receives", {1, 1, 1}, {}},
};

struct ModelWriter : ObjWriter {
    // A rectangle that is lit on the side of u x v. If `area` requires it, it is divided into smaller
    // rectangles, whose sides differ by a factor of 2 at most.
    void rect(const char *mtl, Vec3d corner, Vec3d u, Vec3d v) {
        if (area > 0) {
            const double side = std::sqrt(2 * area);
            auto parts = [&](Vec3d along) { return (int)std::ceil(length(along) / side - 1e-9); };
            return surface(mtl, parts(u), parts(v), false,
                           [&](double x, double y) { return corner + u * x + v * y; });
        }
        use(mtl);
        const int a = number(corner), b = number(corner + u), c = number(corner + u + v),
                  d = number(corner + v);
        common::append(faces, "f %d %d %d %d\n", a, b, c, d);
        triangles += 2;
    }
    // A box seen from outside. It has a bottom if `bottom` names a material, and a top if hi.y is below 10.
    void box(const char *mtl, Vec3d lo, Vec3d hi, const char *bottom) {
        double x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
        rect(mtl, {lo[0], lo[1], lo[2]}, {0, 0, z}, {0, y, 0});
        rect(mtl, {hi[0], lo[1], hi[2]}, {0, 0, -z}, {0, y, 0});
        if (hi[1] < 10) rect(mtl, {lo[0], hi[1], hi[2]}, {x, 0, 0}, {0, 0, -z});
        rect(mtl, {hi[0], lo[1], lo[2]}, {-x, 0, 0}, {0, y, 0});
        rect(mtl, {lo[0], lo[1], hi[2]}, {x, 0, 0}, {0, y, 0});
        if (bottom) rect(bottom, {lo[0], lo[1], lo[2]}, {x, 0, 0}, {0, 0, z});
    }
    // A ceiling from lo to hi at height y, with a lamp set into it.
    void ceiling(double y, Vec3d lo, Vec3d hi, Vec3d lampLo, Vec3d lampHi) {
        const double x[4] = {lo[0], lampLo[0], lampHi[0], hi[0]}, z[4] = {lo[2], lampLo[2], lampHi[2], hi[2]};
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i)
                rect(i == 1 && j == 1 ? "lamp" : "white", {x[i], y, z[j]}, {x[i + 1] - x[i], 0, 0},
                     {0, 0, z[j + 1] - z[j]});
    }
    // The walls and the floor of a room, seen from inside.
    void room(Vec3d lo, Vec3d hi, const char *floor, const char *left, const char *right) {
        double x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
        rect(floor, {lo[0], lo[1], lo[2]}, {0, 0, z}, {x, 0, 0});
        rect(left, {lo[0], lo[1], lo[2]}, {0, y, 0}, {0, 0, z});
        rect(right, {hi[0], lo[1], lo[2]}, {0, 0, z}, {0, y, 0});
        rect("white", {lo[0], lo[1], lo[2]}, {x, 0, 0}, {0, y, 0});
        rect("white", {hi[0], lo[1], hi[2]}, {-x, 0, 0}, {0, y, 0});
    }
};

void cube(ModelWriter &w) {
    w.room({-5, 0, -5}, {5, 10, 5}, "floor", "red", "green");
    w.ceiling(10, {-5, 10, -5}, {5, 10, 5}, {-1, 10, -1}, {1, 10, 1});
}

void columns(ModelWriter &w) {
    w.room({-20, 0, -15}, {20, 10, 15}, "floor", "red", "white");
    w.rect("white", {-20, 10, -15}, {40, 0, 0}, {0, 0, 30});
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 3; ++j) {
            double x = -14.0 + 7 * i, z = -8.5 + 8.5 * j;
            w.box("stone", {x - 0.75, 0, z - 0.75}, {x + 0.75, 10, z + 0.75}, nullptr);
        }
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 2; ++j) {
            double x = -10.5 + 7 * i, z = -4.25 + 8.5 * j;
            w.box("white", {x - 0.75, 9, z - 0.75}, {x + 0.75, 9.2, z + 0.75}, "lamp");
        }
}

void corner(ModelWriter &w) {
    // An L of three squares, 4 high, with a lamp at one end
    const double y = 4;
    for (Vec3d p : {Vec3d{0, 0, 0}, Vec3d{8, 0, 0}, Vec3d{8, 0, 8}}) {
        w.rect("floor", p, {0, 0, 8}, {8, 0, 0});
        if (p[0] + p[2] > 0)
            w.rect("white", {p[0], y, p[2]}, {8, 0, 0}, {0, 0, 8});
        else
            w.ceiling(y, p, {8, y, 8}, {2, y, 3}, {4, y, 5});
    }
    w.rect("red", {0, 0, 0}, {0, y, 0}, {0, 0, 8});
    w.rect("white", {0, 0, 0}, {8, 0, 0}, {0, y, 0});
    w.rect("white", {8, 0, 0}, {8, 0, 0}, {0, y, 0});
    w.rect("white", {8, 0, 8}, {-8, 0, 0}, {0, y, 0});
    w.rect("white", {8, 0, 16}, {0, 0, -8}, {0, y, 0});
    w.rect("green", {16, 0, 0}, {0, 0, 8}, {0, y, 0});
    w.rect("green", {16, 0, 8}, {0, 0, 8}, {0, y, 0});
    w.rect("white", {16, 0, 16}, {-8, 0, 0}, {0, y, 0});
}

// A closed cube whose sides all emit and reflect.
void furnace(ModelWriter &w) {
    for (int k = 0; k < 3; ++k) {
        Vec3d u = {}, v = {}, n = {};
        u[(k + 1) % 3] = v[(k + 2) % 3] = n[k] = 1;
        w.rect("furnace", {}, u, v);
        w.rect("furnace", n, v, u);
    }
}

// Two unit squares that face each other at distance 1.
void squares(ModelWriter &w) {
    w.rect("receives", {0, 0, 0}, {0, 0, 1}, {1, 0, 0});
    w.rect("shines", {0, 1, 0}, {1, 0, 0}, {0, 0, 1});
}

// An uneven sphere seen from inside. The triangles near the top are the lamp.
void cave(ModelWriter &w) {
    int rows = w.area > 0 ? std::max(4, (int)std::sqrt(1257 / w.area / 4)) : 20, columns = 2 * rows;
    auto at = [&](int i, int j) {
        double a = 2 * M_PI * (i % columns) / columns, b = M_PI * j / rows;
        double r =
            10 + 0.8 * std::sin(5 * a) * std::sin(3 * b) + 0.4 * std::sin(11 * b + 3 * a) * std::sin(b);
        return w.number(
            {r * std::sin(b) * std::cos(a), 0.7 * r * std::cos(b), r * std::sin(b) * std::sin(a)});
    };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const char *mtl = j < std::max(1, rows / 16) ? "lamp" : j < rows / 2 ? "white" : "stone";
            int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            if (j > 0) w.triangle(mtl, a, c, b);
            if (j + 1 < rows) w.triangle(mtl, a, d, c);
        }
}

} // namespace

std::string generateObj(const std::string &kind, double area, size_t *triangles) {
    static const std::map<std::string, std::function<void(ModelWriter &)>> kinds = {
        {"cube", cube},       {"columns", columns},     {"corner", corner},   {"cave", cave},
        {"vault", makeVault}, {"terrain", makeTerrain}, {"furnace", furnace}, {"squares", squares}};
    auto make = kinds.find(kind);
    if (make == kinds.end()) return {};
    ModelWriter w;
    w.area = area;
    make->second(w);
    if (triangles) *triangles = w.triangles;
    return w.points + w.faces;
}

std::string generateMtl(const std::vector<MaterialChange> &changes) {
    std::vector<MeshMaterial> materials = kMaterials;
    changeMaterials(materials, std::vector<bool>(materials.size(), true), changes);
    std::string text;
    for (const MeshMaterial &m : materials) {
        text += "newmtl " + m.name + "\n";
        for (auto [name, c] : {std::pair{"Kd", m.reflects}, {"Ke", m.emits}})
            common::append(text, "%s %.7g %.7g %.7g\n", name, (double)c[0], (double)c[1], (double)c[2]);
    }
    return text;
}

int runGenerate(common::CommandLine &line) {
    std::string kind, out;
    double area = 0;
    std::vector<MaterialChange> changes;
    line.about("Writes an example model, and its materials to a file next to it.");
    line.argument("KIND", kind,
                  "cube, columns, corner, cave, vault or terrain; furnace or squares, whose light is known",
                  false);
    line.option("-o", "MODEL.obj", out, "the model's file");
    line.option("--area", "A", area, {1e-4, 1e6},
                "divide polygons into triangles of at most this area; by default they stay whole");
    addMaterialChanges(line, changes);
    line.parse();
    size_t triangles = 0;
    std::string model = generateObj(kind, area, &triangles);
    if (model.empty())
        throw common::Refused(
            "name a model: cube, columns, corner, cave, vault, terrain, furnace or squares");
    if (out.size() < 5 || out.compare(out.size() - 4, 4, ".obj"))
        throw common::Refused("name a file with -o MODEL.obj");
    std::string mtl = out.substr(0, out.size() - 4) + ".mtl", name = mtl.substr(mtl.rfind('/') + 1);
    for (const std::string &path : {out, mtl}) common::claimOutput(path);
    common::writeWhole(mtl, generateMtl(changes));
    common::writeWhole(out, kGeneratedObj + ("\nmtllib " + name + "\n") + model);
    bool fine = area > 0 || kind == "vault" || kind == "terrain";
    std::printf(
        "%s: %s\n", out.c_str(),
        (fine ? common::counted(triangles, "triangle") : common::counted(triangles / 2, "polygon")).c_str());
    return 0;
}

} // namespace odraz::radiosity
