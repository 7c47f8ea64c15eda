// The model that goes with lightmaps, and as glTF 2.0.
#pragma once

#include "tools/radiosity/atlas.h"

namespace odraz {

struct AtlasPoint {
    Vec3 p;
    float u, v; // 0 .. 1 of its page, from above
};

// All facets of one page that look alike.
struct AtlasMaterial {
    std::string name;
    int page;
    Rgb reflects, emits; // 1 and 0 where the page has it all
    bool pictured;       // its reflectance is a page as well
    std::vector<int> facets;
};

struct AtlasModel {
    AtlasModel(const Baked &baked, const Atlas &atlas, float one);

    const Baked &baked;
    std::string name; // of the pages: light or radiosity
    bool radiosity;   // what they hold
    bool pictured;    // pages of reflectance belong to them
    float one;        // what 1 stands for in 8 bits
    size_t pages;
    std::vector<AtlasPoint> points; // every facet has its own, three or four
    std::vector<int> first;         // of each facet's; one more
    std::vector<AtlasMaterial> materials;
};

// TEXCOORD_0 and TEXCOORD_1 are the pages'. Light is a material's lightmap (MOZ_lightmap), beside its colour
// and what it emits; radiosity is shown as it is (KHR_materials_unlit).
void writeGltf(const AtlasModel &model, const std::string &path, const std::string &binary);

} // namespace odraz
