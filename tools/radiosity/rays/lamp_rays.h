// Direct light on a mesh by shadow rays: from triangles that emit, from balls and from suns. The rays for
// indirect light find the sky's light (ray_system.h).
//
// If few triangles emit, the unshadowed light of each is given by its form factor: by Lambert's formula or,
// from afar, as a disc. Shadow rays to points on it, at least one, give the visible share.
//
// If many emit, they are divided into parts. Each sample point of a texel casts rays to some of the parts,
// chosen by power and spread over space. The points of one texel, or of a small polygon, share the rays.
#pragma once

#include "tools/radiosity/rays/light_grid.h"
#include "tools/radiosity/read/surroundings.h"

namespace odraz::radiosity {

// If more than this share of a model's area emits, the rays for indirect light find its light.
inline constexpr double kLargeLamps = 0.25;

class LampRays {
public:
    // Up to kFewLamps emitting triangles are used whole, more than kMostWhole always in parts; between these,
    // the number of rays decides. A site's points share up to kMostRays rays to parts, at least one each.
    static constexpr int kMostRays = 128, kFewLamps = 32, kMostWhole = 256;

    // Divides the largest emitting polygon into about `samples` parts.
    LampRays(const Mesh &mesh, const Regions &regions, int samples);
    bool none() const { return parts.empty(); }
    double share() const { return emittingShare; } // the part of the model's area that emits
    void clear() { parts.clear(), sums.clear(), wholes.clear(); }

    // The sample points of a texel, from which rays are cast.
    struct Receiver {
        Vec3 p[4], n;
        int count;     // points, 1 .. 4
        uint32_t seed; // different for each texel
        int sharers;   // points of the site, which share its rays to parts
        float shift;   // selects this texel's share of them, 0 .. 1
    };
    // The mean light at the points of a texel, as irradiance / pi.
    Rgb at(const RayTree &tree, const Surroundings &surroundings, const Receiver &receiver) const;

private:
    struct Emitter { // a triangle that emits, or a part of one
        Vec3 corner[3], n;
        float area;
        Rgb radiance;
        float power;  // luminance, as a share of the brightest emitter's
        float height; // least of its three heights
        Vec3 middle() const { return (corner[0] + corner[1] + corner[2]) * (1 / 3.f); }
        // Maps the unit square evenly to the triangle.
        Vec3 point(float a, float b) const {
            if (a + b > 1) a = 1 - a, b = 1 - b;
            return corner[0] + (corner[1] - corner[0]) * a + (corner[2] - corner[0]) * b;
        }
        // Whether nothing lies between p and point(a, b).
        bool visible(const RayTree &tree, const Vec3 &p, float a, float b) const;
    };
    double emittingShare = 0;
    float brightest = 0;
    std::vector<Emitter> parts;
    std::vector<float> sums;     // running sums of the parts' power
    std::vector<Emitter> wholes; // triangles that emit, undivided; empty if there are too many
    void divide(const Mesh &mesh, const Triangle &t, int samples, double largest);
    void sortParts(const Mesh &mesh);
    static float formFactor(const Emitter &e, const Vec3 &p, const Vec3 &n, float near);
    Rgb fromWholes(const RayTree &tree, const Receiver &receiver, int rays) const;
    Rgb fromParts(const RayTree &tree, const Vec3 &p, const Vec3 &n, uint32_t seed, float shift,
                  int rays) const;
};

// The direct light of all visible texels: the mean over their sample points. `excluded` has a set bit for
// each point of a site that does not count (ray_system.h).
std::vector<Rgb> directLight(const LampRays &lamps, const Surroundings &surroundings, const LightGrid &grid,
                             const std::vector<uint16_t> &excluded, Workers &workers);

} // namespace odraz::radiosity
