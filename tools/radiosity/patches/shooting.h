// Shooting, or progressive refinement: the patches with most unshot light shoot first.
//
// A shooter is a patch, or a block of patches on one chart. It sends out the light that its patches received
// and have not shot yet, through one hemicube at one of them, chosen at random by its share of that light. So
// few hemicubes give a good picture, only too dark. The light from patch i at patch j is B_i F_ji, and by
// reciprocity F_ji = F_ij A_i / A_j. Light is irradiance / pi and radiance, areas are in squared units of the
// model.
//
// Source: Cohen, Chen, Wallace and Greenberg, "A Progressive Refinement Approach to Fast Radiosity Image
// Generation", SIGGRAPH 1988; blocks of patches that shoot are its "patches", the receivers its "elements".
#pragma once

#include "tools/radiosity/patches/odd_hemicube.h"

namespace odraz::radiosity {

// The groups of patches that shoot together.
struct Shooters {
    std::vector<int> patches;  // those of shooter 0, then of shooter 1 ..
    std::vector<size_t> first; // where each shooter's begin, and the end of the last

    size_t count() const { return first.size() - 1; }
    std::span<const int> of(int shooter) const {
        size_t from = first[(size_t)shooter];
        return {patches.data() + from, first[(size_t)shooter + 1] - from};
    }
};

// Every patch that has an area shoots alone.
Shooters patchesAlone(const Model &model);
// About `count` blocks of equal area, and about `count` more of the patches that emit, because their light is
// the brightest and should come from many places. `emits`: of each patch.
Shooters blocksOfPatches(const Model &model, std::span<const Rgb> emits, int count);

class Shooting {
public:
    // `emits`: the emission, which is shot first; `direct`: light that arrives otherwise, of which the
    // reflected share is shot. Both have an item for each patch.
    Shooting(const Model &model, Shooters shooters, std::vector<Rgb> emits, std::vector<Rgb> direct);

    // The share of the initial light that is not shot yet: 1 at the beginning. It exceeds 1 only if
    // reflectances do.
    double left() const { return put > 0 ? unshotPower / put : 0; }
    // Up to `count` shooters that have light, in descending order of it.
    std::vector<int> brightest(int count) const;

    // The light that a shooter sends out, and the patch that it leaves.
    struct Shot {
        int patch;
        Rgb power; // radiance times area
    };
    // Takes the unshot light of a shooter, and leaves it none.
    Shot take(int shooter);
    // Distributes shots through hemicubes: rows[k][j] is the form factor from the patch of shot k to patch j.
    void distribute(std::span<const Shot> shots, const std::vector<std::vector<float>> &rows,
                    Workers &workers);
    // Distributes the light of one patch, `radiance`, by known form factors: links of its column, F_ji.
    void distribute(Rgb radiance, std::span<const Link> column);
    // The light that would arrive everywhere if unshot light were spread evenly: an estimate of the light
    // that is missing at the end.
    Rgb ambient() const;

    // The light that the shots so far brought to each patch
    const std::vector<Rgb> &arrives() const { return arrived; }
    // The light that a patch reflects of that and of direct light: B
    Rgb radiosity(int patch) const;

private:
    const Model &model;
    Shooters shooters;
    std::vector<Rgb> direct, arrived, unshot;
    std::vector<int> shooterOf;
    std::vector<float> power; // of each shooter, all channels
    double put = 0, unshotPower = 0;
    uint32_t shots = 0;
    float powerOf(int patch) const;
    void countPower(Workers &workers);
};

// The columns of a system: links[first[i]] .. are F_ji, the shares of patch i in the rows of all patches.
struct Columns {
    std::vector<Link> links;
    std::vector<size_t> first;

    explicit Columns(const FormFactorRows &rows);
    std::span<const Link> of(int patch) const {
        size_t from = first[(size_t)patch];
        return {links.data() + from, first[(size_t)patch + 1] - from};
    }
};

// Shoots by hemicubes.
class HemicubeShooter {
public:
    // Throws std::runtime_error if OpenGL cannot draw them.
    HemicubeShooter(const Gl &gl, const Model &model, int px) : model(model), hemicubes(gl, px) {}
    // The largest number of shots in one picture.
    int batch() const { return hemicubes.h.batch; }
    // Shoots once from up to `most` of the brightest shooters, all in one picture. Returns their number; 0:
    // no light is left.
    int shoot(Shooting &shooting, int most, Workers &workers);

private:
    const Model &model;
    AnyHemicubes hemicubes;
    uint32_t number = 0; // of the next hemicube, which determines its rotation
};

} // namespace odraz::radiosity
