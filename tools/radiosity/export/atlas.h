// Lightmaps: pages on which each chart of a solution has its own rectangle of texels.
//
// If texels are as fine as elements, they lie at the corners of elements, where solutions store light. A page
// sampled bilinearly then equals the solution. If a chart's reflectance comes from a picture, its texels lie
// inside the elements instead, two by two, because reflectance is discontinuous between elements.
#pragma once

#include "tools/radiosity/solution/solution.h"

namespace odraz::radiosity {

// The values on a page. Light is irradiance / pi. Radiosity is Light times reflectance plus emission.
// Reflectance has pages only if it comes from pictures.
enum class PageContent { Light, Radiosity, Reflectance };

struct AtlasSettings {
    bool radiosity = false; // pages hold Radiosity; otherwise Light
    double texels = 0;      // texels per unit of length; 0: as fine as elements
    int padding = 2;        // texels around each chart that repeat its outermost texels, 1 ..
    int page = 8192;        // texels along a page's longest side
};

// The texels of a chart, without padding.
struct AtlasPlace {
    int page, x, y, across, down;
    bool pictured; // the chart's reflectance comes from a picture
    bool within;   // texels lie inside elements; otherwise at their corners
    bool exact;    // texels are as fine as elements

    // Convert world units along a chart's axes to texels, counted from the first texel's corner; and back.
    float column(const Chart &c, float u) const { return toTexel(u / c.width, across); }
    float row(const Chart &c, float v) const { return toTexel(v / c.height, down); }
    float uOf(const Chart &c, float column) const { return toShare(column, across) * c.width; }
    float vOf(const Chart &c, float row) const { return toShare(row, down) * c.height; }

private:
    float toTexel(float share, int count) const {
        return within ? share * (float)count : 0.5f + share * (float)(count - 1);
    }
    float toShare(float texel, int count) const {
        return within ? texel / (float)count : (texel - 0.5f) / (float)(count - 1);
    }
};

struct AtlasPage {
    int width = 0, height = 0;
};

struct Atlas {
    AtlasSettings settings;
    std::vector<AtlasPlace> places; // one per chart
    std::vector<AtlasPage> pages;
    std::vector<uint8_t> occupied; // for each cell: whether part of a facet lies in it
    int coarse = 0;                // charts with fewer texels than asked for, because pages are too small
    int64_t used = 0;              // number of texels used, with padding
};

Atlas packAtlas(const Solution &solution, const AtlasSettings &settings);

// The texels of a page in rows from top to bottom, three floats each. Texels of no chart are black.
std::vector<float> paintPage(const Solution &solution, const Atlas &atlas, int page, PageContent content);

// Writes model.obj, model.mtl, model.gltf, model.bin and the pages as PNG, HDR and EXR into a folder that
// must be new or empty: all of them or none. Adds a summary to `notes`. Throws Refused or std::runtime_error.
void exportAtlas(const Solution &solution, const AtlasSettings &settings, const std::string &folder,
                 std::vector<std::string> &notes);

// --- The model exported with lightmaps, and its glTF 2.0 file ---

struct AtlasPoint {
    Vec3 p;
    float u, v; // 0 .. 1 across the page, v from the top
};

// A material of the model on one page.
struct AtlasMaterial {
    std::string name; // the material's with _pageN
    int page;
    Rgb reflects, emits; // 1 and 0 if the page includes them
    bool pictured;       // it has a page of reflectance
};

// The facets of one object, group and material.
struct AtlasPart {
    std::string object, group; // as in the model; empty: none
    size_t material;
    std::vector<int> facets;
};

struct AtlasModel {
    AtlasModel(const Solution &solution, const Atlas &atlas, float one);

    const Solution &solution;
    std::string name; // name of the pages: light or radiosity
    bool radiosity;   // the pages hold radiosity, not light
    bool pictured;    // there are also pages of reflectance
    float one;        // the light that 1 stands for in the PNG
    size_t pages;
    std::vector<AtlasPoint> points; // three or four per facet, not shared
    std::vector<int> first;         // index of each facet's first point, and the number of points
    std::vector<AtlasMaterial> materials;
    std::vector<AtlasPart> parts; // those of an object follow each other
};

// Writes the glTF. TEXCOORD_0 and TEXCOORD_1 are coordinates on the pages. Light is a material's lightmap
// (MOZ_lightmap), next to its colour and emission. Radiosity is shown unlit (KHR_materials_unlit).
void writeGltf(const AtlasModel &model, const std::string &path, const std::string &binary);

} // namespace odraz::radiosity
