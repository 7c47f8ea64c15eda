#include "tests/support/exported.h"

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_HDR
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

using namespace odraz;

Rgb ExportedPage::at(float u, float v) const {
    float x = u * (float)width - 0.5f, y = (1 - v) * (float)height - 0.5f;
    float left = std::floor(x), above = std::floor(y);
    auto texel = [&](int i, int j) {
        const float *p = &hdr[((size_t)std::clamp(j, 0, height - 1) * (size_t)width +
                               (size_t)std::clamp(i, 0, width - 1)) *
                              3];
        return Rgb{p[0], p[1], p[2]};
    };
    int i = (int)left, j = (int)above;
    return lerp(lerp(texel(i, j), texel(i + 1, j), x - left),
                lerp(texel(i, j + 1), texel(i + 1, j + 1), x - left), y - above);
}

Exported::Exported(const std::string &folder, const std::string &name) {
    tinyobj::ObjReader reader;
    EXPECT_TRUE(reader.ParseFromFile(folder + "/model.obj")) << reader.Error();
    EXPECT_EQ(reader.Warning(), "");
    for (const tinyobj::material_t &m : reader.GetMaterials()) {
        int page = -1;
        std::sscanf(m.diffuse_texname.c_str(), (name + "-%d.png").c_str(), &page);
        materials.push_back({{m.diffuse[0], m.diffuse[1], m.diffuse[2]},
                             {m.emission[0], m.emission[1], m.emission[2]},
                             page});
    }
    for (int page = 0;; ++page) {
        std::string path = folder + "/" + name + "-" + std::to_string(page);
        ExportedPage p;
        int channels, width, height;
        float *hdr = stbi_loadf((path + ".hdr").c_str(), &p.width, &p.height, &channels, 3);
        if (!hdr) break;
        p.hdr.assign(hdr, hdr + (size_t)p.width * (size_t)p.height * 3);
        stbi_image_free(hdr);
        uint8_t *png = stbi_load((path + ".png").c_str(), &width, &height, &channels, 3);
        EXPECT_TRUE(png && width == p.width && height == p.height) << path;
        if (png) p.png.assign(png, png + p.hdr.size());
        stbi_image_free(png);
        pages.push_back(std::move(p));
    }
    EXPECT_FALSE(pages.empty());
    const tinyobj::attrib_t &all = reader.GetAttrib();
    for (const tinyobj::shape_t &shape : reader.GetShapes())
        for (size_t i = 0; i < shape.mesh.indices.size() / 3; ++i) {
            ExportedTriangle t = {};
            for (size_t k = 0; k < 3; ++k) {
                const tinyobj::index_t &at = shape.mesh.indices[3 * i + k];
                const float *p = &all.vertices[(size_t)at.vertex_index * 3],
                            *uv = &all.texcoords[(size_t)at.texcoord_index * 2];
                t.p[k] = {p[0], p[1], p[2]}, t.u[k] = uv[0], t.v[k] = uv[1];
            }
            t.chart = (int)shape.mesh.smoothing_group_ids[i] - 1;
            t.material = shape.mesh.material_ids[i];
            t.page = materials.at((size_t)t.material).page;
            EXPECT_TRUE(t.chart >= 0 && t.page >= 0 && t.page < (int)pages.size());
            ofChart.resize(std::max(ofChart.size(), (size_t)t.chart + 1));
            ofChart[(size_t)t.chart].push_back((int)triangles.size());
            triangles.push_back(t);
        }
}

bool Exported::radianceAt(int chart, Vec3 p, Rgb &radiance) const {
    for (int i : ofChart.at((size_t)chart)) {
        const ExportedTriangle &t = triangles[(size_t)i];
        Vec3 n = cross(t.p[1] - t.p[0], t.p[2] - t.p[0]);
        float twice = dot(n, n), share[3];
        for (int k = 0; k < 3; ++k)
            share[k] = dot(cross(t.p[(k + 1) % 3] - p, t.p[(k + 2) % 3] - p), n) / twice;
        if (*std::min_element(share, share + 3) < -1e-3f) continue;
        float u = 0, v = 0;
        for (int k = 0; k < 3; ++k) u += share[k] * t.u[k], v += share[k] * t.v[k];
        const ExportedMaterial &m = materials[(size_t)t.material];
        radiance = pages[(size_t)t.page].at(u, v) * m.reflects + m.emits;
        return true;
    }
    return false;
}

void Exported::mustHaveGap(int gap) const {
    for (size_t page = 0; page < pages.size(); ++page) {
        int width = pages[page].width, height = pages[page].height, covered = 0, wrong = 0;
        std::vector<int> chartAt((size_t)width * (size_t)height, -1);
        for (const ExportedTriangle &t : triangles) {
            if (t.page != (int)page) continue;
            double x[3], y[3];
            for (int k = 0; k < 3; ++k) {
                x[k] = (double)t.u[k] * width - 0.5, y[k] = (1 - (double)t.v[k]) * height - 0.5;
                EXPECT_TRUE(x[k] >= 0 && y[k] >= 0 && x[k] <= width - 1 && y[k] <= height - 1);
            }
            double twice = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
            auto [x0, x1] = std::minmax({x[0], x[1], x[2]});
            auto [y0, y1] = std::minmax({y[0], y[1], y[2]});
            for (int j = (int)y0; j <= (int)y1 + 1 && j < height; ++j)
                for (int i = (int)x0; i <= (int)x1 + 1 && i < width; ++i) {
                    bool in = true;
                    for (int k = 0; k < 3; ++k) {
                        int n = (k + 1) % 3;
                        double side = (x[n] - x[k]) * (j - y[k]) - (y[n] - y[k]) * (i - x[k]);
                        in &= side * (twice > 0 ? 1 : -1) >= -1e-3;
                    }
                    int &chart = chartAt[(size_t)(j * width + i)];
                    if (in && chart >= 0 && chart != t.chart) ++wrong;
                    if (in) chart = t.chart, ++covered;
                }
        }
        EXPECT_GT(covered, 0);
        EXPECT_EQ(wrong, 0) << "texels in two charts";
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i) {
                int chart = chartAt[(size_t)(j * width + i)];
                if (chart < 0) continue;
                for (int y = std::max(j - gap, 0); y <= std::min(j + gap, height - 1); ++y)
                    for (int x = std::max(i - gap, 0); x <= std::min(i + gap, width - 1); ++x) {
                        int other = chartAt[(size_t)(y * width + x)];
                        wrong += other >= 0 && other != chart;
                    }
            }
        EXPECT_EQ(wrong, 0) << "charts too near";
    }
}
