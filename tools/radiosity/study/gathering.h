// One gather by hemicubes at some patches of a model, from known light, to measure the effect of rasters,
// anti-aliasing and hemicubes at corners alone.
#pragma once

#include "tools/picture/picture.h"
#include "tools/radiosity/study/study.h"

namespace odraz::radiosity {

// A hemicube's eye near corner k of a patch, a tenth of a side inside it; in the patch's middle if part of it
// is hidden.
Eye cornerEye(const Model &model, int patch, int k);

class Gathering {
public:
    // `divided`: from Study::divide(); it must outlive this. Up to `count` patches gather.
    Gathering(Study &study, const Solved &divided, int count);

    size_t count() const { return patches.size(); }

    // The hemicubes of a patch: one, several with different rotations, or four at its corners.
    struct Layout {
        int px, turns;
        bool corners;
    };
    struct Result {
        MeshErrors errors;        // of the light that arrives at the patches
        double seconds;           // of the processor, a patch
        std::vector<float> light; // luminance of the light that arrives at each
    };
    Result measure(const Layout &layout);

    // The picture in a patch's hemicube, unfolded: the top face with the half faces around it, in the tone of
    // logarithmicTone().
    pictures::Image unfolded(int patch, int px);
    // The gathering patch that sees the largest number of patches.
    int patchSeeingMost();

private:
    Study &study;
    const Model &model;
    std::vector<int> patches;    // that gather
    std::vector<Rgb> radiosity;  // of all patches, by the reference
    std::vector<float> outside;  // luminance of the light from outside at the gathering patches
    std::vector<float> expected; // luminance of all light that arrives there, by the reference
};

} // namespace odraz::radiosity
