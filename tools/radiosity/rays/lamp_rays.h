// Direct light on a mesh by shadow rays: from triangles that emit, from balls and from suns. The sky's light
// is found by the rays for indirect light (ray_system.h).
//
// If at most 256 triangles emit, the unshadowed light from each is its form factor: by Lambert's formula or,
// from afar, a disc's. Shadow rays to points on it, at least one for each triangle, give the visible share.
//
// If more emit, they are divided into parts. Each place samples some of the parts, chosen by power and spread
// over space, at different points. The places of one texel, or of a small polygon, share the samples.
#pragma once

#include "tools/radiosity/rays/light_grid.h"
#include "tools/radiosity/read/surroundings.h"

namespace odraz::radiosity {

// If more than this share of a model's area emits, rays find that light, and no shadow rays are sent to it.
inline constexpr double kLargeLamps = 0.25;

class LampRays {
public:
    static constexpr int kMost = 128, kFew = 32, kMostWhole = 256;

    // Divides the largest emitting polygon into about `samples` parts.
    LampRays(const Mesh &mesh, const Regions &regions, int samples);
    bool none() const { return parts.empty(); }
    double share() const { return emittingShare; } // of the model's area
    void clear() { parts.clear(), until.clear(), wholes.clear(); }

    // The mean light at the 1 to 4 places of one texel, as irradiance / pi. `seed` differs from texel to
    // texel. `sharers` is the number of places that share the rays (one for each part), and `shift`, 0 .. 1,
    // selects this texel's share of them.
    Rgb at(const RayTree &tree, const Surroundings &around, const Vec3 *p, int places, const Vec3 &n,
           uint32_t seed, float shift, int sharers) const;

private:
    struct Emitter {
        Vec3 corner[3], n;
        float area;
        Rgb radiance;
        float power; // brightness, as a share of the brightest part's
        float least; // its least height
        Vec3 middle() const { return (corner[0] + corner[1] + corner[2]) * (1 / 3.f); }
        // Maps the unit square evenly to the triangle.
        Vec3 point(float a, float b) const {
            if (a + b > 1) a = 1 - a, b = 1 - b;
            return corner[0] + (corner[1] - corner[0]) * a + (corner[2] - corner[0]) * b;
        }
        // Whether nothing lies between p and such a point.
        bool seen(const RayTree &tree, const Vec3 &p, float a, float b) const;
    };
    double emittingShare = 0;
    float brightest = 0;
    std::vector<Emitter> parts;
    std::vector<float> until;    // running sums of the parts' power
    std::vector<Emitter> wholes; // triangles that emit, undivided; empty if there are too many
    void divide(const Mesh &mesh, const Triangle &t, int samples, double largest);
    void sortParts(const Mesh &mesh);
    static float formFactor(const Emitter &part, const Vec3 &p, const Vec3 &n, float near);
    Rgb fromWholes(const RayTree &tree, const Vec3 *p, int places, const Vec3 &n, uint32_t seed,
                   int rays) const;
    Rgb fromParts(const RayTree &tree, const Vec3 &p, const Vec3 &n, uint32_t seed, float shift,
                  int some) const;
};

// The direct light of all visible texels: the mean over their places. `excluded` has a set bit for each of a
// site's places that does not count (ray_system.h).
std::vector<Rgb> directLight(const LampRays &lamps, const Surroundings &around, const LightGrid &grid,
                             const std::vector<uint16_t> &excluded, const RayTree &tree, Workers &workers);

} // namespace odraz::radiosity
