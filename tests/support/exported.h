// Reads lightmaps as other programs do: the OBJ by tinyobjloader, its pages by stb_image.
#pragma once

#include "trace/scene/lightmap.h"

#include <string>
#include <vector>

struct ExportedPage {
    int width = 0, height = 0;
    std::vector<float> hdr;   // three a texel, rows from above
    std::vector<uint8_t> png; // the same

    // Samples bilinearly, as graphics processors do; texture coordinates count from the bottom.
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

    // `name` of the pages: light or radiosity. Fails the calling test if something cannot be read.
    Exported(const std::string &folder, const std::string &name);

    // The radiance that a viewer shows at a place of a chart; false if no triangle of the chart lies there.
    bool shows(int chart, odraz::Vec3 p, odraz::Rgb &radiance) const;

    // Fails the test if a texel lies in triangles of two charts, or if two such texels are at most `apart`
    // texels apart.
    void mustLieApart(int apart) const;

private:
    std::vector<std::vector<int>> ofChart;
};
