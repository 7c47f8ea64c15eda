// Shooting, or progressive refinement: where most light waits to be sent out, it is sent out first.
//
// A shooter is a patch, or a block of them on one chart. It sends out the light that its patches received and
// did not send on yet, through one hemicube at one of them; which one is drawn by its share of that light. So
// light is right after few hemicubes, only darker than it will be. What arrives at patch j from patch i is
// B_i F_ji, and by reciprocity F_ji = F_ij A_i / A_j. Light is irradiance / pi and radiance, areas are in
// squared units of the model.
//
// Source: Cohen, Chen, Wallace and Greenberg, "A Progressive Refinement Approach to Fast Radiosity Image
// Generation", SIGGRAPH 1988; blocks of patches that shoot are its "patches", what receives its "elements".
#pragma once

#include "radiosity/form_factor.h"

#include <span>
#include <vector>

namespace odraz::radiosity {

// Which patches shoot together.
struct Shooters {
    std::vector<int> patches;  // of shooter 0, then of shooter 1 ..
    std::vector<size_t> first; // where those of each shooter begin, and the end of the last

    size_t count() const { return first.size() - 1; }
    std::span<const int> of(int shooter) const {
        size_t from = first[(size_t)shooter];
        return {patches.data() + from, first[(size_t)shooter + 1] - from};
    }
};

// Every patch that has an area shoots alone.
Shooters patchesAlone(const Model &model);
// About `count` blocks of equal area; as many again of the patches that emit, so that their light, which is
// the brightest, comes from many places. `emits`: of each patch.
Shooters blocksOfPatches(const Model &model, std::span<const Rgb> emits, int count);

class Shooting {
public:
    // `emits`: what patches emit and shoot first; `direct`: light that arrives by other ways, which they
    // reflect. Both have an item for each patch.
    Shooting(const Model &model, Shooters shooters, std::vector<Rgb> emits, std::vector<Rgb> direct);

    // The share of the light put in that is not shot yet: 1 at the beginning. Above 1 only if reflectances
    // are.
    double left() const { return put > 0 ? unshotPower / put : 0; }
    // Up to `count` shooters that have light, those with most first.
    std::vector<int> brightest(int count) const;

    // A shot: what a shooter sends out, and from where.
    struct Shot {
        int patch;
        Rgb power; // radiance times area
    };
    // Takes the light of a shooter, which is unshot no longer.
    Shot take(int shooter);
    // Hands out shots through hemicubes: rows[k][j] is the form factor from the patch of shot k to patch j.
    void handOut(std::span<const Shot> shots, std::span<const float *const> rows, Workers &workers);
    // Hands out the light of one patch, `radiance`, where form factors are known: links of its column, F_ji.
    void handOut(Rgb radiance, std::span<const Link> column);
    // The light that would arrive everywhere if what is unshot were spread evenly: an estimate of what is
    // still missing, for the end.
    Rgb ambient() const;

    // What arrives at each patch by the shots so far
    const std::vector<Rgb> &arrives() const { return arrived; }
    // What each patch reflects of that and of the direct light: B
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

// The columns of a system: links[first[i]] .. are F_ji, the shares of patch i in the rows of others.
struct Columns {
    std::vector<Link> links;
    std::vector<size_t> first;

    Columns(const FormFactors &factors, int patches);
    std::span<const Link> of(int patch) const {
        size_t from = first[(size_t)patch];
        return {links.data() + from, first[(size_t)patch + 1] - from};
    }
};

// Draws the hemicubes of shots. It keeps what it needs on the heap.
class HemicubeShooter {
public:
    // Throws std::runtime_error if OpenGL cannot do it. `turn` rotates all hemicubes differently.
    HemicubeShooter(const Gl &gl, const Model &model, int px, uint32_t turn);
    HemicubeShooter(const HemicubeShooter &) = delete;
    ~HemicubeShooter();
    // The most shots in one picture.
    int batch() const { return hemicubes.batch; }
    // Shoots once from up to `most` of the brightest shooters, all in one picture. Returns how many; 0: no
    // light is left.
    int shoot(Shooting &shooting, int most, Workers &workers);

private:
    const Model &model;
    std::vector<unsigned char> memory;
    Hemicubes hemicubes;
    std::vector<float> sums;
    std::vector<std::vector<float>> rows;
    uint32_t number; // of the next hemicube: it sets its rotation
};

} // namespace odraz::radiosity
