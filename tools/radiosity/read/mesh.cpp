#include "tools/radiosity/read/mesh.h"

#include "tools/common/whole_file.h"
#include "tools/picture/picture_file.h"
#include "tools/radiosity/read/gltf_file.h"
#include "tools/radiosity/read/mesh_builder.h"

#include <algorithm>
#include <filesystem>
#include <strings.h>

namespace odraz::radiosity {

pictures::Picture MeshPicture::read() const {
    pictures::Picture p = bytes ? pictures::readPicture(path, *bytes) : pictures::readPicture(path);
    p.needUsual(path);
    return p;
}

std::array<Vec3d, 3> cornersOf(const Mesh &m, const Triangle &t) {
    auto corner = [&](size_t k) { return m.points[(size_t)t.corners[k]]; };
    return {corner(0), corner(1), corner(2)};
}

Vec3d normalOf(const Mesh &m, const Triangle &t) {
    auto [a, b, c] = cornersOf(m, t);
    return cross(b - a, c - a);
}

bool emitsLight(const Mesh &m) {
    return std::any_of(m.triangles.begin(), m.triangles.end(),
                       [&](const Triangle &t) { return m.materials[(size_t)t.material].shines(); });
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

// --- The formats of models ---

static constexpr size_t kStart = 4096;

// Whether the name of a file has this ending, in any case.
static bool isNamed(const std::string &path, const char *ending) {
    return !strcasecmp(std::filesystem::path(path).extension().c_str(), ending);
}

bool isModel(const std::string &path) {
    for (const char *ending : {".obj", ".gltf", ".glb"})
        if (isNamed(path, ending)) return true;
    try {
        return isGltf(common::readStart(path, kStart));
    } catch (const common::Refused &) { // the reader will report the error
        return false;
    }
}

bool claimOutput(const std::string &path) {
    std::error_code none;
    const std::string target = std::filesystem::canonical(path, none); // empty: no file
    common::need(!std::filesystem::is_regular_file(target, none) || !isModel(target) ||
                     common::readStart(target, kStart).starts_with(kExportedObj),
                 path + " is a model and would be overwritten: give another name");
    return common::claimOutput(path);
}

// The content selects the format. If it is neither's, the name does, so that the right reader reports the
// damage.
Mesh readModel(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes) {
    const std::string start = common::readStart(path, kStart);
    common::need(!start.starts_with(kSolutionStart), path + ": is a solution: give the model");
    const bool gltf = isGltf(start) || (!isObj(start) && (isNamed(path, ".gltf") || isNamed(path, ".glb")));
    return (gltf ? readGltf : readObj)(path, settings, notes);
}

} // namespace odraz::radiosity
