#include "tools/radiosity/read/mesh_builder.h"

#include "tools/radiosity/read/reflectance_picture.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace odraz::radiosity {

namespace {

using Shade = std::array<int, 3>; // a colour in steps of kStep

constexpr size_t kMostParts = 8192; // per material
constexpr float kStep = 1 / 64.f;   // colours of one material differ by less than this

// Divides triangles by the picture of their material's emission.
class EmissionDivider {
public:
    EmissionDivider(Mesh &mesh) : mesh(mesh) {}

    void divide(int material, const ReflectancePicture &picture) {
        std::vector<Triangle> given;
        std::vector<std::array<float, 6>> coordinates;
        size_t kept = 0;
        for (size_t i = 0; i < mesh.triangles.size(); ++i) {
            if (mesh.triangles[i].material == material) {
                given.push_back(mesh.triangles[i]), coordinates.push_back(mesh.coordinates[i]);
                continue;
            }
            mesh.triangles[kept] = mesh.triangles[i], mesh.coordinates[kept++] = mesh.coordinates[i];
        }
        mesh.triangles.resize(kept), mesh.coordinates.resize(kept);
        deepest = 0;
        while (deepest < 6 && given.size() << (2 * (deepest + 1)) <= kMostParts) ++deepest;
        shades.clear(), parts.clear();
        texture = &picture, source = mesh.materials[(size_t)material].emissionPicture;
        for (size_t i = 0; i < given.size(); ++i) divide(given[i], coordinates[i], 0);
        addParts(material);
    }

private:
    struct ShadedTriangle {
        Triangle triangle;
        std::array<float, 6> at;
        Shade shade;
    };
    struct ShadeSum {
        double area = 0;
        Vec3d light = {};
    };
    Mesh &mesh;
    const ReflectancePicture *texture = nullptr;
    MeshPicture source;
    int deepest = 0;
    std::vector<ShadedTriangle> parts;
    std::map<Shade, ShadeSum> shades;
    std::map<std::pair<int, int>, int> middles; // midpoints of edges, by the edge's ends

    Rgb meanOf(const std::array<float, 6> &at) const {
        std::vector<TexturePoint> corners;
        for (size_t k = 0; k < 3; ++k)
            corners.push_back({(double)(at[2 * k] * source.scale[0] + source.offset[0]),
                               (double)(at[2 * k + 1] * source.scale[1] + source.offset[1])});
        return texture->mean(corners, source.clamp);
    }

    int middle(int a, int b) {
        auto [entry, added] = middles.try_emplace(std::minmax(a, b), (int)mesh.points.size());
        if (added) mesh.points.push_back((mesh.points[(size_t)a] + mesh.points[(size_t)b]) / 2);
        return entry->second;
    }

    // Adds a triangle if it has one colour, otherwise divides it into four.
    void divide(const Triangle &t, const std::array<float, 6> &at, int depth) {
        const std::array<int, 3> &c = t.corners;
        auto half = [&](size_t a, size_t b) {
            return std::array<float, 2>{(at[2 * a] + at[2 * b]) / 2, (at[2 * a + 1] + at[2 * b + 1]) / 2};
        };
        const std::array<std::array<float, 2>, 6> p = {
            {{at[0], at[1]}, {at[2], at[3]}, {at[4], at[5]}, half(0, 1), half(1, 2), half(2, 0)}};
        constexpr size_t kParts[4][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
        std::array<std::array<float, 6>, 4> quarters;
        float spread = 0;
        const Rgb mean = meanOf(at);
        for (size_t k = 0; k < 4; ++k) {
            for (size_t i = 0; i < 6; ++i) quarters[k][i] = p[kParts[k][i / 2]][i % 2];
            Rgb difference = meanOf(quarters[k]) - mean;
            for (float x : {difference.x, difference.y, difference.z})
                spread = std::max(spread, std::fabs(x));
        }
        // Always divide twice: the means of large parts may be equal although the parts have a pattern
        const bool placed = !std::isnan(at[0]);
        if (placed && depth < deepest && (depth < 2 || spread > kStep / 2)) {
            const int all[6] = {c[0], c[1], c[2], middle(c[0], c[1]), middle(c[1], c[2]), middle(c[2], c[0])};
            for (size_t k = 0; k < 4; ++k)
                divide({{all[kParts[k][0]], all[kParts[k][1]], all[kParts[k][2]]}, t.material, t.object},
                       quarters[k], depth + 1);
            return;
        }
        auto step = [](float x) { return (int)std::lround(x / kStep); };
        Shade shade = {step(mean.x), step(mean.y), step(mean.z)};
        double area = length(normalOf(mesh, t));
        ShadeSum &sum = shades[shade];
        sum.area += area, sum.light = sum.light + toDouble(mean) * area;
        parts.push_back({t, at, shade});
    }

    // Makes a material for each shade. The first one replaces the original.
    void addParts(int material) {
        std::map<Shade, int> numbers;
        const MeshMaterial original = mesh.materials[(size_t)material];
        for (const auto &[shade, sum] : shades) {
            int number = numbers.empty() ? material : (int)mesh.materials.size();
            if (!numbers.empty()) mesh.materials.push_back(original);
            numbers[shade] = number;
            for (size_t k = 0; k < 3; ++k)
                mesh.materials[(size_t)number].emits[k] = source.tint[k] * (float)(sum.light[k] / sum.area);
        }
        for (const ShadedTriangle &p : parts) {
            mesh.triangles.push_back({p.triangle.corners, numbers[p.shade], p.triangle.object});
            mesh.coordinates.push_back(p.at);
        }
    }
};

} // namespace

void divideByEmission(Mesh &mesh, std::vector<std::string> &notes) {
    EmissionDivider divider(mesh);
    for (int i = 0, count = (int)mesh.materials.size(); i < count; ++i) {
        const MeshPicture source = mesh.materials[(size_t)i].emissionPicture;
        if (source.path.empty() || std::none_of(mesh.triangles.begin(), mesh.triangles.end(),
                                                [&](const Triangle &t) { return t.material == i; }))
            continue;
        try {
            pictures::Picture picture = source.read();
            // Scale the picture to at most 1, and the tint by the inverse
            float most = 1;
            for (float x : picture.light) most = std::max(most, x);
            for (float &x : picture.light) x /= most;
            for (float &x : mesh.materials[(size_t)i].emissionPicture.tint)
                if (!((double)(x *= most) <= kMostPower))
                    throw common::Refused(source.path + ": its light times Ke exceeds 1e12");
            divider.divide(i, ReflectancePicture(picture));
        } catch (const common::Refused &e) {
            notes.push_back(std::string(e.what()) + "; the material's emission is used");
        }
    }
}

} // namespace odraz::radiosity
