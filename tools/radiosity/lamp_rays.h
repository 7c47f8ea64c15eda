// Direct light on a mesh by rays: from what shines in it, from balls and suns. The sky comes with the light
// of other surfaces (gather.h).
//
// Where few triangles shine, 256 at most, what a place would get of each without a shadow is its form factor,
// by Lambert's formula or, from afar, a disc's; rays to points of it, to all at least one, tell what share of
// it is open.
//
// Of many, divided into parts, a place looks at some, chosen by what they give off and spread over where they
// lie, at another point of a part every time. Places of one texel, or of a small polygon, share the work.
#pragma once

#include "tools/radiosity/light_grid.h"
#include "tools/radiosity/surroundings.h"

namespace odraz {

class LampRays {
public:
    static constexpr int kMost = 128, kFew = 32, kMostWhole = 256;

    // The largest polygon that shines has about `samples` parts.
    LampRays(const Mesh &mesh, const Regions &regions, int samples);
    bool none() const { return parts.empty(); }
    double share() const { return shining; } // of the model's area
    void clear() { parts.clear(), until.clear(), wholes.clear(); }

    // What places of one texel, 1 to 4, get in the mean, irradiance / pi; `seed` is another for every texel,
    // `sharers` the number of places that share so many rays as there are parts, and `shift`, 0 .. 1, tells
    // which of them are theirs.
    Rgb at(const RayTree &tree, const Surroundings &around, const Vec3 *p, int places, const Vec3 &n,
           uint32_t seed, float shift, int sharers) const;

private:
    struct Part {
        Vec3 corner[3], n;
        float area;
        Rgb radiance;
        Vec3 middle() const { return (corner[0] + corner[1] + corner[2]) * (1 / 3.f); }
        // Of its area evenly, from two numbers 0 .. 1.
        Vec3 point(float a, float b) const {
            if (a + b > 1) a = 1 - a, b = 1 - b;
            return corner[0] + (corner[1] - corner[0]) * a + (corner[2] - corner[0]) * b;
        }
    };
    double shining = 0;
    std::vector<Part> parts;
    std::vector<float> until; // sums of what the parts give off
    std::vector<Part> wholes; // what shines, undivided; empty: too many
    static float formFactor(const Part &part, const Vec3 &p, const Vec3 &n, float near);
    Rgb fromAll(const RayTree &tree, const Vec3 *p, int places, const Vec3 &n, uint32_t seed, int rays) const;
    Rgb fromSome(const RayTree &tree, const Vec3 &p, const Vec3 &n, uint32_t seed, float shift,
                 int some) const;
};

// Of all texels that can be seen, the mean over their places; bits of `behind` tell which of every site's do
// not count (gather.h).
std::vector<Rgb> directLight(const LampRays &lamps, const Surroundings &around, const LightGrid &grid,
                             const std::vector<uint16_t> &behind, const RayTree &tree, Workers &workers);

} // namespace odraz
