// Lightmaps: pages on which every chart of a solution has its own rectangle of texels.
//
// If texels are as fine as elements, they lie at the corners of elements, where solutions keep light: a page
// sampled bilinearly is exactly the solution. If a chart's reflectance comes from a picture, its texels lie
// inside the elements instead, two by two, because reflectance is discontinuous between elements.
#pragma once

#include "tools/radiosity/solution/solution.h"

namespace odraz::radiosity {

// The content of a page. Light is irradiance / pi; Radiosity is Light times reflectance plus emission.
// Reflectance has pages only if it comes from pictures.
enum class PageContent { Light, Radiosity, Reflectance };

struct AtlasSettings {
    bool radiosity = false; // pages hold Radiosity; otherwise Light
    double texels = 0;      // texels for a unit of length; 0: as fine as elements
    int padding = 2;        // texels around each chart that repeat its outermost ones, 1 ..
    int page = 8192;        // texels along a page's longest side
};

// The texels of a chart, without padding.
struct AtlasPlace {
    int page, x, y, across, down;
    bool pictured; // its reflectance comes from a picture
    bool within;   // texels lie inside elements; otherwise at their corners
    bool exact;    // they are as fine as elements

    // Convert a point of a chart (world units along its axes) to texels, counted from the corner of the first
    // one; and back
    float column(const Chart &c, float u) const { return place(u / c.width, across); }
    float row(const Chart &c, float v) const { return place(v / c.height, down); }
    float uOf(const Chart &c, float column) const { return back(column, across) * c.width; }
    float vOf(const Chart &c, float row) const { return back(row, down) * c.height; }

private:
    float place(float share, int count) const {
        return within ? share * (float)count : 0.5f + share * (float)(count - 1);
    }
    float back(float at, int count) const {
        return within ? at / (float)count : (at - 0.5f) / (float)(count - 1);
    }
};

struct AtlasPage {
    int width = 0, height = 0;
};

struct Atlas {
    AtlasSettings settings;
    std::vector<AtlasPlace> places; // of each chart
    std::vector<AtlasPage> pages;
    std::vector<uint8_t> there; // for each cell: whether part of a facet lies in it
    int coarse = 0;             // charts with fewer texels than elements, because pages are not large enough
    int64_t used = 0;           // texels, with padding
};

Atlas packAtlas(const Solution &solution, const AtlasSettings &settings);

// The rows from top to bottom, three floats a texel; texels of no chart are black.
std::vector<float> paintPage(const Solution &solution, const Atlas &atlas, int page, PageContent content);

// Writes model.obj, model.mtl, model.gltf, model.bin and the pages as PNG and HDR into a folder that must be
// new or empty: all of them or none. Adds a summary to `notes`. Throws Refused, std::runtime_error.
void exportAtlas(const Solution &solution, const AtlasSettings &settings, const std::string &folder,
                 std::vector<std::string> &notes);

// --- The model exported with lightmaps, and its glTF 2.0 file ---

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
    std::string name; // the pages': light or radiosity
    bool radiosity;   // the pages hold radiosity, not light
    bool pictured;    // there are also pages of reflectance
    float one;        // the light that is 1 in the PNG
    size_t pages;
    std::vector<AtlasPoint> points; // three or four for every facet, not shared
    std::vector<int> first;         // the first of each facet's points; one more at the end
    std::vector<AtlasMaterial> materials;
};

// TEXCOORD_0 and TEXCOORD_1 are coordinates on the pages. Light is a material's lightmap (MOZ_lightmap),
// beside its colour and emission; radiosity is shown unlit (KHR_materials_unlit).
void writeGltf(const AtlasModel &model, const std::string &path, const std::string &binary);

} // namespace odraz::radiosity
