// For libFuzzer: whatever a model and its materials hold, `radiosity solve` refuses them with a line or can
// work with them. The input is the OBJ; what follows a byte of 255 becomes m.mtl beside it. It writes into
// the current folder.
#include "tools/radiosity/divide/regions.h"
#include "tools/radiosity/patches/patch_system.h"
#include "tools/radiosity/read/reflectance_picture.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>

using namespace odraz;
using namespace odraz::radiosity;

// Checks what readers of a mesh rely on
static void mustBeSound(const Mesh &mesh) {
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
    if (!good) std::abort();
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static auto model = std::make_unique<Model>();
    std::string text((const char *)data, size), materials;
    size_t end = text.find('\xff');
    if (end != std::string::npos) materials = text.substr(end + 1), text.resize(end);
    std::ofstream("m.obj") << text;
    std::ofstream("m.mtl") << materials;
    try {
        std::vector<std::string> notes;
        Mesh mesh = readModel("m.obj", {1, size % 2 == 1, {}}, notes);
        mustBeSound(mesh);
        // The first reader of the mesh must accept it too
        model->chartCount = model->facetCount = 0;
        model->overflow = false;
        Regions regions = joinRegions(mesh, mesh.size() / 10);
        fillModel(*model, regions);
        findLamps(mesh, regions, *model, 16);
        static const ReflectancePicture picture({3, 2, 3, 8, std::vector<uint16_t>(18, 25700), {}});
        for (const auto &at : mesh.coordinates) {
            std::vector<TexturePoint> corners;
            for (size_t k = 0; k < 6; k += 2) corners.push_back({(double)at[k], (double)at[k + 1]});
            float r = picture.mean(corners, size % 3 == 1).x;
            if (std::fabs(r - picture.mean().x) > 1e-3f) std::abort();
        }
        for (int chart : regions.chartOf)
            if (chart < -1 || chart >= model->chartCount) std::abort();
    } catch (const common::Refused &) {
    }
    return 0;
}
