#include "tools/radiosity/export/points_export.h"

#include "tools/common/statistics.h"
#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/picture/psnr.h"
#include "tools/radiosity/read/mesh.h"

#include <algorithm>
#include <unordered_map>

namespace odraz::radiosity {

namespace {

// The pieces of elements as faces, and their corners with radiosity. Equal corners are merged.
struct LitCorners {
    std::vector<SolutionPoint> points;
    std::vector<std::vector<size_t>> faces;
    explicit LitCorners(const Solution &solution) {
        std::unordered_map<std::string, size_t> numbers; // by the bytes of a corner
        solution.forPieces([&](int, int, const std::vector<SolutionPoint> &piece) {
            std::vector<size_t> &face = faces.emplace_back();
            for (const SolutionPoint &p : piece) {
                auto [entry, added] =
                    numbers.try_emplace(std::string((const char *)&p, sizeof p), points.size());
                if (added) points.push_back(p);
                face.push_back(entry->second);
            }
        });
    }
};

// A point in model coordinates.
std::string pointText(const Solution &solution, const Vec3 &point) {
    const int digits = solution.digits();
    Vec3d p = solution.inModel(point);
    return common::format("%.*g %.*g %.*g", digits, p.x, digits, p.y, digits, p.z);
}

} // namespace

float lightOfOne(const Solution &b, bool radiosity) {
    std::vector<float> all;
    for (size_t i = 0; i < b.texels.size(); ++i) {
        size_t chart = (size_t)b.texels[i].chart;
        if (radiosity && maxComponent(b.emits[chart]) > 0) continue;
        float light = maxComponent(radiosity ? b.light[i] * b.reflects[chart] : b.light[i]);
        if (light > 0) all.push_back(light);
    }
    return all.empty() ? 1 : std::max(common::quantile(std::move(all), 0.99) / 0.9f, 1e-20f);
}

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
    const float one = lightOfOne(solution, true);
    LitCorners corners(solution);
    const char *type = length(solution.origin) > 0 ? "double" : "float";
    std::string text;
    common::append(text,
                   ply ? "ply\nformat ascii 1.0\ncomment %s; colours are sRGB, 1 stands for %g\n"
                       : "%s: colours after the coordinates are sRGB, 1 stands for %g\n",
                   kExportedObj, (double)one);
    if (ply)
        common::append(text,
                       "element vertex %zu\nproperty %s x\nproperty %s y\nproperty %s z\n"
                       "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                       "element face %zu\nproperty list uchar int vertex_indices\nend_header\n",
                       corners.points.size(), type, type, type, corners.faces.size());
    for (const SolutionPoint &p : corners.points) {
        text += (ply ? "" : "v ") + pointText(solution, p.p);
        for (float light : {p.radiosity.x, p.radiosity.y, p.radiosity.z}) {
            const float c = pictures::srgbOfLinear(light / one);
            ply ? common::append(text, " %d", (int)(c * 255 + 0.5f))
                : common::append(text, " %.4f", (double)c);
        }
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
