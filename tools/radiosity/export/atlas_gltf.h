// The model that is exported with lightmaps, and its glTF 2.0 file.
#pragma once

#include "tools/radiosity/export/atlas.h"

namespace odraz::radiosity {

struct AtlasPoint {
    Vec3 p;
    float u, v; // 0 .. 1 across the page, v from the top
};

// The facets on one page that share one look.
struct AtlasMaterial {
    std::string name;
    int page;
    Rgb reflects, emits; // 1 and 0 if the page holds all of it
    bool pictured;       // a page holds its reflectance as well
    std::vector<int> facets;
};

struct AtlasModel {
    AtlasModel(const Solution &solution, const Atlas &atlas, float one);

    const Solution &solution;
    std::string name; // of the pages: light or radiosity
    bool radiosity;   // the pages hold radiosity, not light
    bool pictured;    // there are also pages of reflectance
    float one;        // the light that 1 stands for in 8 bits
    size_t pages;
    std::vector<AtlasPoint> points; // every facet has three or four of its own
    std::vector<int> first;         // of each facet's points; one more at the end
    std::vector<AtlasMaterial> materials;
};

// TEXCOORD_0 and TEXCOORD_1 are coordinates on the pages. Light is the lightmap of a material (MOZ_lightmap),
// which keeps its colour and emission; radiosity is shown unlit (KHR_materials_unlit).
void writeGltf(const AtlasModel &model, const std::string &path, const std::string &binary);

} // namespace odraz::radiosity
