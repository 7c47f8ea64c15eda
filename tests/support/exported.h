// Reads exported lightmaps with independent libraries: the OBJ with tinyobjloader, its pages with stb_image.
#pragma once

#include "trace/scene/lightmap.h"

struct ExportedPage {
    int width = 0, height = 0;
    std::vector<float> hdr;   // three values a texel, the top row first
    std::vector<uint8_t> png; // in the same order

    // Samples the page bilinearly, as graphics processors do. v is 0 at the bottom.
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

    // Reads model.obj and all pages of a folder. `name`: light or radiosity, as in light-0.hdr. Fails the
    // calling test if a file cannot be read.
    Exported(const std::string &folder, const std::string &name);

    // Computes the radiance that a viewer shows at point p of a chart. Returns false if no triangle of the
    // chart contains p.
    bool radianceAt(int chart, odraz::Vec3 p, odraz::Rgb &radiance) const;

    // Fails the test if two charts share a texel, or if texels of two charts are at most `gap` texels apart.
    void mustHaveGap(int gap) const;

private:
    std::vector<std::vector<int>> ofChart;
};
