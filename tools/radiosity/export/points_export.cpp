#include "tools/radiosity/export/points_export.h"

#include "tools/common/statistics.h"
#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/picture/psnr.h"
#include "tools/radiosity/read/mesh.h"

#include <algorithm>
#include <cstring>

namespace odraz::radiosity {

namespace {

// Converts radiosity to sRGB, 0 .. 1. The 99th percentile of the points becomes 0.9 in linear light.
struct ColourScale {
    float scale = 1;
    explicit ColourScale(const Solution &solution) {
        std::vector<float> all;
        solution.forPieces([&](int chart, int, const std::vector<SolutionPoint> &piece) {
            if (maxComponent(solution.emits[(size_t)chart]) > 0) return;
            for (const SolutionPoint &p : piece) all.push_back(maxComponent(p.radiosity));
        });
        if (all.empty()) return;
        float high = common::quantile(std::move(all), 0.99);
        if (high > 1e-30f) scale = 0.9f / high; // the inverse of a smaller value may be infinite
    }
    float operator()(float x) const { return pictures::srgbOfLinear(x * scale); }
};

// The pieces of elements as faces, and their corners with radiosity.
struct LitCorners {
    std::vector<SolutionPoint> points;
    std::vector<std::vector<size_t>> faces;
    explicit LitCorners(const Solution &solution) {
        solution.forPieces([&](int, int, const std::vector<SolutionPoint> &piece) {
            std::vector<size_t> face;
            for (const SolutionPoint &p : piece) {
                face.push_back(points.size());
                points.push_back(p);
            }
            faces.push_back(face);
        });
        weld();
    }
    // Merges points of equal position and radiosity.
    void weld() {
        std::vector<size_t> order(points.size()), to(points.size());
        for (size_t i = 0; i < order.size(); ++i) order[i] = i;
        auto less = [&](size_t a, size_t b) {
            return std::memcmp(&points[a], &points[b], sizeof(SolutionPoint)) < 0;
        };
        std::sort(order.begin(), order.end(), less);
        std::vector<SolutionPoint> kept;
        for (size_t i = 0; i < order.size(); ++i) {
            if (i == 0 || less(order[i - 1], order[i])) kept.push_back(points[order[i]]);
            to[order[i]] = kept.size() - 1;
        }
        for (auto &face : faces)
            for (size_t &corner : face) corner = to[corner];
        points = kept;
    }
};

// A point in model coordinates.
std::string pointText(const Solution &solution, const Vec3 &point) {
    const int digits = solution.digits();
    Vec3d p = solution.inModel(point);
    return common::format("%.*g %.*g %.*g", digits, p.x, digits, p.y, digits, p.z);
}

} // namespace

std::string csvField(const std::string &text) {
    if (text.find_first_of(",\"\n\r") == text.npos) return text;
    std::string quoted = "\"";
    for (char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + '"';
}

void exportCsv(const Solution &solution, const std::string &path) {
    std::string text = "polygon,x,y,z,nx,ny,nz,area,r,g,b,material\n";
    const int digits = solution.digits();
    int chart = -1, cell = -1; // the pieces of an element are consecutive
    PieceSum sum;
    auto put = [&] {
        if (!(sum.area > 0)) return;
        Vec3 n = solution.charts[(size_t)chart].n;
        Vec3d p = toDouble(solution.origin) + sum.p / sum.area, mean = sum.radiosity / sum.area;
        common::append(text, "%d,%.*g,%.*g,%.*g,%.6g,%.6g,%.6g,%.7g,%.7g,%.7g,%.7g,%s\n", chart, digits, p.x,
                       digits, p.y, digits, p.z, (double)n.x, (double)n.y, (double)n.z, sum.area, mean.x,
                       mean.y, mean.z, csvField(solution.materialOf(chart)).c_str());
        sum = {};
    };
    solution.forPieces([&](int c, int e, const std::vector<SolutionPoint> &piece) {
        if (e != cell) put(), chart = c, cell = e;
        sum.add(piece);
    });
    put();
    common::writeWhole(path, text);
}

void exportPolygons(const Solution &solution, const std::string &path, bool ply) {
    ColourScale colour(solution);
    LitCorners corners(solution);
    const char *type = length(solution.origin) > 0 ? "double" : "float";
    std::string text;
    common::append(text,
                   ply ? "ply\nformat ascii 1.0\ncomment %s; colours are sRGB, 1 stands for %g\n"
                       : "%s: colours after the coordinates are sRGB, 1 stands for %g\n",
                   kExportedObj, 1 / (double)colour.scale);
    if (ply)
        common::append(text,
                       "element vertex %zu\nproperty %s x\nproperty %s y\nproperty %s z\n"
                       "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                       "element face %zu\nproperty list uchar int vertex_indices\nend_header\n",
                       corners.points.size(), type, type, type, corners.faces.size());
    for (const SolutionPoint &p : corners.points) {
        text += (ply ? "" : "v ") + pointText(solution, p.p);
        for (float c : {colour(p.radiosity.x), colour(p.radiosity.y), colour(p.radiosity.z)})
            ply ? common::append(text, " %d", (int)(c * 255 + 0.5f))
                : common::append(text, " %.4f", (double)c);
        text += '\n';
    }
    for (const auto &face : corners.faces) {
        text += ply ? std::to_string(face.size()) : "f";
        for (size_t corner : face) common::append(text, " %zu", ply ? corner : corner + 1);
        text += '\n';
    }
    common::writeWhole(path, text);
}

} // namespace odraz::radiosity
