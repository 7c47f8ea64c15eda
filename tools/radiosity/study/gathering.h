// One gather of known light by hemicubes at some patches of a model. It isolates the effect of rasters,
// anti-aliasing and hemicubes at corners.
#pragma once

#include "tools/picture/picture.h"
#include "tools/radiosity/study/study.h"

namespace odraz::radiosity {

// The eye of a hemicube near corner k of a patch, a tenth of a side inside it. If the patch is partly hidden,
// the eye is in its middle.
Eye cornerEye(const Model &model, int patch, int k);

class Gathering {
public:
    // `divided`: a solution by patches, whose light is not used; it must outlive this. Up to `count` patches
    // gather.
    Gathering(Study &study, const Solved &divided, int count);

    size_t count() const { return patches.size(); }

    struct Result {
        MeshErrors errors;        // errors of the light that arrives at the patches
        double seconds;           // processor time per patch
        std::vector<float> light; // luminance of the light that arrives at each patch
    };
    // Gathers by `each` hemicubes at each patch: in its middle, rotated differently, or four at its corners.
    Result measure(int px, int each, bool corners);

    // The picture in a patch's hemicube, unfolded around its top face, by logarithmicTone().
    pictures::Image unfolded(int patch, int px);
    // The gathering patch that sees the largest number of patches.
    int patchSeeingMost();

private:
    Study &study;
    const Model &model;
    std::vector<int> patches;    // the gathering patches
    std::vector<Rgb> radiosity;  // radiosity of all patches in the reference
    std::vector<float> outside;  // luminance of the light from outside at the gathering patches
    std::vector<float> expected; // luminance of all light that arrives there in the reference
};

} // namespace odraz::radiosity
