#include "tools/radiosity/generate/obj_writer.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace odraz::radiosity {

namespace {

constexpr double kTurn = 2 * M_PI;

struct Curved {
    ObjWriter &w;
    double detail; // multiplies the numbers of steps along a side
    uint32_t state = 1;

    Curved(ObjWriter &w, double area) : w(w), detail(w.area > 0 ? std::sqrt(area / w.area) : 1) {}

    int steps(int n) const { return std::max(3, (int)std::lround(n * detail)); }
    double random(double low, double high) {
        state = state * 1664525 + 1013904223;
        return low + (high - low) * (state >> 8) / 16777216.;
    }
    // A surface of revolution about an upright axis, seen from outside. `profile` returns (radius, height) as
    // a function of v, bottom first.
    void lathe(const char *mtl, Vec3d foot, int around, int along,
               const std::function<std::pair<double, double>(double)> &profile) {
        w.surface(mtl, steps(around), steps(along), true, [&](double u, double v) {
            auto [r, y] = profile(v);
            return foot + Vec3d{r * std::cos(-u * kTurn), y, r * std::sin(-u * kTurn)};
        });
    }
    void ball(const char *mtl, Vec3d centre, double radius, int around) {
        lathe(mtl, centre, around, around / 2, [=](double v) {
            return std::pair{radius * std::sin(v * M_PI), -radius * std::cos(v * M_PI)};
        });
    }
    // A ring that lies flat.
    void ring(const char *mtl, Vec3d centre, double radius, double thickness, int around) {
        w.surface(mtl, steps(around), steps(around / 2), true, [&](double u, double v) {
            double r = radius + thickness * std::cos(v * kTurn);
            return centre +
                   Vec3d{r * std::cos(-u * kTurn), thickness * std::sin(v * kTurn), r * std::sin(-u * kTurn)};
        });
    }
    void vase(const char *mtl, Vec3d foot, double height, int around) {
        lathe(mtl, foot, around, around, [=](double v) {
            return std::pair{height * (0.18 + 0.2 * std::sin(v * 5) * (1 - v * 0.4)) * std::min(1., 12 * v),
                             height * v};
        });
    }
    // A cloth that hangs in a plane of constant z, two centimetres thick.
    void cloth(const char *mtl, Vec3d top, double width, double height) {
        for (int side = 0; side < 2; ++side)
            w.surface(mtl, steps(16), steps(14), false, [&](double u, double v) {
                double x = side ? 1 - u : u;
                return top + Vec3d{width * (x - 0.5), -height * (1 - v),
                                   0.25 * std::sin(x * 25) * (1 - v * 0.7) + (side ? -0.01 : 0.01)};
            });
    }
    // A wall in the plane of this x, from z0 to z1 and from 0 to `height`, with a round-headed window, whose
    // jambs have this depth. It is seen from larger x if `inside` is 1, from smaller x if it is -1.
    void wallWithWindow(const char *mtl, double x, double z0, double z1, double height, double inside,
                        double depth) {
        double zm = (z0 + z1) / 2, r = (z1 - z0) * 0.22, low = height * 0.35, spring = height * 0.62;
        // Divide the wall along straight lines from the window's outline to the wall's border
        auto outline = [&](double u) {
            double a = u * kTurn, c = std::cos(a), s = std::sin(a), half = (spring - low) / 2, y;
            y = (spring + low) / 2 + (s >= 0 ? half + r * s : -half);
            double z = s >= 0 ? r * c : r * std::clamp(c * 1.42, -1., 1.);
            if (s < 0) y = (spring + low) / 2 + half * std::max(-1., 1 + 2 * std::max(s * 1.42, -1.) * 1.);
            return std::pair{z, y};
        };
        auto border = [&](double u) {
            double a = u * kTurn, c = std::cos(a), s = std::sin(a), m = std::max(std::fabs(c), std::fabs(s));
            return std::pair{(z1 - z0) / 2 * c / m, height / 2 + height / 2 * s / m};
        };
        int around = steps(24) / 4 * 4;
        w.surface(mtl, around, steps(3), true, [&](double u, double v) {
            auto [za, ya] = outline(-u * inside);
            auto [zb, yb] = border(-u * inside);
            return Vec3d{x, ya + (yb - ya) * v, zm - (za + (zb - za) * v)};
        });
        w.surface(mtl, around, steps(2), true, [&](double u, double v) {
            auto [z, y] = outline(-u * inside);
            return Vec3d{x - inside * depth * (1 - v), y, zm - z};
        });
    }
};

} // namespace

void makeVault(ObjWriter &w) {
    Curved c(w, 0.06);
    const double half = 6, height = 6, depth = 15; // half the width, height of the walls, half the length
    c.w.surface("floor", c.steps(12), c.steps(30), false, [&](double u, double v) {
        return Vec3d{-half + 2 * half * u, 0, depth - 2 * depth * v};
    });
    c.w.surface("white", c.steps(32), c.steps(44), false, [&](double u, double v) {
        double a = M_PI * u;
        return Vec3d{-half * std::cos(a), height + 0.7 * half * std::sin(a) + 0.08 * std::cos(v * kTurn * 11),
                     -depth + 2 * depth * v};
    });
    for (int i = 0; i < 6; ++i)
        for (int side = -1; side <= 1; side += 2)
            c.wallWithWindow(i % 2 ? "red" : "stone", side * half, -depth + 5 * i, -depth + 5 * i + 5, height,
                             -side, 0.5);
    for (int end = -1; end <= 1; end += 2) {
        c.w.surface("stone", c.steps(24), c.steps(10), false, [&](double u, double v) {
            double x = (2 * u - 1) * half * -end,
                   top = height + 0.7 * half * std::sqrt(std::max(0., 1 - x * x / (half * half))) + 0.08;
            return Vec3d{x, top * v, end * depth};
        });
    }
    for (int i = 0; i < 5; ++i)
        for (int side = -1; side <= 1; side += 2)
            c.lathe("stone", {side * 3.6, 0, -10. + 5 * i}, 20, 16, [&](double v) {
                double bulge = 0.32 + 0.05 * std::sin(v * M_PI), base = v < 0.08 || v > 0.92 ? 0.14 : 0;
                return std::pair{bulge + base, v * 6.2};
            });
    for (int i = 0; i < 5; ++i)
        c.cloth(i % 2 ? "green" : "red", {i % 2 ? 1.8 : -1.8, 5.6, -11. + 5.2 * i}, 2.4, 3);
    for (int i = 0; i < 22; ++i) {
        Vec3d at = {c.random(-5, 5), 0, c.random(-13, 13)};
        const char *mtl = i % 3 == 0 ? "red" : i % 3 == 1 ? "white" : "green";
        if (i % 3 == 0)
            c.vase(mtl, at, c.random(0.7, 1.4), 16);
        else if (i % 3 == 1) {
            double r = c.random(0.25, 0.6);
            c.ball(mtl, at + Vec3d{0, r, 0}, r, 18);
        } else {
            double thickness = c.random(0.08, 0.16);
            c.ring(mtl, at + Vec3d{0, thickness, 0}, c.random(0.4, 0.7), thickness, 20);
        }
    }
}

void makeTerrain(ObjWriter &w) {
    Curved c(w, 0.02);
    auto hills = [](double x, double z) {
        return 0.5 * std::sin(1.1 * x + 0.4) * std::cos(0.9 * z) +
               0.22 * std::sin(2.9 * x - z) * std::sin(2.3 * z + x) +
               0.07 * std::sin(7 * x + 2 * z) * std::sin(6.1 * z - 2.2 * x);
    };
    const double half = 5, low = -1, high = 5;
    c.w.surface("floor", c.steps(100), c.steps(100), false, [&](double u, double v) {
        double x = -half + 2 * half * u, z = half - 2 * half * v;
        return Vec3d{x, hills(x, z), z};
    });
    // Begin the walls below the hills
    auto wall = [&](const char *mtl, Vec3d corner, Vec3d u, Vec3d v) {
        w.surface(mtl, 1, 1, false, [&](double x, double y) { return corner + u * x + v * y; });
    };
    double y = high - low, s = 2 * half;
    wall("red", {-half, low, -half}, {0, y, 0}, {0, 0, s});
    wall("green", {half, low, -half}, {0, 0, s}, {0, y, 0});
    wall("white", {-half, low, -half}, {s, 0, 0}, {0, y, 0});
    wall("white", {half, low, half}, {-s, 0, 0}, {0, y, 0});
    wall("white", {-half, high, -half}, {s, 0, 0}, {0, 0, s});
    wall("lamp", {-0.6, high - 0.05, -0.6}, {1.2, 0, 0}, {0, 0, 1.2});
    for (int i = 0; i < 14; ++i) {
        double x = c.random(-4, 4), z = c.random(-4, 4), r = c.random(0.2, 0.5);
        c.ball(i % 2 ? "stone" : "white", {x, hills(x, z) + 0.6 * r, z}, r, 24);
    }
}

} // namespace odraz::radiosity
