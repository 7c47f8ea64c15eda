// Lightmaps as other programs read them: the OBJ by tinyobjloader, its pages by stb_image.
#pragma once

#include "trace/scene/lightmap.h"

#include <string>
#include <vector>

struct ExportedPage {
    int width = 0, height = 0;
    std::vector<float> hdr;   // three a texel, rows from above
    std::vector<uint8_t> png; // likewise

    // Bilinear, as graphics processors do it; texture coordinates are counted from below.
    odraz::Rgb at(float u, float v) const;
};

struct ExportedTriangle {
    odraz::Vec3 p[3];
    float u[3], v[3];
    int chart, material, page;
};

struct ExportedMaterial {
    odraz::Rgb reflects, emits;
    int page;
};

struct Exported {
    std::vector<ExportedTriangle> triangles;
    std::vector<ExportedMaterial> materials;
    std::vector<ExportedPage> pages;
    std::string gltf, binary;

    // `name` of pages: light or radiosity. Fails the test that calls where something cannot be read.
    Exported(const std::string &folder, const std::string &name);

    // What a viewer shows at a place of a chart; false where no triangle of that chart lies there.
    bool shows(int chart, odraz::Vec3 p, odraz::Rgb &radiance) const;

    // Fails the test where a texel lies in triangles of two charts, or two such lie no more than so many
    // apart.
    void mustLieApart(int apart) const;

private:
    std::vector<std::vector<int>> ofChart;
};
