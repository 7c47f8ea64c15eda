// The model exported with lightmaps, and its glTF 2.0 file.
#pragma once

#include "tools/radiosity/export/atlas.h"

namespace odraz::radiosity {

struct AtlasPoint {
    Vec3 p;
    float u, v; // 0 .. 1 across the page, v from the top
};

// The facets on one page that share reflectance and emission.
struct AtlasMaterial {
    std::string name;
    int page;
    Rgb reflects, emits; // 1 and 0 if they are part of the page
    bool pictured;       // a page of reflectance exists for it
    std::vector<int> facets;
};

struct AtlasModel {
    AtlasModel(const Solution &solution, const Atlas &atlas, float one);

    const Solution &solution;
    std::string name; // of the pages: light or radiosity
    bool radiosity;   // the pages hold radiosity, not light
    bool pictured;    // there are also pages of reflectance
    float one;        // the light that is 1 in the PNG
    size_t pages;
    std::vector<AtlasPoint> points; // three or four for every facet, not shared
    std::vector<int> first;         // of each facet's points; one more at the end
    std::vector<AtlasMaterial> materials;
};

// TEXCOORD_0 and TEXCOORD_1 are coordinates on the pages. Light is a material's lightmap (MOZ_lightmap),
// beside its colour and emission; radiosity is shown unlit (KHR_materials_unlit).
void writeGltf(const AtlasModel &model, const std::string &path, const std::string &binary);

} // namespace odraz::radiosity
