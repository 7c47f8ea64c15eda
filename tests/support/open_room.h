// Rooms of rectangles for tests of transfer.
#pragma once

#include "tests/support/dice.h"
#include "tools/radiosity/transfer/check.h"

namespace odraz::radiosity {

struct Quad {
    Vec3d corner, u, v;
    int material;
};

// Returns a mesh of rectangles, whose fronts are on the side of u x v.
inline Mesh meshOf(const std::vector<Quad> &quads, const std::vector<MeshMaterial> &materials) {
    Mesh mesh;
    mesh.materials = materials;
    auto point = [&](const Vec3d &p) {
        for (size_t i = 0; i < mesh.points.size(); ++i)
            if (length(mesh.points[i] - p) < 1e-9) return (int)i;
        mesh.points.push_back(p);
        return (int)mesh.points.size() - 1;
    };
    for (const Quad &q : quads) {
        int a = point(q.corner), b = point(q.corner + q.u), c = point(q.corner + q.u + q.v),
            d = point(q.corner + q.v);
        mesh.triangles.push_back({{a, b, c}, q.material});
        mesh.triangles.push_back({{a, c, d}, q.material});
    }
    return mesh;
}

// A room of 4 x 3 x 4 without its wall at +z: floor, ceiling, back, left and right, and a lamp below the
// ceiling.
inline Mesh openRoom() {
    std::vector<MeshMaterial> materials = {{"grey", {0.7f, 0.7f, 0.7f}, {}},
                                           {"red", {0.8f, 0.2f, 0.1f}, {}},
                                           {"blue", {0.1f, 0.3f, 0.8f}, {}},
                                           {"lamp", {}, {9, 8, 6}}};
    return meshOf({{{-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 0},
                   {{-2, 3, -2}, {4, 0, 0}, {0, 0, 4}, 0},
                   {{-2, 0, -2}, {4, 0, 0}, {0, 3, 0}, 0},
                   {{-2, 0, 2}, {0, 0, -4}, {0, 3, 0}, 1},
                   {{2, 0, -2}, {0, 0, 4}, {0, 3, 0}, 2},
                   {{-0.5, 2.9, -0.5}, {1, 0, 0}, {0, 0, 1}, 3}},
                  materials);
}

inline TransferSettings settingsOf(int bands, int rays, double element) {
    TransferSettings s;
    s.bands = bands;
    s.solve.rays = rays;
    s.solve.element = element;
    s.solve.residual = 1e-6f;
    return s;
}

inline TransferRoom transferOf(const Mesh &mesh, const TransferSettings &settings) {
    TransferReport report;
    Workers workers = serialWorkers();
    return findTransfer(mesh, settings, workers, nullptr, report);
}

inline std::vector<Rgb> lightOf(const TransferRoom &room, const BandLight &sky, float lamps = 0) {
    std::vector<Rgb> light;
    Relighter(room).relight(
        {.sky = sky, .lamps = std::vector<float>(room.lamps.size(), lamps), .bands = kMostBands, .rank = -1},
        light);
    return light;
}

inline BandLight randomLight(int bands, Dice &dice) {
    BandLight light = {};
    std::generate_n(light.begin(), bands * bands, [&] { return dice.point(1); });
    return light;
}

inline double legendre(int l, double x) { return std::legendre((unsigned)l, x); }

// Returns the windowed lobe of all bands at an angle from its axis, given by its cosine.
inline double lobeAt(double cosine, float exponent) {
    double sum = 0;
    for (int l = 0; l < kBands; ++l)
        sum += (2 * l + 1) / (4 * M_PI) * (double)window(l, exponent) * legendre(l, cosine);
    return sum;
}

} // namespace odraz::radiosity
