// A solved model as a file: its charts, elements and light; and what can be made of it.
#pragma once

#include "tools/radiosity/bake.h"

namespace odraz {

// A point of an element's outline, and the radiosity there.
struct BakedPoint {
    Vec3 p;
    Rgb radiosity;
};

class Baked {
public:
    Baked() = default;
    explicit Baked(const Bake &bake);
    // Throws std::runtime_error with a line that begins with the file's name, where it cannot be read or is
    // not sound: every index within its list, every number finite, no cell below itself.
    explicit Baked(const std::string &path);
    // Written beside and renamed. Throws likewise.
    void save(const std::string &path) const;
    // What save() writes, of all that stands behind the checksum.
    static std::string withChecksum(const std::string &body);

    // Visits the part of every element that lies on each facet: convex outlines, with the points of smaller
    // neighbours that hang in their sides.
    void
    forPieces(const std::function<void(int chart, int cell, const std::vector<BakedPoint> &)> &visit) const;

    size_t elements() const; // that something lies on

    // At a place of a chart that lies in that cell, in world units along its axes: what arrives there.
    Rgb lightIn(int cell, float u, float v) const;
    // What it shows there.
    Rgb radiosityIn(int cell, float u, float v) const;
    // What share of it a cell reflects.
    Rgb reflectsOf(int cell) const;
    // What arrives at a place of a chart.
    Rgb lightAt(int chart, const Vec3 &p) const;
    // What it shows there.
    Rgb radiosityAt(int chart, const Vec3 &p) const;

    std::vector<Chart> charts;
    std::vector<Facet> facets;
    std::vector<Cell> cells;
    std::vector<Texel> texels;
    std::vector<Rgb> light;           // of each texel: what arrives
    std::vector<Rgb> reflects, emits; // of each chart; on average, where it has a picture
    std::vector<Rgb> pictured;        // what each cell reflects; empty where there are no pictures

private:
    struct Spot {
        int cell;
        float u, v;
    };
    Spot spotAt(int chart, const Vec3 &p) const;
};

// Whether all that a file holds can be worked with. Its checksum tells of accidents, not of intent.
bool sound(const Baked &baked);

void exportCsv(const Baked &baked, const std::string &path);
void exportPly(const Baked &baked, const std::string &path);
void exportObj(const Baked &baked, const std::string &path);

struct RenderSettings {
    Vec3 eye, target; // in the model's coordinates
    bool upIsZ = false;
    float lens = 60; // vertical field of view, degrees
    int width = 1280, height = 720;
    bool logarithmic = false; // how radiosity becomes brightness: its logarithm, or the film's curve
    float stops = 0;          // brighter than what is exposed for what the camera sees, as powers of two
};
// Sets eye and target: from above and aside, far enough for all facets to be in the picture.
void placeCamera(const Baked &baked, RenderSettings &settings);
void render(const Baked &baked, const RenderSettings &settings, Workers &workers, const std::string &path);

} // namespace odraz
