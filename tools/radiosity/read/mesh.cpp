#include "tools/radiosity/read/mesh.h"

#include "tools/picture/picture_file.h"

#include <algorithm>

namespace odraz::radiosity {

pictures::Picture MeshPicture::read() const {
    return bytes ? pictures::readPicture(path, *bytes) : pictures::readPicture(path);
}

Vec3d normalOf(const Mesh &m, const Triangle &t) {
    Vec3d a = m.points[(size_t)t.corners[0]];
    return cross(m.points[(size_t)t.corners[1]] - a, m.points[(size_t)t.corners[2]] - a);
}

bool emitsLight(const Mesh &m) {
    return std::any_of(m.triangles.begin(), m.triangles.end(), [&](const Triangle &t) {
        const auto &e = m.materials[(size_t)t.material].emits;
        return e[0] + e[1] + e[2] > 0;
    });
}

double areaOf(const Mesh &m) {
    double area = 0;
    for (const Triangle &t : m.triangles) area += length(normalOf(m, t)) / 2;
    return area;
}

std::pair<Vec3d, Vec3d> boxOf(const std::vector<Vec3d> &points) {
    Vec3d lo = points.at(0), hi = lo;
    for (const Vec3d &p : points)
        for (size_t k = 0; k < 3; ++k) lo[k] = std::min(lo[k], p[k]), hi[k] = std::max(hi[k], p[k]);
    return {lo, hi};
}

double Mesh::size() const {
    auto [lo, hi] = boxOf(points);
    return length(hi - lo);
}

Vec3d Mesh::middle() const {
    auto [lo, hi] = boxOf(points);
    return (lo + hi) / 2;
}

} // namespace odraz::radiosity
