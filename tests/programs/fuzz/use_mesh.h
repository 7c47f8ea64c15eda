// Reads a model, checks it and divides it, for fuzzers of its readers.
#pragma once

#include "tools/radiosity/divide/regions.h"
#include "tools/radiosity/rays/lamp_rays.h"
#include "tools/radiosity/read/reflectance_picture.h"

#include <cmath>
#include <cstdlib>
#include <memory>

namespace odraz::radiosity {

// Aborts unless points are finite, indices are valid, and reflectance, emission and lights are in range.
inline void mustBeSound(const Mesh &mesh) {
    bool good = !mesh.triangles.empty();
    for (const Vec3d &p : mesh.points)
        for (size_t k = 0; k < 3; ++k) good &= std::isfinite(p[k]);
    for (const MeshMaterial &m : mesh.materials)
        for (size_t k = 0; k < 3; ++k)
            good &= m.reflects[k] >= 0 && m.reflects[k] <= 1 && m.emits[k] >= 0 && std::isfinite(m.emits[k]);
    good &= mesh.coordinates.empty() || mesh.coordinates.size() == mesh.triangles.size();
    for (const Triangle &t : mesh.triangles) {
        good &= t.material >= 0 && (size_t)t.material < mesh.materials.size();
        for (int corner : t.corners) good &= corner >= 0 && (size_t)corner < mesh.points.size();
    }
    for (const BallLamp &lamp : mesh.lights.lamps)
        good &= lamp.radius > 0 && lamp.radiance.x >= 0 && std::isfinite(lamp.centre.x);
    for (const Sun &sun : mesh.lights.suns)
        good &= std::fabs(length(sun.towards) - 1) < 1e-3f && sun.light.x >= 0;
    if (!good) std::abort();
}

// Divides a mesh into charts, as `solve` does, and samples a picture at its texture coordinates. `clamp`: the
// picture is clamped, not repeated.
inline void useMesh(const Mesh &mesh, bool clamp) {
    static auto model = std::make_unique<Model>();
    mustBeSound(mesh);
    model->chartCount = model->facetCount = 0;
    Regions regions = joinRegions(mesh, mesh.size() / 10);
    fillModel(*model, regions);
    LampRays(mesh, regions, 16);
    static const ReflectancePicture picture({3, 2, 3, 8, std::vector<uint16_t>(18, 25700), {}});
    for (const auto &at : mesh.coordinates) {
        std::vector<TexturePoint> corners;
        for (size_t k = 0; k < 6; k += 2) corners.push_back({(double)at[k], (double)at[k + 1]});
        float r = picture.mean(corners, clamp).x;
        if (std::fabs(r - picture.mean().x) > 1e-3f) std::abort();
    }
    for (int chart : regions.chartOf)
        if (chart < -1 || chart >= model->chartCount) std::abort();
}

// Reads a file of `size` bytes, and uses its mesh if it is not refused. Returns 0.
inline int useModel(const char *path, size_t size) {
    try {
        std::vector<std::string> notes;
        useMesh(readModel(path, {1, size % 2 == 1, {}}, notes), size % 3 == 1);
    } catch (const common::Refused &) {
    }
    return 0;
}

} // namespace odraz::radiosity
