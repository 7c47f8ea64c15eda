#include "tools/radiosity/read/mesh.h"

#include "tools/common/whole_file.h"
#include "tools/picture/picture_file.h"
#include "tools/radiosity/read/gltf_file.h"
#include "tools/radiosity/read/mesh_builder.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace odraz::radiosity {

pictures::Picture MeshPicture::read() const {
    pictures::Picture p = bytes ? pictures::readPicture(path, *bytes) : pictures::readPicture(path);
    p.needUsual(path);
    return p;
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

// --- The formats of models that can be read: a row each ---

namespace {

struct Format {
    std::vector<const char *> endings; // ends of file names, in lower case
    bool (*begins)(std::string_view start);
    bool sure; // no other format begins like this
    decltype(&readModel) read;
};

const Format kFormats[] = {{{".gltf", ".glb"}, isGltf, true, readGltf}, {{".obj"}, isObj, false, readObj}};

constexpr size_t kStart = 4096;

bool isNamed(const Format &format, std::string path) {
    std::transform(path.begin(), path.end(), path.begin(), [](unsigned char c) { return std::tolower(c); });
    return std::any_of(format.endings.begin(), format.endings.end(),
                       [&](const char *ending) { return path.ends_with(ending); });
}

// The format by content; if no format matches, by name, so that the right reader reports the damage.
const Format &formatOf(const std::string &path) {
    const std::string start = common::readStart(path, kStart);
    common::need(!start.starts_with(kSolutionStart), path + ": is a solution: give the model");
    for (const Format &format : kFormats)
        if (format.begins(start)) return format;
    for (const Format &format : kFormats)
        if (isNamed(format, path)) return format;
    return std::end(kFormats)[-1];
}

} // namespace

bool isModel(const std::string &path) {
    std::string start;
    try {
        start = common::readStart(path, kStart);
    } catch (const common::Refused &) { // the reader will report the error
    }
    return std::any_of(std::begin(kFormats), std::end(kFormats), [&](const Format &format) {
        return isNamed(format, path) || (format.sure && format.begins(start));
    });
}

bool claimOutput(const std::string &path) {
    std::error_code none;
    const std::string target = std::filesystem::canonical(path, none); // empty: no file
    common::need(!std::filesystem::is_regular_file(target, none) || !isModel(target) ||
                     common::readStart(target, kStart).starts_with(kExportedObj),
                 path + " is a model and would be overwritten: give another name");
    return common::claimOutput(path);
}

Mesh readModel(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes) {
    return formatOf(path).read(path, settings, notes);
}

} // namespace odraz::radiosity
