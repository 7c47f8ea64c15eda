// Lightmaps: pages in which every chart of a solution has a rectangle of texels of its own.
//
// Where texels are as fine as elements, they stand at the elements' corners, as light is kept there: sampled
// bilinearly, a page shows what the solution has, exactly. Charts whose reflectance comes from a picture have
// texels within their elements instead, two by two, since that changes from one to the next.
#pragma once

#include "tools/radiosity/baked.h"

namespace odraz {

// Of what a page is a picture. Light: irradiance over pi; times reflectance, plus what is emitted, it is
// Radiosity. Reflectance is needed where it comes from pictures.
enum class Held { Light, Radiosity, Reflectance };

struct AtlasSettings {
    bool radiosity = false; // the pages' texels hold Radiosity; else Light
    double texels = 0;      // along a unit of length; 0: as many as elements ask for
    int padding = 2;        // texels around each chart that repeat its outermost ones, 1 ..
    int page = 8192;        // texels along a page's longest side
};

// A chart's texels, without padding.
struct AtlasPlace {
    int page, x, y, across, down;
    bool pictured; // its reflectance differs from element to element
    bool within;   // texels stand within elements; else at their corners
    bool exact;    // they are as fine as elements

    // From places of a chart (world units along its axes) to texels, from the first one's corner; and back
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
    std::vector<uint8_t> there; // of each cell: some of a facet lies in it
    int coarse = 0;             // charts that have fewer texels than elements since no page is so large
    int64_t used = 0;           // texels, with padding
};

Atlas packAtlas(const Baked &baked, const AtlasSettings &settings);

// Rows from above to below, three floats a texel; what belongs to nobody is black.
std::vector<float> paintPage(const Baked &baked, const Atlas &atlas, int page, Held held);

// Makes a folder, which must be new or empty, with model.obj, model.mtl, model.gltf, model.bin and the pages
// as PNG and HDR; all of it or nothing. Tells what it did in `notes`. Throws Refused, std::runtime_error.
void exportAtlas(const Baked &baked, const AtlasSettings &settings, const std::string &folder,
                 std::vector<std::string> &notes);

} // namespace odraz
