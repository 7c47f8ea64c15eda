// Shooting, or progressive refinement: the patches with the most unshot light shoot first.
//
// A shooter is a patch, or a block of patches on one chart. It sends out the light that its patches received
// and have not shot yet, through one hemicube at one of them, chosen quasi-randomly by its share of that
// light. After a few hemicubes the picture is already good, only too dark. The light from patch i at patch j
// is B_i F_ji, and by reciprocity F_ji = F_ij A_i / A_j. Light is irradiance / pi and radiance, areas are in
// squared units of the model.
//
// Source: Cohen, Chen, Wallace and Greenberg, "A Progressive Refinement Approach to Fast Radiosity Image
// Generation", SIGGRAPH 1988; blocks of patches that shoot are its "patches", the receivers its "elements".
#pragma once

#include "tools/radiosity/patches/any_hemicube.h"

namespace odraz::radiosity {

// The groups of patches that shoot together.
using Shooters = std::vector<std::vector<int>>;

// Every patch that has an area shoots alone.
Shooters patchesAlone(const Model &model);
// About `count` blocks of equal area for patches that only reflect, and about `count` for patches that emit:
// their light is the brightest and should come from many points. `emits`: the emission of each patch.
Shooters blocksOfPatches(const Model &model, std::span<const Rgb> emits, int count);

class Shooting {
public:
    // For each patch: its emission, and the direct light, of which the reflected share is shot.
    Shooting(const Model &model, Shooters shooters, std::vector<Rgb> emits, std::vector<Rgb> direct);

    // The share of the initial light that is not shot yet, 1 .. 0; above 1 only if reflectances exceed 1.
    double left() const { return initialPower > 0 ? unshotPower / initialPower : 0; }
    // Up to `count` shooters that have light, the brightest first.
    std::vector<int> brightest(int count) const;

    // The light that a shooter sends out, and the patch that it comes from.
    struct Shot {
        int patch;
        Rgb power; // radiance times area
    };
    // Removes and returns the unshot light of a shooter.
    Shot nextShot(int shooter);
    // Shoots from up to `most` of the brightest shooters, by one picture of hemicubes. Returns their number;
    // 0: there is no light.
    int shoot(AnyHemicubes &hemicubes, int most, Workers &workers);
    // Distributes the light of one patch, `radiance`, by known form factors: links of its column, F_ji.
    void distribute(Rgb radiance, std::span<const Link> column);
    // An estimate of the missing light: the light that arrives if unshot light is spread evenly.
    Rgb ambient() const;

    // The light that shots have brought to each patch
    const std::vector<Rgb> &arrives() const { return arrived; }
    // The radiosity B of each patch: its reflected share of that light and of direct light
    std::vector<Rgb> radiosity() const;

private:
    const Model &model;
    Shooters shooters;
    std::vector<Rgb> direct, arrived, unshot;
    std::vector<int> shooterOf;
    std::vector<float> power; // unshot power of each shooter, all channels
    double initialPower = 0, unshotPower = 0;
    uint32_t shots = 0;
    float powerOf(int patch) const;
    void countPower(Workers &workers);
    // Distributes shots: rows[k][j] is the form factor from the patch of shot k to patch j.
    void distribute(std::span<const Shot> shots, const std::vector<std::vector<float>> &rows,
                    Workers &workers);
};

} // namespace odraz::radiosity
