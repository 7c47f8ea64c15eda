// Direct light on a mesh by rays: from what shines in it, from balls and suns. The sky comes with the light
// of other surfaces (gather.h).
//
// What shines is divided into triangles. A place looks at a point in each, another one every time, and counts
// it as a disc from afar and by Lambert's formula from near, as radiosity/direct.h does; of very many it
// takes kMost, by what they give off, spread over where they lie. Places of one texel, or of a small polygon,
// share the work. Where few triangles of the mesh shine, rays only tell what share of their light is open:
// what there would be of it without a shadow is their form factors'.
#pragma once

#include "tools/radiosity/light_grid.h"
#include "tools/radiosity/surroundings.h"

namespace odraz {

class LampRays {
public:
    static constexpr int kMost = 128, kMostWhole = 32;

    // The largest polygon that shines has about `samples` parts.
    LampRays(const Mesh &mesh, const Regions &regions, int samples);
    bool none() const { return parts.empty(); }
    double share() const { return shining; } // of the model's area
    void clear() { parts.clear(), until.clear(), wholes.clear(); }

    // What a place gets, irradiance / pi; `seed` is another for every place, and `shift`, 0 .. 1, tells which
    // parts it looks at: so many places share them, each with some that lie evenly apart.
    Rgb at(const RayTree &tree, const Surroundings &around, const Vec3 &p, const Vec3 &n, uint32_t seed,
           float shift, int sharers) const;

private:
    struct Part {
        Vec3 corner[3], n;
        float area;
        Rgb radiance;
        Vec3 middle() const { return (corner[0] + corner[1] + corner[2]) * (1 / 3.f); }
    };
    double shining = 0;
    std::vector<Part> parts;
    std::vector<float> until; // sums of what the parts give off
    std::vector<Part> wholes; // what shines, undivided; empty: too many
    // What a place would get without shadows, and what it does.
    struct Light {
        Rgb all, open;
    };
    Light from(const Part &part, const RayTree &tree, const Vec3 &p, const Vec3 &n, float a, float b) const;
    Rgb unshadowed(const Vec3 &p, const Vec3 &n) const;
};

// Of all texels that can be seen, the mean over their places; bits of `behind` tell which of every site's do
// not count (gather.h).
std::vector<Rgb> directLight(const LampRays &lamps, const Surroundings &around, const LightGrid &grid,
                             const std::vector<uint16_t> &behind, const RayTree &tree, Workers &workers);

} // namespace odraz
