// Writes lightmaps to a folder: the pages, and the model with texture coordinates on them.
#include "tools/radiosity/export/atlas.h"

#include "tools/common/folders.h"
#include "tools/common/text.h"
#include "tools/common/whole_file.h"
#include "tools/picture/picture.h"
#include "tools/radiosity/export/points_export.h"

#include <algorithm>

#include <stb/stb_image_write.h>

namespace odraz::radiosity {

namespace {

void writePng(const common::NewFolder &folder, const std::string &name, const AtlasPage &size,
              const std::vector<float> &texels, float one) {
    pictures::Picture picture = {.width = size.width, .height = size.height, .light = texels};
    for (float &x : picture.light) x /= one;
    pictures::writePng(folder / name, pictures::toImage(picture));
}

void writeHdr(const common::NewFolder &folder, const std::string &name, const AtlasPage &size,
              std::vector<float> &&texels) {
    // Add half a step of the eight-bit mantissa, because the writer truncates
    for (size_t i = 0; i < texels.size(); i += 3) {
        float most = std::max({texels[i], texels[i + 1], texels[i + 2]});
        int exponent;
        std::frexp(most, &exponent);
        for (size_t k = 0; k < 3 && most > 0; ++k)
            texels[i + k] = std::max(texels[i + k], 0.f) + std::ldexp(0.5f, exponent - 8);
    }
    std::string hdr;
    auto append = [](void *to, void *bytes, int count) {
        ((std::string *)to)->append((const char *)bytes, (size_t)count);
    };
    if (!stbi_write_hdr_to_func(append, &hdr, size.width, size.height, 3, texels.data()))
        throw std::runtime_error("there is not enough memory for " + name);
    folder.write(name, hdr);
}

std::string mtlOf(const AtlasModel &m) {
    std::string text;
    common::append(text, "# %s-N.png are sRGB; 1 stands for %.7g in %s-N.hdr, which are linear\n",
                   m.name.c_str(), (double)m.one, m.name.c_str());
    text += m.radiosity ? "# They contain radiance, emission included: show them unchanged\n"
                        : "# They contain irradiance over pi: multiply it by Kd and add Ke to get radiance\n"
                          "# Blender takes map_Kd instead of Kd: for Blender, export with --map radiosity\n";
    for (const AtlasMaterial &a : m.materials) {
        if (a.pictured)
            common::append(text, "# Use reflectance-%d.png instead of Kd, at the same coordinates\n", a.page);
        common::append(text, "newmtl %s\nKd %.7g %.7g %.7g\nKe %.7g %.7g %.7g\n", a.name.c_str(),
                       (double)a.reflects.x, (double)a.reflects.y, (double)a.reflects.z, (double)a.emits.x,
                       (double)a.emits.y, (double)a.emits.z);
        common::append(text, "map_Kd %s-%d.png\n", m.name.c_str(), a.page);
    }
    return text;
}

std::string objOf(const AtlasModel &m) {
    std::string text;
    common::append(
        text,
        "# by odraz: vt are coordinates on %s-N.png, .hdr and .exr; every plane is a smoothing group\n"
        "mtllib model.mtl\n",
        m.name.c_str());
    const int digits = m.solution.digits() + 1;
    for (const AtlasPoint &p : m.points) {
        Vec3d at = m.solution.inModel(p.p);
        common::append(text, "v %.*g %.*g %.*g\n", digits, at.x, digits, at.y, digits, at.z);
    }
    for (const AtlasPoint &p : m.points)
        common::append(text, "vt %.8f %.8f\n", (double)p.u, 1 - (double)p.v); // v is counted from the bottom
    for (const Chart &c : m.solution.charts)
        common::append(text, "vn %.6g %.6g %.6g\n", (double)c.n.x, (double)c.n.y, (double)c.n.z);
    std::string object, group;
    for (const AtlasPart &part : m.parts) {
        if (part.object != object) text += "o " + part.object + "\n", group.clear();
        if (part.group != group) text += "g " + part.group + "\n";
        object = part.object, group = part.group;
        text += "usemtl " + m.materials[part.material].name + "\n";
        int chart = -1;
        for (int i : part.facets) {
            const Facet &f = m.solution.facets[(size_t)i];
            if (f.chart != chart) common::append(text, "s %d\n", f.chart + 1);
            chart = f.chart;
            text += 'f';
            for (int p = m.first[(size_t)i]; p < m.first[(size_t)i + 1]; ++p)
                common::append(text, " %d/%d/%d", p + 1, p + 1, chart + 1);
            text += '\n';
        }
    }
    return text;
}

} // namespace

void exportAtlas(const Solution &b, const AtlasSettings &s, const std::string &path,
                 std::vector<std::string> &notes) {
    if (b.facets.empty()) throw std::runtime_error("the solution has no polygon to export");
    common::NewFolder folder(path);
    Atlas atlas = packAtlas(b, s);
    AtlasModel model(b, atlas, lightOfOne(b, s.radiosity));
    folder.write("model.obj", objOf(model));
    folder.write("model.mtl", mtlOf(model));
    writeGltf(model, folder / "model.gltf", folder / "model.bin");
    int64_t texels = 0;
    for (size_t i = 0; i < atlas.pages.size(); ++i) {
        const AtlasPage &page = atlas.pages[i];
        std::string name = model.name + "-" + std::to_string(i);
        notes.push_back(common::format("%s: %d x %d texels", name.c_str(), page.width, page.height));
        texels += (int64_t)page.width * page.height;
        std::vector<float> light =
            paintPage(b, atlas, (int)i, s.radiosity ? PageContent::Radiosity : PageContent::Light);
        writePng(folder, name + ".png", page, light, model.one);
        pictures::writeExr(folder / (name + ".exr"), page.width, page.height, light);
        writeHdr(folder, name + ".hdr", page, std::move(light));
        if (model.pictured)
            writePng(folder, "reflectance-" + std::to_string(i) + ".png", page,
                     paintPage(b, atlas, (int)i, PageContent::Reflectance), 1);
    }
    folder.finish();
    notes.push_back(common::format("%s in %s, filled by %.0f %%; in PNG 1 stands for %.4g",
                                   common::counted(b.charts.size(), "polygon").c_str(),
                                   common::counted(atlas.pages.size(), "page").c_str(),
                                   100. * (double)atlas.used / (double)texels, (double)model.one));
    if (atlas.coarse)
        notes.push_back(common::counted((size_t)atlas.coarse, "polygon has", "polygons have") +
                        " fewer texels than asked for: raise --page");
}

} // namespace odraz::radiosity
