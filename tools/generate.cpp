#include "generate.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace {

using Point = std::array<double, 3>;

struct Material {
    const char *name;
    double kd[3], ke[3];
};
constexpr Material kMaterials[] = {
    {"white", {0.75, 0.75, 0.75}, {}}, {"red", {0.65, 0.1, 0.08}, {}},
    {"green", {0.12, 0.5, 0.15}, {}},  {"stone", {0.5, 0.48, 0.42}, {}},
    {"floor", {0.35, 0.33, 0.3}, {}},  {"lamp", {0.5, 0.5, 0.5}, {20, 18, 15}},
};

struct Writer {
    double area;
    size_t triangles = 0;
    std::string points, faces;
    std::map<Point, int> numbers;
    const char *material = "";

    int number(const Point &p) {
        auto [entry, added] = numbers.try_emplace(p, (int)numbers.size() + 1);
        if (added) {
            char line[100];
            std::snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", p[0], p[1], p[2]);
            points += line;
        }
        return entry->second;
    }
    // Lit on the side of u x v. In as many steps along its sides as the area asks for, never one side more
    // than twice another.
    void rect(const char *of, Point corner, Point u, Point v) {
        if (of != material) faces += "usemtl " + std::string(of) + "\n";
        material = of;
        auto length = [](const Point &a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); };
        int across = 1, down = 1;
        if (area > 0) {
            double side = std::sqrt(2 * area);
            across = (int)std::ceil(length(u) / side - 1e-9), down = (int)std::ceil(length(v) / side - 1e-9);
        }
        auto at = [&](int i, int j) {
            Point p;
            for (size_t k = 0; k < 3; ++k) p[k] = corner[k] + u[k] * i / across + v[k] * j / down;
            for (double &x : p) x = std::round(x * 1e6) / 1e6 + 0.0;
            return number(p);
        };
        char line[200];
        for (int j = 0; j < down; ++j)
            for (int i = 0; i < across; ++i) {
                int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
                if (area > 0)
                    std::snprintf(line, sizeof line, "f %d %d %d\nf %d %d %d\n", a, b, c, a, c, d);
                else
                    std::snprintf(line, sizeof line, "f %d %d %d %d\n", a, b, c, d);
                faces += line;
                triangles += 2;
            }
    }
    // Closed and seen from outside; the bottom may be of another material.
    void box(const char *of, Point lo, Point hi, const char *bottom) {
        double x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
        rect(of, {lo[0], lo[1], lo[2]}, {0, 0, z}, {0, y, 0});
        rect(of, {hi[0], lo[1], hi[2]}, {0, 0, -z}, {0, y, 0});
        rect(of, {lo[0], hi[1], hi[2]}, {x, 0, 0}, {0, 0, -z});
        rect(of, {hi[0], lo[1], lo[2]}, {-x, 0, 0}, {0, y, 0});
        rect(of, {lo[0], lo[1], hi[2]}, {x, 0, 0}, {0, y, 0});
        rect(bottom, {lo[0], lo[1], lo[2]}, {x, 0, 0}, {0, 0, z});
    }
    // Closed and seen from inside.
    void room(Point lo, Point hi, const char *floor, const char *left, const char *right) {
        double x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
        rect(floor, {lo[0], lo[1], lo[2]}, {0, 0, z}, {x, 0, 0});
        rect("white", {lo[0], hi[1], lo[2]}, {x, 0, 0}, {0, 0, z});
        rect(left, {lo[0], lo[1], lo[2]}, {0, y, 0}, {0, 0, z});
        rect(right, {hi[0], lo[1], lo[2]}, {0, 0, z}, {0, y, 0});
        rect("white", {lo[0], lo[1], lo[2]}, {x, 0, 0}, {0, y, 0});
        rect("white", {hi[0], lo[1], hi[2]}, {-x, 0, 0}, {0, y, 0});
    }
};

void cube(Writer &w) {
    w.room({-5, 0, -5}, {5, 10, 5}, "floor", "red", "green");
    w.box("white", {-1, 9.8, -1}, {1, 9.9, 1}, "lamp");
}

void columns(Writer &w) {
    w.room({-20, 0, -15}, {20, 10, 15}, "floor", "red", "white");
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 3; ++j) {
            double x = -14.0 + 7 * i, z = -8.5 + 8.5 * j;
            // Through floor and ceiling, so that it is closed
            w.box("stone", {x - 0.6, -0.1, z - 0.6}, {x + 0.6, 10.1, z + 0.6}, "stone");
            w.box("stone", {x - 0.9, -0.1, z - 0.9}, {x + 0.9, 0.5, z + 0.9}, "stone");
        }
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 2; ++j) {
            double x = -10.5 + 7 * i, z = -4.25 + 8.5 * j;
            w.box("white", {x - 0.75, 9, z - 0.75}, {x + 0.75, 9.2, z + 0.75}, "lamp");
        }
}

void corner(Writer &w) {
    // An L of three squares, 4 high: the lamp lights one end
    const double y = 4;
    for (Point p : {Point{0, 0, 0}, Point{8, 0, 0}, Point{8, 0, 8}}) {
        w.rect("floor", p, {0, 0, 8}, {8, 0, 0});
        w.rect("white", {p[0], y, p[2]}, {8, 0, 0}, {0, 0, 8});
    }
    w.rect("red", {0, 0, 0}, {0, y, 0}, {0, 0, 8});
    w.rect("white", {0, 0, 0}, {8, 0, 0}, {0, y, 0});
    w.rect("white", {8, 0, 0}, {8, 0, 0}, {0, y, 0});
    w.rect("white", {8, 0, 8}, {-8, 0, 0}, {0, y, 0});
    w.rect("white", {8, 0, 16}, {0, 0, -8}, {0, y, 0});
    w.rect("green", {16, 0, 0}, {0, 0, 8}, {0, y, 0});
    w.rect("green", {16, 0, 8}, {0, 0, 8}, {0, y, 0});
    w.rect("white", {16, 0, 16}, {-8, 0, 0}, {0, y, 0});
    w.box("white", {2, 3.6, 3}, {4, 3.7, 5}, "lamp");
}

} // namespace

std::string generateObj(const std::string &kind, double area, size_t *triangles) {
    Writer w = {area, 0, {}, {}, {}, ""};
    if (kind == "cube")
        cube(w);
    else if (kind == "columns")
        columns(w);
    else if (kind == "corner")
        corner(w);
    else
        return {};
    if (triangles) *triangles = w.triangles;
    return w.points + w.faces;
}

std::string generateMtl() {
    std::string text;
    for (const Material &m : kMaterials) {
        char lines[300];
        std::snprintf(lines, sizeof lines, "newmtl %s\nKd %g %g %g\nKe %g %g %g\n", m.name, m.kd[0], m.kd[1],
                      m.kd[2], m.ke[0], m.ke[1], m.ke[2]);
        text += lines;
    }
    return text;
}
